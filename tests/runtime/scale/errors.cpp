// SPDX-License-Identifier: BSL-1.0
// What makes no time scale, each with its typed error and one sentence that says what was wrong.
#include <doctest/doctest.h>

#include <limits>
#include <vector>

#include "support/values.hpp"

namespace scale_errors_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {
double const not_a_number = std::numeric_limits<double>::quiet_NaN();
double const infinity = std::numeric_limits<double>::infinity();
} // namespace

TEST_CASE("a scale has at least one step") {
    CHECK_THROWS_WITH_AS(uniform(0.0, 0.1, 0), "a time scale needs at least one step, and this one was given 0", error::invalid_scale);
    CHECK_THROWS_WITH_AS(uniform(interval{0.0, 1.0}, -3), "a time scale needs at least one step, and this one was given -3",
                         error::invalid_scale);
    CHECK_THROWS_AS(uniform(Q(0), Q(1), 0), error::invalid_scale);
    CHECK_THROWS_AS(uniform(interval{0.0, 1.0}, 0), error::invalid_scale);
    CHECK_THROWS_WITH_AS(time_scale<double>{1.0}, "a time scale needs at least one step, that is two points, and this one has 1",
                         error::invalid_scale);
    CHECK_THROWS_AS(time_scale<double>(std::vector<double>{}), error::invalid_scale);
    CHECK_THROWS_AS(time_scale(half(uniform(0.0, 1.0, 1))), error::invalid_scale);     // one mid-point
    CHECK_THROWS_AS(time_scale(interior(uniform(0.0, 1.0, 1))), error::invalid_scale); // no point
}

TEST_CASE("a step is positive") {
    CHECK_THROWS_WITH_AS(uniform(0.0, 0.0, 10), "the step h of a time scale is positive, and this one is 0", error::invalid_scale);
    CHECK_THROWS_WITH_AS(uniform(1.0, -0.5, 10), "the step h of a time scale is positive, and this one is -0.5", error::invalid_scale);
    CHECK_THROWS_AS(uniform(Q(1), Q(-1, 3), 10), error::invalid_scale);
    CHECK_THROWS_WITH_AS(uniform(interval{1.0, 0.0}, 4), "an interval ends after it begins, and this one goes from 1 to 0",
                         error::invalid_scale);
    CHECK_THROWS_AS(uniform(interval{1.0, 1.0}, 4), error::invalid_scale);
    CHECK_THROWS_WITH_AS(uniform(interval{0.0, std::nan("")}, 4),
                         "the points of a time scale are finite, and these start at 0 with step nan", error::invalid_scale);
}

TEST_CASE("points are finite") {
    CHECK_THROWS_WITH_AS(uniform(not_a_number, 0.1, 10), "the points of a time scale are finite, and these start at nan with step 0.1",
                         error::invalid_scale);
    CHECK_THROWS_AS(uniform(0.0, not_a_number, 10), error::invalid_scale);
    CHECK_THROWS_AS(uniform(infinity, 0.1, 10), error::invalid_scale);
    CHECK_THROWS_AS(uniform(-infinity, 0.1, 10), error::invalid_scale);
    CHECK_THROWS_AS(uniform(0.0, infinity, 10), error::invalid_scale);
    CHECK_THROWS_AS(uniform(0.0, 1e308, 10), error::invalid_scale); // b overflows
    CHECK_THROWS_AS(uniform(interval{0.0, not_a_number}, 10), error::invalid_scale);
    CHECK_THROWS_AS(uniform(interval{-infinity, 0.0}, 10), error::invalid_scale);
    CHECK_THROWS_WITH_AS((time_scale<double>{0.0, 1.0, not_a_number}), "the points of a time scale are finite, and point 2 is nan",
                         error::invalid_scale);
    CHECK_THROWS_AS((time_scale<double>{not_a_number, 1.0}), error::invalid_scale);
    CHECK_THROWS_AS((time_scale<double>{0.0, 1.0, infinity}), error::invalid_scale);
    CHECK_THROWS_AS((time_scale<double>{-infinity, 1.0}), error::invalid_scale);
}

TEST_CASE("given points increase and none is repeated") {
    CHECK_THROWS_WITH_AS((time_scale<Q>{Q(0), Q(1), Q(2, 3)}), "the points of a time scale increase, and point 2 = 2/3 comes after 1",
                         error::invalid_scale);
    CHECK_THROWS_WITH_AS((time_scale<Q>{Q(0), Q(1, 3), Q(1, 3), Q(1)}),
                         "the points of a time scale are distinct, and points 1 and 2 are both 1/3", error::invalid_scale);
    CHECK_THROWS_AS((time_scale<double>{1.0, 0.0}), error::invalid_scale);
    CHECK_THROWS_AS((time_scale<double>{0.0, 0.0}), error::invalid_scale);
    CHECK_THROWS_AS((time_scale<double>{0.0, -0.0, 1.0}), error::invalid_scale);
    CHECK_NOTHROW(time_scale<double>{0.1 + 0.2, 0.3 + 1e-15});
}

TEST_CASE("a step that is lost in rounding beside its points makes no scale") {
    CHECK_THROWS_WITH_AS(uniform(1e17, 1.0, 10), "the step h = 1 is lost in rounding beside the points 1e+17 and 100000000000000016",
                         error::invalid_scale);
    CHECK_THROWS_AS(uniform(1.0, 1e-17, 10), error::invalid_scale);
    CHECK_THROWS_AS(uniform(-1.0, 1e-17, 10), error::invalid_scale);
    CHECK_THROWS_AS(uniform(1.0, 1.4e-16, 10), error::invalid_scale); // t_1 differs from t_0, but t_2 = t_1
    CHECK_THROWS_AS(uniform(1e8f, 1.0f, 3), error::invalid_scale);
    CHECK_THROWS_AS(uniform(0.0f, 1e-3f, 100'000'000), error::invalid_scale);
    CHECK_NOTHROW(uniform(0.0, 1e-300, 10)); // small is not lost
    CHECK_NOTHROW(uniform(Q(1), Q(mp::cpp_int(1), mp::cpp_int(1) << 200), 10));
}

TEST_CASE("the scales of quantum calculus and of the harmonic numbers have their own conditions") {
    CHECK_THROWS_WITH_AS(powers(Q(1), 0, 3), "the scale q^Z needs q > 1, and this q is 1", error::invalid_scale);
    CHECK_THROWS_AS(powers(0.5, 0, 3), error::invalid_scale);
    CHECK_THROWS_AS(powers(not_a_number, 0, 3), error::invalid_scale);
    CHECK_THROWS_WITH_AS(powers(Q(2), 3, 3), "the scale q^Z needs exponents first < last, and these are 3 and 3", error::invalid_scale);
    CHECK_THROWS_AS(powers(Q(2), 3, 1), error::invalid_scale);
    CHECK_THROWS_AS(powers(2.0, 0, 2000), error::invalid_scale); // overflow
    CHECK_THROWS_AS(harmonic_numbers<Q>(0), error::invalid_scale);
    CHECK_THROWS_AS(harmonic_numbers<double>(-1), error::invalid_scale);
}

TEST_CASE("a number of steps is whole, and is not rounded down") {
    double const h = 0.1, b = 0.3; // b / h is a little less than 3
    CHECK_THROWS_WITH_AS(uniform(0.0, h, b / h),
                         "the number of steps of a time scale is a whole number, and 2.9999999999999996 is none: std::lround(b / h) is, or "
                         "uniform(interval{a, b}, N)",
                         error::invalid_scale);
    CHECK_THROWS_AS(uniform(interval{0.0, 1.0}, 0.7 / 0.1), error::invalid_scale);
    CHECK_THROWS_AS(uniform(0.0, h, not_a_number), error::invalid_scale);
    CHECK_THROWS_AS(uniform(0.0, h, 1e30), error::invalid_scale);
    CHECK(uniform(0.0, h, 1e3).steps() == 1000);
    CHECK(uniform(interval{0.0, 1.0}, 1e3).steps() == 1000);
    CHECK(uniform(interval{0.0F, 0.1}, 10).max() == 0.1);
}

TEST_CASE("lambda lies in its interval") {
    auto const T = uniform(0.0, 0.5, 4);
    CHECK_THROWS_WITH_AS(at_lambda(T, 1.0), "lambda lies in [0, 1[, and this one is 1", error::invalid_parameter);
    CHECK_THROWS_AS(at_lambda(T, -0.25), error::invalid_parameter);
    CHECK_THROWS_AS(at_lambda(T, not_a_number), error::invalid_parameter);
    CHECK_THROWS_WITH_AS(circ(T, 0.0), "lambda lies in ]0, 1[, and this one is 0", error::invalid_parameter);
    CHECK_THROWS_AS(circ(T, 1.5), error::invalid_parameter);
    CHECK_THROWS_AS(circ(T, not_a_number), error::invalid_parameter);
    CHECK_THROWS_WITH_AS(extend_at(Q(-1, 2)), "lambda lies in ]0, 1[, and this one is -1/2", error::invalid_parameter);
    CHECK_THROWS_AS(extend_at(1.0), error::invalid_parameter);
    CHECK_THROWS_AS(extend_at(0.0), error::invalid_parameter);
    CHECK_NOTHROW(at_lambda(T, 0.0));
}

TEST_CASE("every error is a hilger exception and a standard one") {
    CHECK_THROWS_AS(uniform(0.0, 0.1, 0), error::exception);
    CHECK_THROWS_AS(uniform(0.0, 0.1, 0), std::runtime_error);
    CHECK_THROWS_AS((void)uniform(0.0, 0.1, 3).sigma(9.0), error::exception);
    CHECK_THROWS_AS(at_lambda(uniform(0.0, 0.1, 3), 2.0), error::exception);
}

} // namespace scale_errors_tests
