// SPDX-License-Identifier: BSL-1.0
// expect 1: an action has one coupling; several terms of damping are with_fractional_damping
// expect 2: the first curve of a restricted principle is stepped where its coupling is Delta_minus_alpha<P, Q>
// expect 3: in this order, or at the nodes of radau of q - q(a) and y, and here it is
// expect 4: both factors of a coupling are functions on the scale of its integral
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
    constexpr unknown<"q", subdivided<2>> q_2;
    constexpr unknown<"y", subdivided<2>> y_2;
    constexpr auto G = galerkin<2, radau>;
    auto const at_stages = integral(L(G.position[q_2], G.velocity[q_2]), at_nodes<radau, 2>(T));
#if MUST_NOT_COMPILE == 3 // of q itself, which is not 0 at the start
    auto const first = Delta_minus_radau<2, 1, 4>[G.position[q_2]];
#else
    auto const first = Delta_minus_radau<2, 1, 4>[G.position[minus_start_inside<2>[q_2]]];
#endif
    auto const second = Delta_plus_radau<2, 1, 4>[G.position[y_2]];
#if MUST_NOT_COMPILE == 4
    auto const there = integral(first * second, at_nodes<radau, 3>(T));
#else
    auto const there = integral(first * second, at_nodes<radau, 2>(T));
#endif
    [[maybe_unused]] auto const stepped = flow_of(variation(at_stages - 0.3 * there));
}
