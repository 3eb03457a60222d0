// SPDX-License-Identifier: BSL-1.0
// expect: hilger does not support -ffast-math, -Ofast and -fassociative-math, which lose small terms and NaN; -O3 -march=native is
// supported What the compiler defines there; other flags are not given to these cases.
// alone: what is precompiled is without it
#ifdef MUST_NOT_COMPILE
#define __FAST_MATH__ 1
#endif
#include "hilger/scalar.hpp"

int main() {}
