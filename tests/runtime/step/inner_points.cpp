// SPDX-License-Identifier: BSL-1.0
// Steps with control values inside them are solutions of the equation that their operators derive: Galerkin's, and those of embeddings of
// one's own that no library has a name for; in any dimension, with forces, times and gyroscopic terms.
#include <cmath>

#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "runtime/embedding/radau.hpp"
#include "runtime/step/embeddings_inside.hpp"

namespace inner_points_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// The rows of the equation at the points of T/d are of the size m q d^2 / h^2 + p d / h, times the sum of |l_j'|, which is below 2^d.
template <class Path>
auto rounding_of(Path const& path, int degree) {
    using S = decltype((*path.begin()).t);
    S q(0), p(0);
    for (auto const& x : path) {
        q = std::max(q, S(magnitude(x.q)));
        p = std::max(p, S(magnitude(x.p)));
    }
    CHECK(q > S(0.1));
    S const h = path.scale().root().step(0), d(degree), power(1 << degree);
    return S(S(32) * epsilon<S>() * (d * p / h + S(3) * d * d * power * q / (h * h)));
}
template <class Path>
void is_a_solution(Path const& path, int degree) {
    auto const residual = largest_residual(path), bound = rounding_of(path, degree);
    CAPTURE(residual);
    CAPTURE(bound);
    CHECK(residual <= bound);
}
template <class S, class E>
void solves(E const& e, int degree) {
    CAPTURE(e.name);
    is_a_solution(embed(with_force(swing, friction), e).along(uniform(S(0), S(1) / S(10), 30), S(1), S(0)), degree);
}
template <int Size, class E>
void solves_in(E const& e, int degree, int d = Size) {
    CAPTURE(e.name);
    using V = Eigen::Matrix<double, Size, 1>;
    V const q = V::Constant(d, 0.3), p = V::LinSpaced(d, 0.1, 0.5);
    is_a_solution(embed(general, e).along(uniform(0.0, 0.1, 30), q, p), degree);
}

} // namespace

TEST_CASE("Galerkin embeddings solve the equation of their operators") {
    solves<double>(galerkin<2, gauss>, 2);
    solves<double>(galerkin<3, gauss>, 3);
    solves<double>(galerkin<4, gauss>, 4);
    solves<double>(galerkin<2, lobatto>, 1);
    solves<double>(galerkin<3, lobatto>, 2);
    solves<double>(galerkin<4, lobatto>, 3);
    solves<float50>(galerkin<3, gauss>, 3);
    // without a force it is the forces at the nodes that are iterated
    is_a_solution(embed(swing, galerkin<3, gauss>).along(uniform(0.0, 0.1, 30), 1.0, 0.0), 3);
}

TEST_CASE("in steps so long that the ends have several solutions between them, those of the step are judged") {
    auto const two_wells = [](auto const& q, auto const& v) {
        auto const w = q * q - 1;
        return v * v / 2 - 50 * w * w;
    };
    auto const drag = [](auto const&, auto const& v) { return plain_t<decltype(v / 8)>(-v / 8); };
    // by the forces at the nodes, and by the equation of the step
    auto const lead = [&](auto const& how, double h, double q, double v, int degree) {
        auto const T = uniform(0.0, h, 20);
        auto const path = embed(two_wells, how).along(T, initial_velocity{q, v});
        is_a_solution(path, degree);
        is_a_solution(embed(with_force(two_wells, drag), how).along(T, initial_velocity{q, v}), degree);
        // so are states that were kept, and the function that solve returns
        CHECK(largest_residual(path.method(), record(path)) == largest_residual(path));
        auto const EL = equation_of(path.method(), T);
        CHECK(largest_residual(EL, solve(EL, T, initial_velocity{q, v})) == largest_residual(path));
    };
    lead(galerkin<2, gauss>, 0.177, 0.18, -0.42, 2);
    lead(galerkin<3, lobatto>, 0.1, -0.314144, -2.06111, 2);
    lead(galerkin<4, gauss>, 0.1, -1.49231, 2.82889, 4);
    auto const path = embed(two_wells, galerkin<2, gauss>).along(uniform(0.0, 0.177, 20), initial_velocity{0.18, -0.42});
    CHECK_THROWS_WITH_AS((void)largest_residual(path.method(), record(path, 2)),
                         "a recording is judged that has a state at each point of T = {0, 0.17699999999999999, 0.35399999999999998, ..., "
                         "3.54} (21 points), and this one has 11",
                         error::mismatch);
}

TEST_CASE("where the momenta are of no walk, the positions say what is inside") {
    auto const path = embed(with_force(swing, friction), galerkin<3, gauss>).along(uniform(0.0, 0.1, 30), 1.0, 0.0);
    auto states = record(path);
    CHECK(largest_residual(path.method(), states.positions()) <= rounding_of(path, 3));
    for (auto& x : states.states) x.p = x.p + 1;
    CHECK(largest_residual(path.method(), states) <= rounding_of(path, 3));
}

TEST_CASE("embeddings of one's own with points inside the steps do") {
    solves<double>(radau_galerkin, 2);
    solves<double>(by_tableau(galerkin<3, gauss>), 3);
    solves<double>(two_mid_points, 2);
    // without a force, where Galerkin embeddings that are exact enough iterate the forces at the nodes
    auto const T = uniform(0.0, 0.1, 30);
    is_a_solution(embed(swing, radau_galerkin).along(T, 1.0, 0.0), 2);
    is_a_solution(embed(swing, trapezoid_galerkin).along(T, 1.0, 0.0), 2);
    is_a_solution(embed(swing, too_steep).along(T, 1.0, 0.0), 2);
}

TEST_CASE("masses that change with the time are not constant") {
    auto const melting = [](double t, auto const& q, auto const& v) { return (2 + std::sin(3 * t)) * v * v / 2 - q * q / 2; };
    auto const T = uniform(0.0, 0.1, 30);
    is_a_solution(embed(melting, galerkin<2, gauss>).along(T, 1.0, 0.0), 2);
    is_a_solution(embed(melting, galerkin<2, lobatto>).along(T, 1.0, 0.0), 1);
}

TEST_CASE("in any dimension") {
    solves_in<2>(galerkin<3, lobatto>, 2);
    solves_in<3>(radau_galerkin, 2);
    solves_in<6>(galerkin<2, gauss>, 2);
    solves_in<Eigen::Dynamic>(galerkin<3, gauss>, 3, 5);
}

TEST_CASE("two mid-point steps of half the length are one embedding with a point inside") {
    // as an embedding of T, and as mid-point on T/2
    auto const T = uniform(0.0, 0.2, 20), fine = uniform(0.0, 0.1, 40);
    auto const twice = embed(swing, mid_point).along(fine, 1.0, 0.0);
    auto x = twice.begin();
    for (auto const& y : embed(swing, two_mid_points).along(T, 1.0, 0.0)) {
        CHECK(std::abs(x->q - y.q) <= 100 * epsilon<double>());
        CHECK(std::abs(x->p - y.p) <= 100 * epsilon<double>());
        if (++x != twice.end()) ++x;
    }
}

TEST_CASE("whoever steps it, a Galerkin step is the same") {
    auto const T = uniform(0.0, 0.1, 40);
    auto const same = [&](auto const& L, auto const& e, auto const& q, auto const& p) {
        auto const path = embed(L, e).along(T, q, p);
        auto x = path.begin();
        for (auto const& y : embed(L, by_tableau(e)).along(T, q, p)) {
            CHECK(magnitude(plain_t<decltype(y.q)>(x->q - y.q)) <= 200 * epsilon<double>());
            ++x;
        }
    };
    same(swing, galerkin<2, gauss>, 1.0, 0.0);
    // a lambda over vectors of any size, and a chain that is known to be one
    int const n = 12;
    auto const chain = [](auto const& q, auto const& v) {
        auto sum = v.squaredNorm() / 2 - q(0) * q(0) / 2 - q(q.size() - 1) * q(q.size() - 1) / 2;
        for (int k = 1; k < q.size(); ++k) sum = sum - pow(q(k) - q(k - 1), 2) / 2;
        return sum;
    };
    Eigen::VectorXd const q = Eigen::VectorXd::LinSpaced(n, 0, 1), p = Eigen::VectorXd::Zero(n);
    same(chain, galerkin<2, gauss>, q, p);
}

TEST_CASE("with a constant mass corrections ask for gradients alone, and these have the force") {
    auto const in_a_plane = [](auto const& x, auto const& v) { return v.dot(v) / 2 - x.dot(x) / 2 - x(0) * x(0) * x(1) * x(1); };
    auto const drag = [](auto const& x, auto const& v) { return plain_t<decltype(x + v)>(x / 7 - v / 3); };
    auto const solve_with_drag = [&](auto const& e, int degree) {
        is_a_solution(
            embed(with_force(in_a_plane, drag), e).along(uniform(0.0, 0.1, 30), Eigen::Vector2d(0.3, 0.4), Eigen::Vector2d(0.5, -0.2)),
            degree);
    };
    solve_with_drag(galerkin<2, gauss>, 2);
    solve_with_drag(galerkin<3, lobatto>, 2);
}

} // namespace inner_points_tests
