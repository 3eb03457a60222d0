// SPDX-License-Identifier: BSL-1.0
// expect: sigma leaves no point: the function lives on T^{+}, and T has only 2 points
// Two points have one next point.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    constexpr auto T = uniform<1>(0.0, 0.1);
    constexpr auto f = function_on(T, [](double t) { return t; });
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] constexpr auto g = sigma[sigma[f]];
#else
    [[maybe_unused]] constexpr auto g = rho[sigma[f]];
#endif
}
