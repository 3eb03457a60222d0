// SPDX-License-Identifier: BSL-1.0
// A pendulum: the Lagrangian once, the mid-point calculus, and what follows from them.
#include <algorithm>
#include <cmath>
#include <iostream>

#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10'000); // T = {a + ih}: start, step, number of steps
    constexpr unknown q;                      // q ∈ C(T)
    constexpr auto q_o = extend[q];           // q∘ ∈ C(T∘)
    constexpr lagrangian L{[](auto x, auto v) { return v * v / 2 - (1 - cos(x)); }};

    auto const S = integral(L(q_o, Delta_o_plus[q_o]), half(T));                   // ∫ L(q∘, Δ∘,+[q∘]) Δ½t
    auto const EL = variation(S);                                                  // [∂L/∂q]½,− − Δ½,−[∂L/∂v] = 0
    static_assert(EL.force() == mean_h_minus and EL.momentum() == -Delta_h_minus); // the scheme is a theorem about types

    std::cout << EL << hamiltonian_form(EL) << latex(EL);

    auto const x = solve(EL, T, {.q0 = 1.0, .v0 = 0.0});
    double worst = 0;
    for (double const r : EL.residual(x)) worst = std::max(worst, std::abs(r));
    std::cout << "largest residual of the equation over " << T << ": " << worst << '\n';

    hamiltonian const H(L);
    double drift = 0;
    for (auto const& [t, at, p] : embed(L, mid_point).along(T, 1.0, 0.0)) drift = std::max(drift, std::abs(H(p, at) - H(0.0, 1.0)));
    std::cout << "largest energy error: " << drift << '\n';
    return worst < 1e-9 and drift < 1e-3 ? 0 : 1;
}
