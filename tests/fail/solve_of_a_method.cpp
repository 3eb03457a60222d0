// SPDX-License-Identifier: BSL-1.0
// expect: solve takes an equation, variation(S), and this is a method: method.along(T, {.q0 = ..., .v0 = ...}) steps it
#include "hilger/integrator/solve.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
    auto const T = uniform(0.0, 0.1, 10);
#ifdef MUST_NOT_COMPILE
    (void)solve(embed(L, mid_point), T, {.q0 = 1.0, .v0 = 0.0});
#else
    (void)embed(L, mid_point).along(T, {.q0 = 1.0, .v0 = 0.0});
#endif
}
