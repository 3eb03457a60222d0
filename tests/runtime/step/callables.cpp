// SPDX-License-Identifier: BSL-1.0
// Callables whose results are Eigen expressions: an expression refers to the arguments, or to copies of them where the callable takes them
// by value, and is read while they live. The tests run under the sanitizers, too.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"

namespace callables_tests {

using namespace hilger;

namespace {

struct oscillator {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        return v.squaredNorm() / 2 - q.squaredNorm() / 2;
    }
};
struct by_reference {
    template <class X, class Y>
    auto operator()(X const&, Y const& v) const {
        return -0.2 * v;
    }
};
struct by_value {
    template <class X, class Y>
    auto operator()(X, Y v) const {
        return -0.2 * v;
    }
};
struct with_the_time {
    template <class T, class X, class Y>
    auto operator()(T const&, X, Y v) const {
        return -0.2 * v;
    }
};
/// The same, already a state.
struct evaluated_force {
    template <class X, class Y>
    Y operator()(X const&, Y const& v) const {
        return -0.2 * v;
    }
};

template <class V, class Force, class E>
state<double, V> last_of(Force const& force, E const& how) {
    V q(2), v(2);
    q << 1, 0.5;
    v << 0, 0.2;
    auto const path = embed(with_force(oscillator{}, force), how).along(uniform(0.0, 0.1, 50), initial_velocity<V>{q, v});
    state<double, V> last = *path.begin();
    for (auto const& x : path) last = x;
    return last;
}
template <class V, class E>
void check_forces(E const& how) {
    auto const right = last_of<V>(evaluated_force{}, how);
    CHECK(last_of<V>(by_reference{}, how) == right);
    CHECK(last_of<V>(by_value{}, how) == right);
    CHECK(last_of<V>(with_the_time{}, how) == right);
}

} // namespace

TEST_CASE("forces that are expressions in vectors of dynamic size") {
    check_forces<Eigen::VectorXd>(mid_point);
    check_forces<Eigen::VectorXd>(galerkin<2, gauss>);
    auto const x = last_of<Eigen::VectorXd>(by_reference{}, mid_point); // another program's numbers
    CHECK(x.q(0) == doctest::Approx(0.09628).epsilon(1e-4));
    CHECK(x.q(1) == doctest::Approx(-0.06987).epsilon(1e-4));
}
TEST_CASE("forces that are expressions in vectors of fixed size") { check_forces<Eigen::Vector2d>(mid_point); }
TEST_CASE("the residual with a force that is an expression") {
    constexpr unknown q;
    constexpr auto q_o = extend[q];
    lagrangian const L(oscillator{});
    auto const T = uniform(0.0, 0.1, 20);
    auto const EL = variation(integral(L(q_o, Delta_o_plus[q_o]), half(T)));
    std::vector<Eigen::VectorXd> positions;
    Eigen::VectorXd const q0 = Eigen::Vector2d(1, 0.5);
    for (auto const& x : embed(with_force(L, by_value{}), mid_point).along(T, q0, q0)) positions.push_back(x.q);
    for (auto const& r : EL.residual(function_on(T, positions), by_value{})) CHECK(magnitude(r) < 1e-12);
}
TEST_CASE("a force that is a constant") {
    auto const L = [](auto const&, auto const& v) { return v * v / 2; };
    auto const path = embed(with_force(L, [](auto const&, auto const&) { return 2.0; }), mid_point).along(uniform(0.0, 0.125, 8), 0.0, 0.0);
    for (auto const& x : path) CHECK(x.q == x.t * x.t);
}
TEST_CASE("functions, maps, quantities and loads that are expressions") {
    auto const T = uniform(0.0, 0.25, 8);
    Eigen::VectorXd const w = Eigen::Vector2d(1, 2);
    auto const f = function_on(T, [&w](double t) { return w * t; });
    auto const g = apply_pointwise([](auto x, auto y) { return x + 2 * y; }, f, f);
    for (index_type i = 0; i <= 8; ++i) CHECK(g.get(i) == Eigen::VectorXd(w * (3 * T.element(i))));
    auto const flow = embed(oscillator{}, mid_point);
    auto const path = flow.along(T, w, w);
    auto const turn = momentum_map([](auto q) { return 0 * q; });
    CHECK(drift_along(path, turn).largest == 0);
    auto const passes = [](auto const& x) { return (x.q - x.p)(0); };
    for (auto const& x : events(path, passes)) CHECK(std::abs(x.q(0) - x.p(0)) < 1e-12);
    Eigen::Matrix2d const M = Eigen::Matrix2d::Identity(), zero = Eigen::Matrix2d::Zero();
    auto const load = [&w](double) { return 2 * w; };
    auto const scheme = newmark<bdf<2>>(fractional_structure{M, zero, zero, 1.0, fraction<1, 2>{}}, load);
    for (auto const& x : scheme.along(T, Eigen::Vector2d(0, 0), Eigen::Vector2d(0, 0)))
        CHECK(magnitude(Eigen::Vector2d(x.q - w * (x.t * x.t))) < 1e-14);
}
TEST_CASE("energies and Hamiltonians of arguments by value") {
    auto const energy_of_two = [](index_type, auto r) { return r * r / 2; };
    Eigen::VectorXd const q0 = Eigen::Vector3d(1, 0, -1), p0 = Eigen::Vector3d(0, 1, 0);
    mechanical const L(1.0, chain{energy_of_two});
    auto const H = lagrangian_of([](auto p, auto q) { return p.squaredNorm() / 2 + q.squaredNorm() / 2; });
    for (auto const& x : embed(L, mid_point).along(uniform(0.0, 0.1, 20), q0, p0)) CHECK(is_finite(x.q));
    double apart = 0;
    auto other = embed(oscillator{}, mid_point).along(uniform(0.0, 0.1, 20), q0, p0);
    auto at = other.begin();
    for (auto const& x : embed(H, mid_point).along(uniform(0.0, 0.1, 20), q0, p0)) {
        apart = std::max(apart, magnitude(Eigen::VectorXd(x.q - at->q)));
        ++at;
    }
    CHECK(apart < 1e-13);
}

} // namespace callables_tests
