// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include "hilger/multiprecision.hpp"
#include "prove.hpp"

TEST_CASE("every identity holds in 50 digits") {
    laws::prove_all<hilger::float50>(hilger::float50(0), 1);
    laws::report("50 digits");
}
