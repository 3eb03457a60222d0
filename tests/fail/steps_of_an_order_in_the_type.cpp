// SPDX-License-Identifier: BSL-1.0
// expect: error: static assertion failed: an action whose position or velocity reads all points before or after
// A step ahead of all that was: causal after local is causal. Two halves of an order make a local difference, which is stepped.
#include "hilger/integrator/solve.hpp"

using namespace hilger;

int main() {
    constexpr unknown q;
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
    auto const T = uniform(0.0, 0.1, 10);
#ifdef MUST_NOT_COMPILE
    auto const S = nabla_integral(L(q, sigma[Delta_minus_alpha<1, 2>[q]]), T);
#else
    auto const S = nabla_integral(L(q, Delta_minus_alpha<1, 2>[Delta_minus_alpha<1, 2>[q]]), T);
#endif
    (void)solve(variation(S), T, {.q0 = 1.0, .v0 = 0.0});
}
