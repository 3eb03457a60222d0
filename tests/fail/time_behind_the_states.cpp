// SPDX-License-Identifier: BSL-1.0
// expect 1: the time stands before the states, f(t, q, v), and this force takes it behind them
// expect 2: the time stands before the states, L(t, q, v), and this Lagrangian takes it behind them
// expect 3: a force takes two states of any number type
// expect 4: a uniform T has a start, the length of a step and the number of steps, uniform(a, h, N), or it is uniform(interval{a, b}, N)
// What says that its last argument is a number is told; three arguments of any type are taken as t, q, v.
#include "hilger/integrator/flow.hpp"

using namespace hilger;

int main() {
    auto const L = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };
#if not defined(MUST_NOT_COMPILE)
    auto const f = [](double t, auto const&, auto const& v) { return -0.1 * t * v; };
    for (auto const& x : embed(with_force(L, f), mid_point).along(uniform(0.0, 0.1, 10), 1.0, 0.0)) (void)x;
#elif MUST_NOT_COMPILE == 1
    auto const f = [](auto const&, auto const& v, double t) { return -0.1 * t * v; };
    for (auto const& x : embed(with_force(L, f), mid_point).along(uniform(0.0, 0.1, 10), 1.0, 0.0)) (void)x;
#elif MUST_NOT_COMPILE == 2
    auto const M = [](auto const& q, auto const& v, double t) { return v * v / 2 - t * q; };
    for (auto const& x : embed(M, mid_point).along(uniform(0.0, 0.1, 10), 1.0, 0.0)) (void)x;
#elif MUST_NOT_COMPILE == 3
    auto const f = [](double, double v) { return -0.1 * v; };
    for (auto const& x : embed(with_force(L, f), mid_point).along(uniform(0.0, 0.1, 10), 1.0, 0.0)) (void)x;
#else
    for (auto const& x : embed(L, mid_point).along(uniform(0.0, 1000), 1.0, 0.0)) (void)x;
#endif
}
