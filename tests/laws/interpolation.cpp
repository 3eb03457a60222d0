// SPDX-License-Identifier: BSL-1.0
// From discrete functions to functions on [a, b] (Cresson-Safi (30), (33), (34)): piecewise linear through the values, steps with them, and
// the diagrams that commute: differentiate or integrate before or after.
#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "identities/interpolation.hpp"
#include "support/values.hpp"

namespace function_interpolation_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {
auto const T = steps_1_2_4();
auto const f = function_on(T, std::vector<Q>{1, 2, 6, -2});
auto const g = function_on(half(T), std::vector<Q>{4, 1, 7});
} // namespace

TEST_CASE("interpolate is linear between neighbouring points") {
    auto const y = interpolate(f);
    for (auto const& t : T) CHECK(y(t) == f(t));
    CHECK(y(Q(1, 2)) == Q(3, 2));
    CHECK(y(Q(1, 4)) == Q(5, 4));
    CHECK(y(2) == 4);
    CHECK(y(Q(5, 2)) == 5);
    CHECK(y(5) == 2);
    CHECK(y(Q(13, 2)) == -1);
    for (auto const& t : circ(T)) CHECK(y(t) == extend[f](t)); // the extension is what is between
    for (auto const& t : circ<1, 3>(T)) CHECK(y(t) == extend_lambda<1, 3>[f](t));
}

TEST_CASE("its right derivative is Delta_plus of f, up to the next point") {
    auto const y = interpolate(f);
    for (auto const& t : without_last(T)) CHECK(y.right_derivative(t) == Delta_plus[f](t));
    CHECK(y.right_derivative(Q(1, 2)) == 1);
    CHECK(y.right_derivative(2) == 2);
    CHECK(y.right_derivative(Q(69, 10)) == -2);
    CHECK_THROWS_WITH_AS((void)y.right_derivative(7), "there is no right derivative at 7, the end of the interval", error::outside_domain);
}

TEST_CASE("a function on T_half or on a part of T is interpolated between its own points") {
    auto const y = interpolate(g);
    CHECK(y(Q(1, 2)) == 4);
    CHECK(y(Q(5, 4)) == Q(5, 2));
    CHECK(y(Q(7, 2)) == 4);
    CHECK(y.right_derivative(3) == 2);
    CHECK_THROWS_AS((void)y(Q(1, 4)), error::outside_domain);
    CHECK_THROWS_WITH_AS((void)y(6), "6 is outside the interval [1/2, 5]", error::outside_domain);
    auto const z = interpolate(Delta_minus[f]); // 1, 2, -2 at 1, 3, 7
    CHECK(z(2) == Q(3, 2));
    CHECK(z(5) == 0);
    CHECK_THROWS_AS((void)z(0), error::outside_domain);
}

TEST_CASE("outside of [a, b] there is nothing, and NaN is nowhere") {
    auto const y = interpolate(f);
    CHECK_THROWS_WITH_AS((void)y(-1), "-1 is outside the interval [0, 7]", error::outside_domain);
    CHECK_THROWS_AS((void)y(8), error::outside_domain);
    CHECK_THROWS_AS((void)steps_of(g)(8), error::outside_domain);
    CHECK_THROWS_AS((void)steps_of(g).integral_to(-1), error::outside_domain);
    auto const x = interpolate(function_on(uniform(0.0, 0.5, 2), [](double t) { return t; }));
    CHECK_THROWS_AS((void)x(std::numeric_limits<double>::quiet_NaN()), error::outside_domain);
    CHECK(x(1) == 1.0); // an integer is a time
    CHECK(interpolate(function_on(uniform(0.25, 0.5, 2), [](double t) { return t; }))(1) == 1.0);
}

TEST_CASE("steps_of keeps a value from one point of T up to the next") {
    auto const y = steps_of(g);
    CHECK(y(0) == 4);
    CHECK(y(Q(99, 100)) == 4);
    CHECK(y(1) == 1); // right-continuous
    CHECK(y(Q(5, 2)) == 1);
    CHECK(y(3) == 7);
    CHECK(y(7) == 7); // the last cell holds b
    auto const z = steps_of(function_on(at_lambda<1, 3>(T), std::vector<Q>{4, 1, 7}));
    CHECK(z(Q(1, 6)) == 4);
    CHECK(z(Q(4)) == 7);
}

TEST_CASE("the integral of the steps goes through the antiderivative at the points of T") {
    auto const y = steps_of(g);
    for (auto const& t : T) CHECK(y.integral_to(t) == antiderivative_h[g](t));
    CHECK(y.integral_to(Q(1, 2)) == 2);
    CHECK(y.integral_to(2) == 5);
    CHECK(y.integral_to(5) == 20);
    auto const F = interpolate(antiderivative_h[g]); // and is linear between them: the diagram (33) commutes
    for (auto const& t : {Q(1, 7), Q(1), Q(9, 4), Q(20, 3), Q(7)}) CHECK(y.integral_to(t) == F(t));
}

TEST_CASE("curves in the plane") {
    auto const u = function_on(uniform(0.0, 0.5, 2), [](double t) { return Eigen::Vector2d(t, t * t); });
    CHECK(interpolate(u)(0.25) == Eigen::Vector2d(0.25, 0.125));
    CHECK(interpolate(u).right_derivative(0.75) == Eigen::Vector2d(1.0, 1.5));
    CHECK(steps_of(on_half[extend[u]]).integral_to(0.75) == Eigen::Vector2d(0.3125, 0.21875));
}

} // namespace function_interpolation_tests
