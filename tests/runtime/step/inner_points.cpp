// SPDX-License-Identifier: BSL-1.0
// Steps with control values inside them are solutions of the equation that their operators derive: Galerkin's, and those of embeddings of
// one's own that no library has a name for; in any dimension, with forces, times and gyroscopic terms, exactly in the rationals.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "runtime/embedding/radau.hpp"
#include "runtime/step/exact_steps.hpp"
#include "runtime/trajectory/resuming.hpp"
#include "support/orders.hpp"

namespace inner_points_tests {

using namespace hilger;
using testing::radau_galerkin;

namespace {

/// Position-dependent masses, a gyroscopic term and a potential that is no polynomial.
constexpr auto general = [](auto const& q, auto const& v) {
    auto const d = q.size();
    return (2 + cos(q(0))) * v.squaredNorm() / 2 + q(0) * v(d - 1) - q.squaredNorm() / 2 - q(0) * q(0) * q(d - 1);
};
constexpr auto pendulum = [](auto const& q, auto const& v) { return v * v / 2 - (1 - cos(q)); };
constexpr auto friction = [](auto const& t, auto const& q, auto const& v) { return -v * v * v / 5 + sin(t) - q / 7; };

/// The same numbers in another type: no library knows it, so it is stepped by its tableau alone.
template <class E>
constexpr auto by_tableau(E const& e) {
    return make_embedding<step_weight>(fraction<1>{} * e.position, e.velocity, "the same");
}
/// Orders of one on the points of T/2: mean positions and differences there, two steps of half the length each.
constexpr auto halves = [] {
    constexpr identity_on<subdivided<2>, delta_weight> here{};
    return make_embedding<delta_weight>(fraction<1, 2>{} * (here + sigma_o), Delta_o_plus, "two mid-points");
}();

/// The rows of the equation at the points of T/d are of the size m q d^2 / h^2 + p d / h, times the sum of |l_j'|, which is below 2^d.
template <class Path>
void is_a_solution(Path const& path, int degree) {
    using S = decltype((*path.begin()).t);
    S q(0), p(0);
    for (auto const& x : path) {
        q = std::max(q, S(magnitude(x.q)));
        p = std::max(p, S(magnitude(x.p)));
    }
    S const h = path.scale().root().step(0);
    auto const residual = largest_residual(path);
    S const d(degree), power(1 << degree), bound = S(32) * epsilon<S>() * (d * p / h + S(3) * d * d * power * q / (h * h));
    CAPTURE(residual);
    CAPTURE(bound);
    CHECK(residual <= bound);
    CHECK(q > S(0.1));
}
template <class S, class E>
void solves(E const& e, int degree) {
    CAPTURE(e.name);
    is_a_solution(embed(with_force(pendulum, friction), e).along(uniform(S(0), S(1) / S(10), 30), S(1), S(0)), degree);
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
    solves<double>(galerkin<1, gauss>, 1);
    solves<double>(galerkin<2, gauss>, 2);
    solves<double>(galerkin<3, gauss>, 3);
    solves<double>(galerkin<4, gauss>, 4);
    solves<double>(galerkin<2, lobatto>, 1);
    solves<double>(galerkin<3, lobatto>, 2);
    solves<double>(galerkin<4, lobatto>, 3);
    solves<float50>(galerkin<3, gauss>, 3);
    // without a force it is the forces at the nodes that are iterated
    is_a_solution(embed(pendulum, galerkin<3, gauss>).along(uniform(0.0, 0.1, 30), 1.0, 0.0), 3);
}

TEST_CASE("embeddings of one's own with points inside the steps do") {
    solves<double>(radau_galerkin, 2);
    solves<double>(by_tableau(galerkin<3, gauss>), 3);
    solves<double>(halves, 2);
}

TEST_CASE("in any dimension") {
    solves_in<1>(galerkin<2, gauss>, 2);
    solves_in<2>(galerkin<3, lobatto>, 2);
    solves_in<3>(radau_galerkin, 2);
    solves_in<6>(galerkin<2, gauss>, 2);
    solves_in<Eigen::Dynamic>(galerkin<3, gauss>, 3, 5);
}

TEST_CASE("two mid-point steps of half the length are one embedding with a point inside") {
    // as an embedding of T, and as mid-point on T/2
    auto const T = uniform(0.0, 0.2, 20), fine = uniform(0.0, 0.1, 40);
    auto const twice = embed(pendulum, mid_point).along(fine, 1.0, 0.0);
    auto x = twice.begin();
    for (auto const& y : embed(pendulum, halves).along(T, 1.0, 0.0)) {
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
    same(pendulum, galerkin<2, gauss>, 1.0, 0.0);
    same(pendulum, galerkin<4, lobatto>, 1.0, 0.0);
    // a lambda over vectors of any size, and a chain that is known to be one
    int const n = 12;
    auto const chain = [](auto const& q, auto const& v) {
        auto sum = v.squaredNorm() / 2 - q(0) * q(0) / 2 - q(q.size() - 1) * q(q.size() - 1) / 2;
        for (int k = 1; k < q.size(); ++k) sum = sum - pow(q(k) - q(k - 1), 2) / 2;
        return sum;
    };
    Eigen::VectorXd const q = Eigen::VectorXd::LinSpaced(n, 0, 1), p = Eigen::VectorXd::Zero(n);
    same(chain, galerkin<2, gauss>, q, p);
    auto const springs = Eigen::MatrixXd([&] {
        Eigen::MatrixXd K = 2 * Eigen::MatrixXd::Identity(n, n);
        for (int k = 1; k < n; ++k) K(k, k - 1) = K(k - 1, k) = -1;
        return K;
    }());
    auto const matrix = [&springs](auto const& x, auto const& v) {
        auto sum = v.squaredNorm() / 2;
        for (int j = 0; j < x.size(); ++j)
            for (int k = 0; k < x.size(); ++k) sum = sum - springs(j, k) * x(j) * x(k) / 2;
        return sum;
    };
    auto const path = embed(chain, galerkin<3, gauss>).along(T, q, p);
    auto x = path.begin();
    for (auto const& y : embed(matrix, by_tableau(galerkin<3, gauss>)).along(T, q, p)) {
        CHECK((x->q - y.q).norm() <= 400 * epsilon<double>());
        ++x;
    }
}

TEST_CASE("in the rationals the equation holds exactly, at the points of T and inside") {
    using testing::driven;
    auto const T = uniform(Q(0), Q(1, 5), 4);
    CHECK(largest_residual(embed(driven, galerkin<3, lobatto>).along(T, Q(1), Q(1, 2))) == 0);
    CHECK(largest_residual(embed(driven, radau_galerkin).along(T, Q(1), Q(1, 2))) == 0);
    CHECK(largest_residual(embed(driven, halves).along(T, Q(1), Q(1, 2))) == 0);
    // and on uneven steps
    auto const uneven = time_scale(std::vector{Q(0), Q(1, 5), Q(1, 3), Q(1)});
    lagrangian const L = [](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; };
    constexpr unknown<"q", subdivided<2>> q;
    auto const EL = variation(integral(L(radau_galerkin.position[q], radau_galerkin.velocity[q]), at_nodes<testing::radau, 2>(uneven)));
    auto const x = solve(EL, uneven, {.q0 = Q(1), .v0 = Q(0)});
    CHECK(x.size() == 7);
    CHECK(x.get(0) == 1);
    CHECK(x.get(1) != x.get(0));
    CHECK(largest_residual(EL, x) == 0);
}

TEST_CASE("adjoints undo steps of -h, and those of symmetric nodes are themselves") {
    CHECK(testing::undoes(embed(testing::driven, radau_galerkin)));
    CHECK(testing::undoes(embed(testing::driven, halves)));
    CHECK(testing::steps_as(adjoint(embed(testing::driven, galerkin<3, lobatto>)), embed(testing::driven, galerkin<3, lobatto>)));
    CHECK_FALSE(testing::steps_as(adjoint(embed(testing::driven, radau_galerkin)), embed(testing::driven, radau_galerkin)));
}

TEST_CASE("steps are symplectic") {
    auto const one = [](auto const& e, auto const& q, auto const& p) {
        auto const J = jacobian_of_step(embed(general, e), state<float50, std::remove_cvref_t<decltype(q)>>{0, q, p}, float50(1) / 10);
        return symplecticity_error(J);
    };
    using V = Eigen::Matrix<float50, 2, 1>;
    V const q(float50(3) / 10, float50(1) / 5), p(float50(0), float50(1) / 10);
    // differences of steps in 50 digits
    CHECK(one(radau_galerkin, q, p) < 1e-20);
    CHECK(one(galerkin<3, gauss>, q, p) < 1e-20);
}

TEST_CASE("quadratic polynomials at two Radau nodes have order 3") {
    auto const end = [](auto const& how, int n) {
        auto const path = embed(pendulum, how).along(uniform(interval<float50>{0, 1}, n), float50(1), float50(0));
        auto last = *path.begin();
        for (auto const& x : path) last = x;
        return last.q;
    };
    float50 const reference = end(galerkin<6, gauss>, 20);
    CHECK(std::abs(testing::order_of(float50(end(radau_galerkin, 40) - reference), float50(end(radau_galerkin, 80) - reference)) - 3) <
          0.02);
    CHECK(std::abs(testing::order_of(float50(end(halves, 40) - reference), float50(end(halves, 80) - reference)) - 2) < 0.02);
}

TEST_CASE("runs that are stopped and read back go on as they would have") {
    CHECK(testing::differences(testing::pendulum_path<double>(embed(pendulum, radau_galerkin), 30), 7) == 0);
    CHECK(testing::differences(testing::pendulum_path<double>(embed(with_force(pendulum, friction), galerkin<3, gauss>), 30), 11) == 0);
    CHECK(testing::differences(testing::pendulum_path<double>(embed(pendulum, by_tableau(galerkin<2, gauss>), compensated), 30), 12) == 0);
}

} // namespace inner_points_tests
