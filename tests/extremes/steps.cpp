// SPDX-License-Identifier: BSL-1.0
#include "check.hpp"

TEST_CASE("steps from 1e-12 to beyond the limit of stability") { extremes::check(extremes::steps(extremes::scope::test)); }
TEST_CASE("differences over small steps") { extremes::check(extremes::differences(extremes::scope::test)); }
