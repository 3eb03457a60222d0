// SPDX-License-Identifier: BSL-1.0
#include "check.hpp"

TEST_CASE("orders of fractional differences next to 0 and 1") { extremes::check(extremes::orders(extremes::scope::test)); }
TEST_CASE("histories of such orders") { extremes::check(extremes::histories(extremes::scope::test)); }
TEST_CASE("damping at the stages of Radau IIA") { extremes::check(extremes::stages(extremes::scope::test)); }
