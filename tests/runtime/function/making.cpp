// SPDX-License-Identifier: BSL-1.0
// Discrete functions from formulas and from tables, of numbers and of vectors: their values, where they live, and what is refused.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <limits>

#include "support/values.hpp"

namespace function_making_tests {

using namespace hilger;
using namespace hilger::testing;

TEST_CASE("a function from a formula has its values at the points of its scale") {
    auto const T = steps_1_2_4();
    auto const square = [](Q const& t) { return Q(t * t); };
    CHECK(values(function_on(T, square)) == "T: 0, 1, 9, 49");
    CHECK(values(function_on(half(T), square)) == "T_half: 1/4, 4, 25");
    CHECK(values(function_on(circ(T), square)) == "T_o: 0, 1/4, 1, 4, 9, 25, 49");
    CHECK(values(function_on(without_last(T), square)) == "T^{+}: 0, 1, 9");
    CHECK(values(function_on(without_first(T), square)) == "T^{-}: 1, 9, 49");
    CHECK(values(function_on(at_lambda<1, 3>(T), square)) == "T_1/3: 1/9, 25/9, 169/9");
    CHECK(values(function_on(circ(T, Q(1, 4)), square)) == "T_{o,lambda}: 0, 1/16, 1, 9/4, 9, 16, 49");
    CHECK(function_on(T, square).scale() == T);
    CHECK(function_on(interior(circ(T)), square).scale() == interior(circ(T)));
}

TEST_CASE("brackets take the number of a point, parentheses the point") {
    auto const T = steps_1_2_4();
    auto const f = function_on(without_first(T), [](Q const& t) { return Q(t + 10); });
    CHECK(f[1] == 11);
    CHECK(f(Q(1)) == 11);
    CHECK(f(3) == 13); // an integer is a point
    CHECK(f[3] == 17);
    CHECK_THROWS_WITH_AS((void)f[0], "point number 0 is outside T^{-} = {1, 3, 7} (3 points), whose points are numbered 1 to 3",
                         error::outside_domain);
    CHECK_THROWS_WITH_AS((void)f(Q(0)), "0 is not a point of T^{-} = {1, 3, 7} (3 points)", error::outside_domain);
    CHECK_THROWS_AS((void)f(Q(2)), error::outside_domain);
    CHECK_THROWS_AS((void)f[4], error::outside_domain);
    auto const g = function_on(uniform(0.0, 0.1, 10), [](double t) { return t; });
    CHECK(g(0.3) == g[3]);
    CHECK(function_on(half(T), [](Q const& t) { return t; })(Q(5)) == 5);
}

TEST_CASE("a table has one value for each point, in order") {
    auto const T = steps_1_2_4();
    CHECK(values(function_on(T, std::vector<Q>{1, 2, 6, -2})) == "T: 1, 2, 6, -2");
    CHECK(values(function_on(without_first(T), std::vector<Q>{2, 6, -2})) == "T^{-}: 2, 6, -2");
    CHECK(values(function_on(half(T), std::vector<Q>{4, 1, 7})) == "T_half: 4, 1, 7");
    CHECK(values(function_on(interior(circ(T)), std::vector<Q>{1, 2, 3, 4, 5})) == "T_o^{+-}: 1, 2, 3, 4, 5");
    CHECK(function_on(without_first(T), std::vector<Q>{2, 6, -2})[1] == 2); // the first value belongs to the first point of T^-, number 1
}

TEST_CASE("a table of another size is refused") {
    auto const T = steps_1_2_4();
    CHECK_THROWS_WITH_AS(function_on(T, std::vector<Q>{1, 2, 3}),
                         "a function on T = {0, 1, 3, 7} (4 points) needs 4 values, and was given 3", error::mismatch);
    CHECK_THROWS_WITH_AS(function_on(half(T), std::vector<Q>(4)),
                         "a function on T_half = {1/2, 2, 5} (3 points) needs 3 values, and was given 4", error::mismatch);
    CHECK_THROWS_AS(function_on(T, std::vector<Q>{}), error::mismatch);
    CHECK_THROWS_AS(function_on(without_last(T), std::vector<Q>(4)), error::mismatch);
}

TEST_CASE("NaN and infinity are no values of a table") {
    auto const T = uniform(0.0, 0.5, 2);
    double const not_a_number = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH_AS(function_on(T, std::vector<double>{1.0, not_a_number, 2.0}),
                         "the value at 0.5 is NaN or infinite; a function on T = {0, 0.5, 1} (3 points) has finite values",
                         error::not_finite);
    CHECK_THROWS_WITH_AS(function_on(without_first(T), std::vector<double>{1.0, infinity}),
                         "the value at 1 is NaN or infinite; a function on T^{-} = {0.5, 1} (2 points) has finite values",
                         error::not_finite);
    CHECK_THROWS_AS(function_on(T, std::vector<double>{-infinity, 1.0, 2.0}), error::not_finite);
    Eigen::Vector2d const bad(1.0, not_a_number), good(1.0, 2.0);
    CHECK_THROWS_AS(function_on(T, std::vector<Eigen::Vector2d>{good, good, bad}), error::not_finite);
    CHECK_THROWS_WITH_AS(function_on(T, std::vector<Eigen::VectorXd>{good, good, Eigen::VectorXd::Ones(3)}),
                         "the value at 1 has 3 components, and the first one has 2", error::mismatch);
    CHECK_NOTHROW(function_on(T, std::vector<Eigen::Vector2d>{good, good, good}));
}

TEST_CASE("integer values become scalars of the scale, so that their means are not cut off") {
    auto const T = uniform(0.0, 0.5, 4);
    auto const one = function_on(T, [](double) { return 1; });
    CHECK(integral(one, T) == 2.0);
    CHECK(exponential(one, 1.0, 0.0) == 2.25);
    auto const counts = function_on(T, std::vector<int>{0, 1, 1, 0, 7});
    CHECK(extend[counts][1] == 0.5);
    CHECK(Delta_plus[counts][3] == 14.0);
    CHECK(step_mean[on_half[extend[counts]]][1] == 0.75);
    CHECK((counts / 2)[1] == 0.5);
    CHECK(integral(apply_pointwise([](double t) { return t > 0.6; }, function_on(T, [](double t) { return t; })), T) == 1.0);
    CHECK(values(extend[function_on(steps_1_2_4(), std::vector<int>{0, 1, 0, 1})]) == "T_o: 0, 1/2, 1, 1/2, 0, 1/2, 1");
}

TEST_CASE("values are vectors of any dimension") {
    auto const T = uniform(0.0, 0.5, 2);
    auto const circle = function_on(T, [](double t) { return Eigen::Vector2d(std::cos(t), std::sin(t)); });
    CHECK(circle(0.5) == Eigen::Vector2d(std::cos(0.5), std::sin(0.5)));
    auto const expression =
        function_on(T, [](double t) { return Eigen::Vector2d::Constant(t); }); // a formula may return an Eigen expression
    static_assert(std::same_as<value_of<decltype(expression)>, Eigen::Vector2d>);
    CHECK(expression[2] == Eigen::Vector2d(1.0, 1.0));
    Eigen::VectorXd const u = Eigen::VectorXd::LinSpaced(3, 0.0, 2.0);
    auto const table = function_on(T, std::vector<Eigen::VectorXd>{u, 2 * u, 3 * u});
    CHECK(table[2] == 3 * u);
    CHECK(table(0.5).size() == 3);
}

TEST_CASE("tabulate computes each value once") {
    auto const T = uniform(Q(0), Q(1, 2), 8);
    int calls = 0;
    auto const counted = function_on(T, [&calls](Q const& t) {
        ++calls;
        return Q(t * t);
    });
    CHECK(counted[3] == Q(9, 4));
    CHECK(counted[3] == Q(9, 4));
    CHECK(calls == 2); // a formula is evaluated at each access
    calls = 0;
    auto const table = tabulate(counted);
    CHECK(calls == 9);
    for (int k = 0; k < 3; ++k) CHECK(table[3] == Q(9, 4));
    CHECK(calls == 9);
    CHECK(values(table) == values(counted));
}

TEST_CASE("tabulate keeps the domain") {
    auto const square = [](double t) { return t * t; };
    auto const table = tabulate(Delta_minus[function_on(uniform(0.0, 1.0, 3), square)]);
    CHECK(values(table) == "T^{-}: 1, 3, 5");
    CHECK(table.first() == 1);
    CHECK_THROWS_AS((void)table[0], error::outside_domain);
}

} // namespace function_making_tests
