// SPDX-License-Identifier: BSL-1.0
#include "check.hpp"

TEST_CASE("the same step in every scalar") { extremes::check(extremes::scalars(extremes::scope::test)); }
