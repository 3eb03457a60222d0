// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include "hilger/multiprecision.hpp"
#include "prove.hpp"

TEST_CASE("every identity holds in 100 digits") {
    laws::prove_all<hilger::float100>(hilger::float100(0), 1);
    laws::report("100 digits");
}
