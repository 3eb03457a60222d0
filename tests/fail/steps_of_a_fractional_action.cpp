// SPDX-License-Identifier: BSL-1.0
// expect: error: static assertion failed: an action whose position or velocity reads all points before or after
// expect: solve_boundary(equation, q_a, q_b) solves it
// The equation of such an action looks to both ends: a step that kept two points of the past would solve another one.
#include "hilger/integrator/of_variation.hpp"
#include "hilger/integrator/solve.hpp"

using namespace hilger;

int main() {
    constexpr unknown q;
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
    auto const T = uniform(0.0, 0.1, 10);
    auto const equation = variation(nabla_integral(L(q, Delta_minus(0.75)[q]), T));
#ifdef MUST_NOT_COMPILE
    (void)solve(equation, T, {.q0 = 1.0, .v0 = 0.0});
#else
    (void)solve_boundary(equation, 1.0, 0.0);
#endif
}
