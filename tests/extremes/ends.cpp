// SPDX-License-Identifier: BSL-1.0
#include "check.hpp"

TEST_CASE("lambda next to 0 and 1") { extremes::check(extremes::ends(extremes::scope::test)); }
TEST_CASE("one step, two steps, none") { extremes::check(extremes::smallest(extremes::scope::test)); }
