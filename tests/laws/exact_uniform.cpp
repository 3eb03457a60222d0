// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include "hilger/multiprecision.hpp"
#include "prove.hpp"

TEST_CASE("every identity is exact in the rationals on uniform scales") {
    laws::prove_all_on_uniform_scales<hilger::Q>(2);
    laws::report("d = 1, rationals, uniform scales");
}
