// SPDX-License-Identifier: BSL-1.0
// expect: lambda lies in ]0, 1[
// T_0 is in T already.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const S = circ<0, 1>(T);
#else
    [[maybe_unused]] auto const S = circ<1, 3>(T);
#endif
}
