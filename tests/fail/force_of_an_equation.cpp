// SPDX-License-Identifier: BSL-1.0
// expect 1: a force is stated with L, with_force(L, f), or beside the data of an equation
// expect 2: forces come before the damping, with_fractional_damping(with_force(L, f), ...), and here a force is added to what is damped
// An equation is derived from an action, and a force is no part of that.
#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    constexpr unknown q;
    constexpr lagrangian L{[](auto x, auto v) { return v * v / 2 - x * x / 2; }};
    auto const friction = [](auto const&, auto const& v) { return -v; };
    auto const EL = variation(integral(L(q, Delta_plus[q]), T));
#if defined MUST_NOT_COMPILE && MUST_NOT_COMPILE == 2
    [[maybe_unused]] auto const damped = with_force(with_fractional_damping(L, 0.1, 0.5), friction);
#else
    [[maybe_unused]] auto const damped = with_fractional_damping(with_force(with_force(L, friction), friction), 0.1, 0.5);
#endif
#if defined MUST_NOT_COMPILE && MUST_NOT_COMPILE == 1
    [[maybe_unused]] auto const x = with_force(EL, friction);
#else
    [[maybe_unused]] auto const x = solve(EL, T, {.q0 = 1.0, .v0 = 0.0}, friction);
#endif
}
