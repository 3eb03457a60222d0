// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "prove.hpp"

TEST_CASE("every identity holds in long double") {
    laws::prove_all<long double>(0.0L, 2);
    laws::report("long double");
}
