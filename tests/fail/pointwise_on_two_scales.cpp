// SPDX-License-Identifier: BSL-1.0
// expect: apply_pointwise needs both functions on one scale, and they live on T and on T_half
// lines-clang: 25
// The third function is on another scale, and the message names it, not the second.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    auto const f = function_on(T, [](double t) { return t; });
    auto const g = function_on(half(T), [](double t) { return t; });
    auto const map = [](double x, double y, double z) { return x + y * z; };
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const y = apply_pointwise(map, f, f, g);
#else
    [[maybe_unused]] auto const y = apply_pointwise(map, f, f, pi_half[g]);
#endif
}
