// SPDX-License-Identifier: BSL-1.0
#include "check.hpp"

TEST_CASE("NaN and infinity at every entry") { extremes::check(extremes::not_finite(extremes::scope::test)); }
