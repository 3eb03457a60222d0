// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#if HILGER_HAS_FLOAT128
#include "hilger/float128.hpp"
#endif
#include "prove.hpp"

TEST_CASE("every identity holds in quadruple precision") {
#if HILGER_HAS_FLOAT128
    laws::prove_all<hilger::float128>(hilger::float128(0), 1);
    laws::report("float128");
#else
    MESSAGE("this compiler has no quadruple precision");
#endif
}
