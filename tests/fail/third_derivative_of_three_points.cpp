// SPDX-License-Identifier: BSL-1.0
// expect: Delta_plus leaves no point: the function lives on T^{++}, and T has only 3 points
// Three points have two differences, and those have one.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    constexpr auto T = uniform<2>(0.0, 0.1);
    constexpr auto f = function_on(T, [](double t) { return t; });
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] constexpr auto g = Delta_plus[Delta_plus[Delta_plus[f]]];
#else
    [[maybe_unused]] constexpr auto g = Delta_plus[Delta_plus[f]];
#endif
}
