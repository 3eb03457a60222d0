// SPDX-License-Identifier: BSL-1.0
// Galerkin steps of a Lagrangian that is not separable, with compensated sums, beside the same in 50 digits.
#include <doctest/doctest.h>

#include "runs_in_the_plane.hpp"

namespace galerkin_general_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// A charge in a magnetic field that grows, and a mass that depends on the position.
constexpr auto general = [](auto const& x, auto const& v) {
    return (1 + x(0) * x(0) / 4) * v.dot(v) / 2 + (x(0) * v(1) - x(1) * v(0)) * (1 + x.dot(x)) / 2 - x.dot(x) / 2;
};
auto const four = embed(general, galerkin<4, lobatto>, compensated);
auto const four_without = embed(general, galerkin<4, lobatto>);

} // namespace

// In bounded motion that is not sensitive; what one step rounds is below an epsilon times the increments.
TEST_CASE("what a run has in double of 50 digits is rounding, by iteration and by Newton") {
    CHECK(rounding_in(four, four_without, 20, 100, 0.5, 1) <= 100 * epsilon<double>());
    CHECK(rounding_in(four, four_without, 12, 8, 0.5, 1) <= 1000 * epsilon<double>());
}
TEST_CASE("runs are resumed bit for bit, whichever way their steps are solved") {
    CHECK(differences(path_of<double>(four, 12.0, 60, 0.5, 1), 31) == 0);
    CHECK(differences(path_of<double>(four, 12.0, 8, 0.5, 1), 3) == 0);
}

} // namespace galerkin_general_tests
