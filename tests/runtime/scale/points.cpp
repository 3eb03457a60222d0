// SPDX-License-Identifier: BSL-1.0
// The points of a scale: a + ih and not h added up, t_N = b exactly, and those of T_half, T_o and T_lambda between them.
#include <doctest/doctest.h>

#include <cmath>

#include "support/values.hpp"

namespace scale_points_tests {

using namespace hilger;
using namespace hilger::testing;

TEST_CASE("the points of a uniform scale are a + ih, also where adding h up would differ") {
    hilger::index_type const N = 1'000'000;
    auto const T = uniform(0.0, 0.1, N);
    REQUIRE(T.size() == N + 1);
    double sum = 0, worst = 0;
    hilger::index_type wrong = 0;
    for (hilger::index_type i = 0; i <= N; ++i, sum += 0.1) {
        if (T.point(i) != static_cast<double>(i) * 0.1) ++wrong;
        worst = std::max(worst, std::abs(sum - T.point(i)));
    }
    CHECK(wrong == 0);
    CHECK(worst > 1e-7); // the comparison means something
    CHECK(T.max() == 1e5);
}

TEST_CASE("an interval ends at b exactly") {
    CHECK(49 * (1.0 / 49) != 1.0); // one of the many N for which a + Nh misses b
    for (hilger::index_type N : {1, 2, 3, 7, 10, 49, 98, 103, 1000, 999'999}) {
        auto const T = uniform(interval{0.0, 1.0}, N);
        CHECK(T.min() == 0.0);
        CHECK(T.max() == 1.0);
        CHECK(T.size() == N + 1);
        CHECK(T.sigma(T.point(N - 1)) == 1.0);
    }
    auto const T = uniform(interval{-0.1, 0.3}, 3);
    CHECK(T.min() == -0.1);
    CHECK(T.max() == 0.3);
}

TEST_CASE("in the rationals every point is exact") {
    auto const T = uniform(Q(0), Q(1, 10), 1'000'000);
    CHECK(T.point(3) == Q(3, 10));
    CHECK(T.point(999'999) == Q(999'999, 10));
    CHECK(T.max() == Q(100'000));
    CHECK(uniform(interval{Q(0), Q(1)}, 49).point(48) == Q(48, 49));
    CHECK(uniform(interval{Q(0), Q(1)}, 49).max() == Q(1));
}

TEST_CASE_TEMPLATE("a scale of any scalar has the same shape", S, float, double, long double, float50, Q) {
    auto const T = uniform(S(1), S(1) / S(4), 4);
    CHECK(T.point(3) == S(7) / S(4));
    CHECK(T.max() == S(2));
    CHECK(half(T).point(0) == S(9) / S(8));
    CHECK(half(T).max() == S(15) / S(8));
    CHECK(circ(T).point(7) == S(15) / S(8));
    CHECK(circ(T).max() == S(2));
    CHECK(T.mu(S(1)) == S(1) / S(4));
    CHECK(T.contains(S(5) / S(4)));
    CHECK_FALSE(T.contains(S(6) / S(5)));
    CHECK(time_scale<S>{S(0), S(1) / S(2), S(1)}.sigma(S(0)) == S(1) / S(2));
    CHECK(harmonic_numbers<S>(2).max() == S(3) / S(2));
}

TEST_CASE("T_half, T_o and T_lambda lie between the points of a uniform scale") {
    auto const T = uniform(Q(1), Q(1, 2), 3);
    CHECK(points(T) == "T: 1, 3/2, 2, 5/2");
    CHECK(points(without_last(T)) == "T^{+}: 1, 3/2, 2");
    CHECK(points(without_first(T)) == "T^{-}: 3/2, 2, 5/2");
    CHECK(points(interior(T)) == "T^{+-}: 3/2, 2");
    CHECK(points(half(T)) == "T_half: 5/4, 7/4, 9/4");
    CHECK(points(circ(T)) == "T_o: 1, 5/4, 3/2, 7/4, 2, 9/4, 5/2");
    CHECK(points(without_last(half(T))) == "T_half^{+}: 5/4, 7/4");
    CHECK(points(interior(circ(T))) == "T_o^{+-}: 5/4, 3/2, 7/4, 2, 9/4");
    CHECK(points(at_lambda<1, 3>(T)) == "T_1/3: 7/6, 5/3, 13/6");
    CHECK(points(circ<1, 3>(T)) == "T_{o,1/3}: 1, 7/6, 3/2, 5/3, 2, 13/6, 5/2");
    CHECK(points(at_lambda<0, 1>(T)) == "T_0/1: 1, 3/2, 2");
    CHECK(points(at_lambda(T, Q(2, 5))) == "T_lambda: 6/5, 17/10, 11/5");
    CHECK(points(at_lambda(T, Q(0))) == "T_lambda: 1, 3/2, 2");
    CHECK(points(circ(T, Q(2, 5))) == "T_{o,lambda}: 1, 6/5, 3/2, 17/10, 2, 11/5, 5/2");
}

TEST_CASE("and between the points of any other scale") {
    auto const T = steps_1_2_4();
    CHECK(points(T) == "T: 0, 1, 3, 7");
    CHECK(points(half(T)) == "T_half: 1/2, 2, 5");
    CHECK(points(circ(T)) == "T_o: 0, 1/2, 1, 2, 3, 5, 7");
    CHECK(points(at_lambda<1, 3>(T)) == "T_1/3: 1/3, 5/3, 13/3");
    CHECK(points(circ<3, 4>(T)) == "T_{o,3/4}: 0, 3/4, 1, 5/2, 3, 6, 7");
    CHECK(points(at_lambda(T, Q(1, 4))) == "T_lambda: 1/4, 3/2, 4");
    CHECK(points(circ(T, Q(1, 4))) == "T_{o,lambda}: 0, 1/4, 1, 3/2, 3, 4, 7");
}

TEST_CASE("the points of a derived scale make a T of their own") {
    auto const T = steps_1_2_4();
    CHECK(points(time_scale(half(T))) == "T: 1/2, 2, 5");
    CHECK(points(half(time_scale(half(T)))) == "T_half: 5/4, 7/2");
    CHECK(points(time_scale(interior(circ(T)))) == "T: 1/2, 1, 2, 3, 5");
    CHECK(points(time_scale(uniform(Q(0), Q(1), 2))) == "T: 0, 1, 2");
}

TEST_CASE("q^Z and the harmonic numbers") {
    CHECK(points(powers(Q(2), -2, 3)) == "T: 1/4, 1/2, 1, 2, 4, 8");
    CHECK(points(powers(Q(3, 2), 0, 2)) == "T: 1, 3/2, 9/4");
    CHECK(points(powers(2.0, 3, 4)) == "T: 8, 16");
    CHECK(points(harmonic_numbers<Q>(4)) == "T: 0, 1, 3/2, 11/6, 25/12");
    CHECK(points(harmonic_numbers<Q>(1)) == "T: 0, 1");
}

TEST_CASE("points keep the numbers they have in the whole family") {
    auto const T = steps_1_2_4();
    CHECK(without_first(T).first() == 1);
    CHECK(without_first(T).point(1) == Q(1));
    CHECK(without_first(T).last() == 3);
    CHECK(without_last(T).last() == 2);
    CHECK(interior(circ(T)).first() == 1);
    CHECK(interior(circ(T)).last() == 5);
    CHECK(without_first(T).number_of(Q(3)) == 2);
    CHECK(circ(T).number_of(Q(3)) == 4);
    CHECK(half(T).number_of(Q(5)) == 2);
}

TEST_CASE("one step makes the smallest scale") {
    auto const T = uniform(Q(0), Q(1), 1);
    CHECK(points(T) == "T: 0, 1");
    CHECK(points(half(T)) == "T_half: 1/2");
    CHECK(points(circ(T)) == "T_o: 0, 1/2, 1");
    CHECK(points(without_last(T)) == "T^{+}: 0");
    CHECK(interior(T).empty());
    CHECK(interior(T).size() == 0);
    CHECK(interior(T).begin() == interior(T).begin());
    CHECK(without_last(without_last(without_last(T))).size() == 0);
    CHECK(interior(half(T)).size() == 0);
}

TEST_CASE("the numbers of a uniform scale meet in one scalar") {
    auto const same = [](auto const& T, auto const& U) {
        return std::same_as<decltype(T), decltype(U)> and std::vector(T.begin(), T.end()) == std::vector(U.begin(), U.end());
    };
    CHECK(same(uniform(0, 0.1, 10), uniform(0.0, 0.1, 10)));
    CHECK(same(uniform(1.5, 1, 10), uniform(1.5, 1.0, 10)));
    CHECK(same(uniform(0.5F, 0.1, 10), uniform(0.5, 0.1, 10)));
    CHECK(same(uniform(-2, Q(1, 3), 10), uniform(Q(-2), Q(1, 3), 10)));
    CHECK(same(uniform(interval{0, 1.5}, 10), uniform(interval{0.0, 1.5}, 10)));
    CHECK(same(uniform(interval{Q(1, 3), 2}, 10), uniform(interval{Q(1, 3), Q(2)}, 10)));
    CHECK_THROWS_WITH_AS((void)uniform((1 << 24) + 1, 8.0F, 10),
                         "the whole number 16777217 has no equal in this scalar, which has all of them up to 2^24",
                         error::invalid_parameter);
    CHECK(uniform(1 << 30, 1024.0F, 10).min() == 1073741824.0F); // beyond 2^24, and a float all the same
}

} // namespace scale_points_tests
