// SPDX-License-Identifier: BSL-1.0
// expect 1: an action has one coupling; several terms of damping are with_fractional_damping
// expect 2: the first curve of a restricted principle is stepped where its coupling is Delta_minus_alpha<P, Q>
// Of the two curves the second one is the first in reversed time.
#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    constexpr unknown q;
    constexpr unknown<"y"> y;
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
    auto const T = uniform(0.0, 0.1, 10);
    auto const S = nabla_integral(L(rho[q], Delta_minus[q]), T);
#if MUST_NOT_COMPILE == 2
    auto const coupling = integral(Delta_plus_alpha<1, 4>[y] * Delta_minus_alpha<1, 4>[q], T);
#else
    auto const coupling = integral(Delta_minus_alpha<1, 4>[q] * Delta_plus_alpha<1, 4>[y], T);
#endif
#if MUST_NOT_COMPILE == 1
    [[maybe_unused]] auto const damped = S - 0.2 * coupling - 0.1 * coupling;
#else
    [[maybe_unused]] auto const flow = flow_of(variation(S - 0.3 * coupling));
#endif
}
