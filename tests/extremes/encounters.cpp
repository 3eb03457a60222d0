// SPDX-License-Identifier: BSL-1.0
#include "check.hpp"

TEST_CASE("close encounters and collisions") { extremes::check(extremes::encounters(extremes::scope::test)); }
