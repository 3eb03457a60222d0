// SPDX-License-Identifier: BSL-1.0
// Which numbers are points of a scale. In exact scalars equality decides; in floating ones a point may be written with the rounding of
// a + ih, and no more: the neighbour of something that is not a point must not be made up.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "support/values.hpp"

namespace scale_membership_tests {

using namespace hilger;
using namespace hilger::testing;

TEST_CASE("points are members, numbers between and outside are not") {
    auto const T = steps_1_2_4();
    for (auto const& t : T) CHECK(T.contains(t));
    for (auto const& t : {Q(-1), Q(1, 2), Q(2), Q(5), Q(8), Q(1) + Q(1, 1'000'000'000)}) CHECK_FALSE(T.contains(t));
    CHECK(half(T).contains(Q(2)));
    CHECK_FALSE(half(T).contains(Q(1)));
    CHECK(circ(T).contains(Q(2)));
    CHECK(circ(T).contains(Q(1)));
    CHECK_FALSE(without_last(T).contains(Q(7)));
    CHECK_FALSE(without_first(T).contains(Q(0)));
    CHECK_FALSE(interior(T).contains(Q(0)));
    CHECK(interior(T).contains(Q(3)));
    CHECK_FALSE(interior(uniform(0.0, 1.0, 1)).contains(0.0)); // the empty scale has no members
}

TEST_CASE("number_of is the inverse of point, on long scales too") {
    auto const T = uniform(Q(-3), Q(1, 7), 100'000);
    for (hilger::index_type i : {0, 1, 2, 49'999, 50'000, 99'999, 100'000}) CHECK(T.number_of(T.point(i)) == i);
    auto const U = uniform(-3.0, 0.1, 1'000'000);
    hilger::index_type wrong = 0;
    for (hilger::index_type i = 0; i < U.size(); i += 7) wrong += U.number_of(U.point(i)) != i;
    CHECK(wrong == 0);
    auto const V = circ(U);
    for (hilger::index_type i = 0; i < V.size(); i += 7) wrong += V.number_of(V.point(i)) != i;
    CHECK(wrong == 0);
    CHECK_THROWS_WITH_AS((void)T.number_of(Q(1, 2)), "1/2 is not a point of T = {-3, -20/7, -19/7, ..., 99979/7} (100001 points)",
                         error::outside_domain);
}

TEST_CASE("a floating point may be written with the rounding of a + ih, and no more") {
    auto const T = uniform(0.0, 0.1, 10);
    CHECK(T.contains(0.3));
    CHECK(T.contains(0.1 + 0.2));
    CHECK(T.contains(std::nextafter(0.3, 1.0)));
    CHECK(T.number_of(0.7) == 7);
    CHECK_FALSE(T.contains(0.3 + 1e-14));
    CHECK_FALSE(T.contains(0.3 - 1e-14));
    CHECK_FALSE(T.contains(1.0 + 1e-14));
    CHECK_FALSE(T.contains(-1e-14));
    // Far from zero the rounding is that of the largest point.
    auto const far = uniform(1e6, 0.1, 10);
    CHECK(far.contains(1'000'000.3));
    CHECK_FALSE(far.contains(1'000'000.3 + 1e-8));
}

TEST_CASE("the finest scale that a floating scalar allows still knows its points") {
    double const h = 4 * std::numeric_limits<double>::epsilon();
    auto const T = uniform(interval{0.5, 1.0}, static_cast<hilger::index_type>(0.5 / h));
    for (hilger::index_type i : {0, 1, 2, 1000}) {
        double const t = T.point(i);
        CHECK(T.number_of(t) == i);
        CHECK(circ(T).number_of(circ(T).point(2 * i + 1)) == 2 * i + 1);
        CHECK_FALSE(T.contains(t + h / 2)); // a mid-point is no point, though it is only two units in the last place away
    }
}

TEST_CASE("points of very different sizes are told apart") {
    auto const T = powers(2.0, -60, 0); // its small points are closer to each other than the rounding of its largest
    CHECK(T.size() == 61);
    for (hilger::index_type i = 0; i < T.size(); ++i) CHECK(T.number_of(T.point(i)) == i);
    CHECK_FALSE(T.contains(3e-18));
    CHECK_FALSE(T.contains(3.4e-18));
    CHECK_FALSE(T.contains(0.0));
    CHECK_THROWS_AS((void)T.sigma(3e-18), error::outside_domain);
    CHECK(T.sigma(0.25) == 0.5);
    time_scale<double> const U{0.0, 1e-20, 1.0};
    CHECK(U.number_of(1e-20) == 1);
    CHECK_FALSE(U.contains(5e-17));
    CHECK(U.contains(std::nextafter(1.0, 2.0)));
}

TEST_CASE("NaN and the infinities are no points") {
    double const nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    auto const one = [&](auto const& T) {
        for (double t : {nan, infinity, -infinity}) {
            CHECK_FALSE(T.contains(t));
            CHECK_THROWS_AS((void)T.number_of(t), error::outside_domain);
            CHECK_THROWS_AS((void)T.sigma(t), error::outside_domain);
            CHECK_THROWS_AS((void)function_on(T, [](double s) { return s; })(t), error::outside_domain);
        }
    };
    one(uniform(0.0, 0.1, 10));
    one(circ(uniform(0.0, 0.1, 10)));
    one(time_scale<double>{-1.0, 0.0, 2.0});
    one(half(time_scale<double>{-1.0, 0.0, 2.0}));
}

TEST_CASE("the point with a number that is not one is an error") {
    auto const T = steps_1_2_4();
    CHECK_THROWS_WITH_AS((void)T.point(4), "point number 4 is outside T = {0, 1, 3, 7} (4 points), whose points are numbered 0 to 3",
                         error::outside_domain);
    CHECK_THROWS_WITH_AS((void)without_first(T).point(0),
                         "point number 0 is outside T^{-} = {1, 3, 7} (3 points), whose points are numbered 1 to 3", error::outside_domain);
    CHECK_THROWS_AS((void)T.point(-1), error::outside_domain);
    CHECK_THROWS_AS((void)uniform(0.0, 0.1, 10).point(11), error::outside_domain);
    CHECK_THROWS_AS((void)uniform(0.0, 0.1, 10).point(-1), error::outside_domain);
    CHECK_THROWS_AS((void)half(T).point(3), error::outside_domain);
    CHECK_THROWS_AS((void)circ(T).point(7), error::outside_domain);
    CHECK_THROWS_AS((void)interior(uniform(0.0, 1.0, 1)).min(), error::outside_domain);
}

} // namespace scale_membership_tests
