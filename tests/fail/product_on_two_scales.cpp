// SPDX-License-Identifier: BSL-1.0
// expect: a product needs both functions on one scale, and they live on T_half and on T
// T_half and T have no point in common.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    auto const f = function_on(half(T), [](double t) { return t; });
    auto const g = function_on(T, [](double t) { return t * t; });
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const product = f * g;
#else
    [[maybe_unused]] auto const product = f * pi_inverse[g];
#endif
}
