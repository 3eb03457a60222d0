// SPDX-License-Identifier: BSL-1.0
// Between rings that are too far apart there is no soap film, and nothing is taken for one: all ways to a solution are tried, which takes
// its time.
#include <doctest/doctest.h>

#include "joined_by.hpp"

namespace no_solution_tests {

using namespace hilger;
using namespace testing::two_ends;

TEST_CASE("catenoids: none between far rings") {
    for (auto const& [half_distance, N] : {std::pair(0.67, 100), std::pair(0.70, 1000), std::pair(1.0, 400)})
        CHECK_THROWS_AS((void)joined_by(catenoid, uniform(interval{-half_distance, half_distance}, N), 1.0, 1.0), error::no_convergence);
}

} // namespace no_solution_tests
