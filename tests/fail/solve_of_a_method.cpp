// SPDX-License-Identifier: BSL-1.0
// expect 1: solve takes an equation, variation(S), and this is a method: method.along(T, {.q0 = ..., .v0 = ...}) steps it
// expect 2: solve takes an equation, variation(S), or a Lagrangian with an interval and an accuracy: embed(L, mid_point).along(T, {.q0
#include "hilger/accuracy/from_start.hpp"
#include "hilger/integrator/solve.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
    auto const T = uniform(0.0, 0.1, 10);
#if not defined(MUST_NOT_COMPILE)
    (void)embed(L, mid_point).along(T, {.q0 = 1.0, .v0 = 0.0});
    (void)solve(L.function, interval{0.0, 1.0}, {.q0 = 1.0, .v0 = 0.0}, accuracy{1e-3});
#elif MUST_NOT_COMPILE == 1
    auto const x = solve(embed(L, mid_point), T, {.q0 = 1.0, .v0 = 0.0});
    (void)x[1];
#else
    (void)solve(L, T, {.q0 = 1.0, .v0 = 0.0});
#endif
}
