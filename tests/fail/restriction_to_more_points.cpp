// SPDX-License-Identifier: BSL-1.0
// expect: this needs a function on T, and the one given lives on T^{+}
// A restriction invents no values.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    auto const f = function_on(T, [](double t) { return t; });
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const g = restrict_to(Delta_plus[f], T);
#else
    [[maybe_unused]] auto const g = restrict_to(Delta_plus[f], interior(T));
#endif
}
