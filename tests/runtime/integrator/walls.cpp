// SPDX-License-Identifier: BSL-1.0
// Where a Lagrangian or a derivative of it is no number: a step stops there, and goes on where a force is one all the same.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"

namespace walls_tests {

using namespace hilger;

namespace {

template <class Path>
auto last_of(Path const& path) {
    return record(path).states.back().q;
}

} // namespace

TEST_CASE("a fast body stops at the wall of a logarithm, beyond which its slope alone would still be a number") {
    auto const stops_after = [&](int right, auto const& L, auto const& e, auto const& q0, auto const& p0) {
        int steps = -1; // the first one lands beyond the wall, where order one has not evaluated L yet
        CHECK_THROWS_AS(
            [&] {
                for ([[maybe_unused]] auto const& at : embed(lagrangian{L}, e).along(uniform(0.0, 0.25, 40), q0, p0)) ++steps;
            }(),
            error::not_finite);
        CHECK(steps == right);
    };
    auto const behind_log = [](auto const& x, auto const& v) { return v * v / 2 + log(1 - x); };
    auto const behind_log1p = [](auto const& x, auto const& v) { return v * v / 2 + log1p(-x); };
    auto const of_six = [](auto const& x, auto const& v) { return v.squaredNorm() / 2 + log(1 - x(0)) + log1p(-x(5)); };
    Eigen::VectorXd const origin = Eigen::VectorXd::Zero(6), fast = 9 * Eigen::VectorXd::Unit(6, 0);
    stops_after(1, behind_log, mid_point, 0.0, 9.0); // the middle of its first step is before the wall
    stops_after(1, behind_log, order_one, 0.0, 9.0);
    stops_after(1, behind_log1p, mid_point, 0.0, 9.0);
    stops_after(1, of_six, mid_point, origin, fast);
    stops_after(1, of_six, order_one, origin, fast);
    stops_after(1, of_six, order_one, origin, Eigen::VectorXd(fast.reverse()));
}

TEST_CASE("a step that begins before a wall and whose last velocity leads behind it has the solution before it") {
    auto const one = [](auto const& x, auto const& v) { return v * v / 2 + log(1 - x); };
    auto const all = [](auto const& x, auto const& v) { return v.squaredNorm() / 2 + log(1 - x(0)); };
    double const h = 0.25;
    auto const is_solved = [&](double p0, double q1, double p1) { // from q = 0, the middle m in m = h/2 (p0 - h/2 / (1 - m))
        double const m = q1 / 2, force = -1 / (1 - m);
        CHECK(m < 1);
        CHECK(std::abs(q1 / h - (p0 + h / 2 * force)) <= 64 * epsilon<double>() * (p0 - h * force / (1 - m)));
        CHECK(std::abs(p1 - (p0 + h * force)) <= 64 * epsilon<double>() * (p0 - h * force / (1 - m)));
    };
    for (double const p0 : {7.0, 9.0, 30.0, 1000.0}) {
        auto const x = record(embed(lagrangian{one}, mid_point).along(uniform(0.0, h, 1), 0.0, p0)).states.back();
        is_solved(p0, x.q, x.p);
        for (int const d : {2, 6}) {
            Eigen::VectorXd const origin = Eigen::VectorXd::Zero(d), fast = p0 * Eigen::VectorXd::Unit(d, 0);
            auto const y = record(embed(lagrangian{all}, mid_point).along(uniform(0.0, h, 1), origin, fast)).states.back();
            is_solved(p0, y.q(0), y.p(0));
        }
    }
}

TEST_CASE("a drag |v| v, whose second derivatives are infinite at rest, acts from rest on") {
    lagrangian const L{[](auto const& x, auto const& v) { return v.dot(v) / 2 - x.dot(x) / 2; }};
    auto const by_norm = [](auto const&, auto const& v) { return -(v.norm() * v) / 5; };
    auto const by_hypot = [](auto const&, auto const& v) { return -(hypot(v(0), v(1)) * v) / 5; };
    auto const T = uniform(0.0, 0.05, 40);
    auto const check_of = [&](auto const& L, auto const& drag, auto const& e, auto const& q0, auto const& v0) {
        auto const path = embed(with_force(L, drag), e).along(T, initial_velocity{q0, v0});
        CHECK(largest_residual(path) <= 64 * epsilon<double>() / T.h());
        CHECK(last_of(path) != last_of(embed(L, e).along(T, initial_velocity{q0, v0})));
        auto const zero = decltype(q0 + q0)::PlainObject::Zero(q0.size()).eval();
        CHECK(last_of(embed(with_force(L, drag), e).along(T, zero, zero)) == zero);
    };
    auto const check = [&](auto const&... what) { check_of(L, what...); };
    auto const check_all = [&](auto const& drag, auto const& q0, auto const& v0) {
        check(drag, mid_point, q0, v0);
        check(drag, order_one, q0, v0);
        check(drag, theta<1, 3>, q0, v0);
    };
    Eigen::Vector2d const q0(0.3, -0.2), rest(0, 0), v0(0, 0.5);
    check_all(by_norm, q0, rest);
    check_all(by_norm, q0, v0);
    check_all(by_hypot, q0, rest);
    Eigen::VectorXd q6(6), rest6 = Eigen::VectorXd::Zero(6);
    q6 << 0.3, -0.2, 0, 1, 0.5, -1;
    check_all(by_norm, q6, rest6);
    check_all(by_norm, Eigen::VectorXd(q0), Eigen::VectorXd(rest));
    // with a mass that moves the derivatives of the force are asked for
    lagrangian const moving{[](auto const& x, auto const& v) { return (2 + x(0)) * v.dot(v) / 2 - x.dot(x) / 2; }};
    check_of(moving, by_norm, mid_point, q0, rest);
    check_of(moving, by_norm, mid_point, q6, rest6);
    check_of(moving, by_hypot, mid_point, q6, rest6);
}

TEST_CASE("a component beyond the largest number is refused, whichever it is, and a sum beyond it is not") {
    auto const free = [](auto const& x, auto const& v) { return v.squaredNorm() / 2 + 0 * x(0); };
    auto const T = uniform(0.0, 1.0, 2);
    for (int const d : {5, 13, 16}) {
        Eigen::VectorXd const large = Eigen::VectorXd::Constant(d, 1e308), still = Eigen::VectorXd::Zero(d);
        CHECK(last_of(embed(lagrangian{free}, order_one).along(T, large, still)) == large);
        CHECK(last_of(embed(lagrangian{free}, mid_point).along(T, large, still)) == large);
        for (int k = 0; k < d; ++k)
            CHECK_THROWS_AS(
                (void)last_of(embed(lagrangian{free}, order_one).along(T, large, Eigen::VectorXd(1e308 * Eigen::VectorXd::Unit(d, k)))),
                error::not_finite);
    }
}

TEST_CASE("a root that has an infinite slope at 0 has it") {
    auto const T = uniform(0.0, 0.05, 4);
    auto const of_one = [](auto const& x, auto const& v) { return v * v / 2 + sqrt(x); };
    auto const of_six = [](auto const& x, auto const& v) { return v.squaredNorm() / 2 + sqrt(x(0)) + sqrt(x(1) * x(1) + x(2)); };
    Eigen::VectorXd const origin = Eigen::VectorXd::Zero(6);
    CHECK_THROWS_AS((void)last_of(embed(lagrangian{of_one}, order_one).along(T, 0.0, 0.0)), error::not_finite);
    CHECK_THROWS_AS((void)last_of(embed(lagrangian{of_six}, order_one).along(T, origin, origin)), error::not_finite);
    Eigen::VectorXd const beside = Eigen::VectorXd::Unit(6, 0); // the second root alone
    CHECK_THROWS_AS((void)last_of(embed(lagrangian{of_six}, order_one).along(T, beside, origin)), error::not_finite);
    // and the pole of 1/|q| is none the flatter for it
    auto const pole = [](auto const& x, auto const& v) { return v.squaredNorm() / 2 + 1 / x.norm(); };
    CHECK_THROWS_AS((void)last_of(embed(lagrangian{pole}, order_one).along(T, origin, origin)), error::not_finite);
    Eigen::Vector2d const here(0, 0);
    CHECK_THROWS_AS((void)last_of(embed(lagrangian{pole}, order_one).along(T, here, here)), error::not_finite);
}

} // namespace walls_tests
