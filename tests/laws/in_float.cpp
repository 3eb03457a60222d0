// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "prove.hpp"

TEST_CASE("every identity holds in float") {
    laws::prove_all<float>(0.0F, 2);
    laws::report("float");
}
