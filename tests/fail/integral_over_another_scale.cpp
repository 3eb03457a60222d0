// SPDX-License-Identifier: BSL-1.0
// expect: this needs a function on T_half, and the one given lives on T
// The integral over T_half needs the values at the mid-points.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    auto const f = function_on(T, [](double t) { return t; });
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const s = integral(f, half(T));
#else
    [[maybe_unused]] auto const s = integral(extend[f], half(T));
#endif
}
