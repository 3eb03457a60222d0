// SPDX-License-Identifier: BSL-1.0
// expect: antiderivative starts at the first point, and this function lives on T_half^{-}
// The sum from a to t needs the value at the first point.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    auto const f = function_on(half(T), [](double t) { return t; });
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const F = antiderivative_h[Delta_h_minus[f]];
#else
    [[maybe_unused]] auto const F = antiderivative_h[Delta_h_plus[f]];
#endif
}
