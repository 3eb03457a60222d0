// SPDX-License-Identifier: BSL-1.0
// Section 4.3 of L. Bourdin, J. Cresson, I. Greff, P. Inizan (2013) in exact rationals, h = 1: the harmonic oscillator (31) in the plane
// and the rotations (32).
#pragma once

#include <vector>

#include "hilger/boundary/solve.hpp"
#include "hilger/multiprecision.hpp"
#include "noether.hpp"

namespace hilger::papers {

using rational_plane = Eigen::Matrix<Q, 2, 1>;
/// (31)
inline constexpr auto harmonic_oscillator = [](auto const& x, auto const& v) { return (x.dot(x) + v.dot(v)) / 2; };
/// The derivative of (32) by s at s = 0.
inline constexpr auto rotation = [](auto const& x) { return rational_plane(-x(1), x(0)); };

/// Its (EL_h^alpha) in eight steps.
inline auto oscillator_equation(Q const& alpha) {
    constexpr unknown q;
    return variation(nabla_integral(lagrangian{harmonic_oscillator}(q, Delta_minus(alpha)[q]), uniform(Q(0), Q(1), 8)));
}
/// The solution of (EL_h^alpha) from (1, 1/2) to (-1/3, 1): its equation is linear, and solved exactly.
inline auto rational_solution(Q const& alpha) {
    auto const EL = oscillator_equation(alpha);
    return solve(EL, EL.action().T, boundary_values{rational_plane(Q(1), Q(1, 2)), rational_plane(Q(-1, 3), Q(1))});
}
/// The left-hand side of (26) at t_1, ..., t_{N-1}.
inline std::vector<Q> rotation_residual(Q const& alpha) {
    auto const r = fractional_noether_residual(oscillator_equation(alpha), rotation, rational_solution(alpha));
    return {r.begin(), r.end()};
}
/// The constant (34) at t_0, ..., t_{N-1}; alpha = 1.
inline std::vector<Q> rotation_constant() {
    auto const c = noether_constant(oscillator_equation(Q(1)), rotation, rational_solution(Q(1)));
    return {c.begin(), c.end()};
}

} // namespace hilger::papers
