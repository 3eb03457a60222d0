// SPDX-License-Identifier: BSL-1.0
// expect 1: a step function has a value of f in each step of T, and so f lives on T, on T^+, or on T_lambda
// expect 2: a step function has a value of f in each step of T, and so f lives on T, on T^+, or on T_lambda
// What is not there was read, and T_o was taken for T.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.5, 4);
    auto const f = function_on(T, [](double t) { return t * t; });
#if not defined(MUST_NOT_COMPILE)
    auto const y = steps_of(Delta_plus[f]);
    [[maybe_unused]] auto const z = steps_of(f);
#elif MUST_NOT_COMPILE == 1
    auto const y = steps_of(Delta_minus[f]);
#else
    auto const y = steps_of(extend[f]);
#endif
    return y(0.2) > 0 ? 0 : 1;
}
