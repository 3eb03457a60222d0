// SPDX-License-Identifier: BSL-1.0
#include "check.hpp"

TEST_CASE("many points: weights, points, sums, steps") { extremes::check(extremes::counts(extremes::scope::test)); }
