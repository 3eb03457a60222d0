// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include "hilger/multiprecision.hpp"
#include "prove.hpp"

TEST_CASE("every identity is exact in the rationals, d = 1") {
    laws::prove_all<hilger::Q>(hilger::Q(0), 2);
    laws::report("d = 1, rationals");
}
