// SPDX-License-Identifier: BSL-1.0
// expect: several terms are given together, with_fractional_damping(L, {{rho_1, beta_1}, {rho_2, beta_2}})
#include "hilger/fractional/flow.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const damped = with_fractional_damping(with_fractional_damping(L, 0.1, 0.5), 0.2, 0.75);
#else
    [[maybe_unused]] auto const damped = with_fractional_damping(L, {{0.1, 0.5}, {0.2, 0.75}});
#endif
}
