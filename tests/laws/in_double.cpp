// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "prove.hpp"

TEST_CASE("every identity holds in double") {
    laws::prove_all<double>(0.0, 2);
    laws::report("double");
}
