// SPDX-License-Identifier: BSL-1.0
#include "check.hpp"

TEST_CASE("numbers from 1e-300 to 1e300") { extremes::check(extremes::sizes(extremes::scope::test)); }
TEST_CASE("mass matrices and Legendre maps on the way to singular ones") { extremes::check(extremes::masses(extremes::scope::test)); }
