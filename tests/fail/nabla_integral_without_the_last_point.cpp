// SPDX-License-Identifier: BSL-1.0
// expect: this needs a function on T^{-}, and the one given lives on T^{+}
// The nabla integral needs the value at b, where Delta_plus has none.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    auto const f = function_on(T, [](double t) { return t; });
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const s = nabla_integral(Delta_plus[f], T);
#else
    [[maybe_unused]] auto const s = nabla_integral(Delta_minus[f], T);
#endif
}
