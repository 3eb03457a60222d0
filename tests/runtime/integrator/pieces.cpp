// SPDX-License-Identifier: BSL-1.0
// An interval in pieces: times that callables say, in any order and more than once, are ends of pieces once.
#include <vector>

#include <doctest/doctest.h>

#include "hilger/accuracy/pieces.hpp"

namespace pieces_tests {

using namespace hilger;

namespace {

struct switching {
    std::vector<double> times;
    [[nodiscard]] std::vector<double> switching_times(double, double) const { return times; }
};
using ends = std::vector<double>;
ends points_of(time_scale<double> const& T) { return {T.begin(), T.end()}; }

} // namespace

TEST_CASE("times that rounding hardly tells apart are one, however many there are") {
    double const unit = epsilon<double>();
    interval const I{0.0, 8.0};
    CHECK(detail::ends_of_pieces(I, switching{{3, 1}}, switching{{2}}, 0) == ends{0, 1, 2, 3, 8});
    CHECK(detail::ends_of_pieces(I, switching{{1, 1 + unit, 1 + 2 * unit, 1 + 3 * unit, 2}}) == ends{0, 1, 2, 8});
    CHECK(detail::ends_of_pieces(I, switching{{2, 5}}, switching{{2 + 8 * unit, 2 - 8 * unit, 5 + 16 * unit}}) ==
          ends{0, 2 - 8 * unit, 5, 8});
    CHECK(detail::ends_of_pieces(I, switching{{unit, 8 - 8 * unit}}) == ends{0, 8});
    CHECK(detail::ends_of_pieces(I, 0) == ends{0, 8});
}

TEST_CASE("steps are equal in each piece, as many as its share of the interval, and their points are joined") {
    ends const all{0, 1, 4};
    auto const each = detail::first_steps(all, 0.0, 1 << 10);
    CHECK(each == detail::steps_of_pieces{2, 6});
    CHECK(points_of(detail::joined_pieces(all, each, 1.0)) == ends{0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4});
    CHECK(detail::first_steps(all, 0.25, 1 << 10) == detail::steps_of_pieces{4, 12});
    CHECK(detail::first_steps(ends{0, 1e-3, 4}, 0.0, 1 << 10) == detail::steps_of_pieces{1, 8});
    CHECK_THROWS_AS(detail::first_steps(all, -1.0, 1 << 10), error::invalid_parameter);
    CHECK_THROWS_AS(detail::first_steps(all, 1e-3, 1 << 10), error::invalid_parameter);
}

TEST_CASE("the first eighth of a piece is a graded one of its own, and a piece ends before the time of switching") {
    double const before = 1 - 8 * epsilon<double>();
    ends const all = detail::with_starts(ends{0, 1, 5});
    CHECK(all == ends{0, before / 8, before, before + (5 - before) / 8, 5});
    CHECK(points_of(detail::joined_pieces(ends{0, 1, 2, 3}, {2, 2, 2}, 2.0)) == ends{0, 0.25, 1, 1.5, 2, 2.25, 3});
}

} // namespace pieces_tests
