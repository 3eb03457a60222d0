// SPDX-License-Identifier: BSL-1.0
// A scale and a function are ranges of their points and values: forward, backward, by jumps, with the standard algorithms. Equality and
// printing.
#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <vector>

#include "support/values.hpp"

namespace scale_iteration_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

template <class Range, class Value>
void check_iteration(Range const& range, std::vector<Value> const& expected) {
    auto const n = static_cast<std::ptrdiff_t>(expected.size());
    REQUIRE(range.size() == n);
    REQUIRE(range.end() - range.begin() == n);
    CHECK(std::equal(range.begin(), range.end(), expected.begin(), expected.end()));
    auto it = range.end();
    for (auto i = n; i-- > 0;) CHECK(*--it == expected[static_cast<std::size_t>(i)]);
    CHECK(it == range.begin());
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        auto const& value = expected[static_cast<std::size_t>(i)];
        CHECK(range.begin()[i] == value);
        CHECK(*(range.begin() + i) == value);
        CHECK(*(i + range.begin()) == value);
        CHECK(*(range.end() - (n - i)) == value);
        CHECK(((range.begin() + i) <=> range.end()) < 0);
        CHECK((range.begin() + i) - range.begin() == i);
    }
    auto step = range.begin();
    CHECK(*step++ == expected.front());
    CHECK(step - range.begin() == 1);
    CHECK(step-- != range.begin());
    CHECK(step == range.begin());
    CHECK((step += n) == range.end());
    CHECK((step -= n) == range.begin());
}

} // namespace

TEST_CASE("scales and functions are walked in both directions and by jumps") {
    auto const T = steps_1_2_4();
    check_iteration(T, std::vector<Q>{0, 1, 3, 7});
    check_iteration(half(T), std::vector<Q>{Q(1, 2), 2, 5});
    check_iteration(circ(T), std::vector<Q>{0, Q(1, 2), 1, 2, 3, 5, 7});
    check_iteration(without_last(T), std::vector<Q>{0, 1, 3});
    check_iteration(without_first(T), std::vector<Q>{1, 3, 7});
    check_iteration(interior(T), std::vector<Q>{1, 3});
    check_iteration(uniform(0.0, 0.5, 2), std::vector<double>{0.0, 0.5, 1.0});
    check_iteration(at_lambda(T, Q(1, 4)), std::vector<Q>{Q(1, 4), Q(3, 2), 4});
    auto const f = function_on(T, std::vector<Q>{1, 2, 6, -2});
    check_iteration(f, std::vector<Q>{1, 2, 6, -2});
    check_iteration(Delta_minus[f], std::vector<Q>{1, 2, -2});
    check_iteration(extend[f], std::vector<Q>{1, Q(3, 2), 2, 4, 6, 2, -2});
}

TEST_CASE("an empty scale is an empty range") {
    auto const nothing = interior(uniform(0.0, 1.0, 1));
    CHECK(nothing.begin() == nothing.end());
    for ([[maybe_unused]] double t : nothing) FAIL("there is no point");
    CHECK(printed(nothing) == "T^{+-} = {}");
}

TEST_CASE("the standard algorithms take them") {
    auto const T = uniform(0.0, 0.1, 1'000'000);
    CHECK(*std::lower_bound(T.begin(), T.end(), 77.75) == T.point(778));
    CHECK(std::lower_bound(T.begin(), T.end(), 1e9) == T.end());
    CHECK(*std::ranges::lower_bound(T, 77.75) == T.point(778));
    CHECK(*std::ranges::upper_bound(T, T.point(5)) == T.point(6));
    CHECK(std::ranges::binary_search(T, T.point(123'456)));
    CHECK(std::ranges::is_sorted(circ(steps_1_2_4())));
    auto const T_o = circ(T);
    CHECK(std::ranges::adjacent_find(T_o) == T_o.end()); // no point twice
    auto const U = steps_1_2_4();
    CHECK(std::accumulate(U.begin(), U.end(), Q(0)) == 11);
    CHECK(std::ranges::distance(circ(U)) == 7);
    auto const f = function_on(U, std::vector<Q>{1, 2, 6, -2});
    CHECK(*std::ranges::max_element(f) == 6);
    CHECK(std::ranges::count_if(f, [](Q const& x) { return x > 0; }) == 3);
}

TEST_CASE("a scale equals another when their points are the same, however they are made") {
    auto const T = steps_1_2_4();
    CHECK(T == time_scale<Q>{Q(0), Q(1), Q(3), Q(7)});
    CHECK(T != time_scale<Q>{Q(0), Q(1), Q(3), Q(8)});
    CHECK(T != time_scale<Q>{Q(0), Q(1), Q(3)});
    CHECK(without_last(T) == time_scale<Q>{Q(0), Q(1), Q(3)});
    CHECK(without_last(T) != without_first(T));
    CHECK(circ(uniform(Q(0), Q(1), 3)) == uniform(Q(0), Q(1, 2), 6));
    CHECK(uniform(Q(0), Q(1), 3) == time_scale<Q>{Q(0), Q(1), Q(2), Q(3)});
    CHECK(half(T) == at_lambda(T, Q(1, 2)));
    CHECK(half(T) == at_lambda<1, 2>(T));
    CHECK(half(T) != T);
    CHECK(at_lambda(T, Q(1, 3)) != at_lambda(T, Q(1, 4)));
    CHECK(uniform(0.0, 0.1, 10) == uniform(0.0, 0.1, 10));
    CHECK(uniform(0.0, 0.1, 10) != uniform(0.0, 0.1, 11));
    CHECK(uniform(0.0, 0.1, 10) != uniform(0.0, 0.2, 10));
}

TEST_CASE("same_points compares what was given, and shared points at once") {
    auto const T = steps_1_2_4();
    auto const copy = T;
    CHECK(T.same_points(copy));
    CHECK(T.same_points(steps_1_2_4()));
    CHECK_FALSE(T.same_points(time_scale<Q>{Q(0), Q(1), Q(3), Q(8)}));
    CHECK(&T.element(0) == &copy.element(0)); // copies share
    CHECK(uniform(0.0, 0.1, 10).same_points(uniform(0.0, 0.1, 10)));
    CHECK_FALSE(uniform(0.0, 0.1, 10).same_points(uniform(0.5, 0.1, 10)));
    CHECK_FALSE(uniform(0.0, 0.1, 10).same_points(uniform(0.0, 0.2, 10)));
    CHECK_FALSE(uniform(0.0, 0.1, 10).same_points(uniform(0.0, 0.1, 9)));
}

TEST_CASE("a scale prints its name, its first points, its last one and their number") {
    auto const T = steps_1_2_4();
    CHECK(printed(uniform(0.0, 0.1, 10)) == "T = {0, 0.1, 0.2, ..., 1} (11 points)");
    CHECK(printed(uniform(0.0, 0.5, 3)) == "T = {0, 0.5, 1, 1.5} (4 points)");
    CHECK(printed(uniform(0.0, 0.5, 4)) == "T = {0, 0.5, 1, ..., 2} (5 points)");
    CHECK(printed(uniform(0.0, 0.5, 1)) == "T = {0, 0.5} (2 points)");
    CHECK(printed(T) == "T = {0, 1, 3, 7} (4 points)");
    CHECK(printed(without_last(T)) == "T^{+} = {0, 1, 3} (3 points)");
    CHECK(printed(interior(uniform(0.0, 0.5, 2))) == "T^{+-} = {0.5} (1 point)");
    CHECK(printed(without_first(without_first(T))) == "T^{--} = {3, 7} (2 points)");
    CHECK(printed(half(T)) == "T_half = {1/2, 2, 5} (3 points)");
    CHECK(printed(circ(T)) == "T_o = {0, 1/2, 1, ..., 7} (7 points)");
    CHECK(printed(without_last(circ(T))) == "T_o^{+} = {0, 1/2, 1, ..., 5} (6 points)");
    CHECK(printed(at_lambda<1, 3>(T)) == "T_1/3 = {1/3, 5/3, 13/3} (3 points)");
    CHECK(printed(circ(T, Q(1, 4))) == "T_{o,lambda} = {0, 1/4, 1, ..., 7} (7 points)");
}

} // namespace scale_iteration_tests
