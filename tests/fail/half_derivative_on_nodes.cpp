// SPDX-License-Identifier: BSL-1.0
// expect: Delta_h_plus acts on functions on T_half, and this one lives on T
// The derivative of T_half does not know T.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    auto const f = function_on(T, [](double t) { return t * t; });
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const g = Delta_h_plus[f];
#else
    [[maybe_unused]] auto const g = Delta_plus[f];
#endif
}
