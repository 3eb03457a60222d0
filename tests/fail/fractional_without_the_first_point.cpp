// SPDX-License-Identifier: BSL-1.0
// expect: Delta_minus_alpha<1/2> sums from the first point on, and this function lives on T^{-}
// lines-clang: 25
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 1.0, 2);
#ifdef MUST_NOT_COMPILE
    auto const f = function_on(without_first(T), [](double t) { return t; });
#else
    auto const f = function_on(T, [](double t) { return t; });
#endif
    [[maybe_unused]] auto const g = Delta_minus_alpha<1, 2>[f];
}
