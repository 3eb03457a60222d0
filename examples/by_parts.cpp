// SPDX-License-Identifier: BSL-1.0
// Integration by parts, proved exactly: no tolerance, steps of different length, and an operator of one's own.
#include <iostream>

#include "hilger/calculus.hpp"
#include "hilger/multiprecision.hpp" // Q

using namespace hilger;

int main() {
    time_scale<Q> const T{Q(0), Q(1, 3), Q(1), Q(7, 5), Q(2), Q(9, 4)}; // exact rationals, μ not constant
    auto const f = function_on(circ(T), [](Q t) { return t * t * t; });
    auto const g = function_on(circ(T), [](Q t) { return 1 / (1 + t); });

    Q const lhs = integral(Delta_o_plus[f] * g, circ(T));
    Q const rhs = boundary(f * g) - integral(sigma_o[f] * Delta_o_plus[g], circ(T));
    std::cout << lhs << " == " << rhs << '\n';

    static_assert(adjoint(Delta_o_plus) == -Delta_o_minus and adjoint(sigma_o) == rho_o);
    static_assert(on_half * Delta_o_plus * extend == pi_inverse * Delta_plus); // Δ∘,₊[f∘] = Δ₊[f] on T½

    // Any operator: its adjoint and its end terms come from its parts.
    constexpr auto mine = fraction<2, 3>{} * (Delta_plus * Delta_minus) + rho;
    auto const u = function_on(T, [](Q t) { return t * t; });
    auto const v = function_on(T, [](Q t) { return t - 1; });
    auto const parts = by_parts(mine, u, v);
    std::cout << parts.left << " == " << parts.interior << " + " << parts.boundary << '\n';
    return lhs == rhs and parts.left == parts.interior + parts.boundary ? 0 : 1;
}
