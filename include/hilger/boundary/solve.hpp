// SPDX-License-Identifier: BSL-1.0
// Two-sided problems: x in C(T) with x(t_0) and x(t_N) given that solves (EL_h^alpha) of Bourdin, Cresson, Greff, Inizan (2013),
//   dL/dx_k + (Delta_+^alpha dL/dv)_k = 0 for k = 1..N-1,  v = Delta_-^alpha x,
// with the weights of any generating function:
//   auto const EL = variation(nabla_integral(L(q, Delta_minus_alpha<3, 4>[q]), T));
//   auto const x = solve(EL, T, {.q0 = 0.0, .qN = 1.0});
//   auto const solution = solve(EL, T, {.q0 = 0.0, .qN = 1.0}, boundary_options{});      says more; solution.q is x
// The method: boundary/solver.hpp; the problem for alpha <= 1/2: boundary/equation.hpp.
#pragma once

#include "hilger/boundary/solver.hpp"
#include "hilger/integrator/solve.hpp"

namespace hilger {

/// The solution with x(t_0) = ends.q0 and x(t_N) = ends.qN, with a report. Boundary values are numbers or vectors of one length, or convert
/// to such exactly (hilger/variational/given_state.hpp). O(N log N) time and O(N) memory; exact scalars in O(N^2) for L = v.M v / 2 and
/// O(N^3) else.
/// @throws error::invalid_parameter when the order lies outside ]0, 1], or h^alpha is no number of an exact scalar; error::mismatch when
///         the boundary values have different lengths; error::not_finite; error::singular where d^2 L / dv dv is;
///         newton_failure<std::vector<V>>, an error::no_convergence with the last iterate and its residual.
template <class F, generating_function G, class Order, class Root, class V>
auto solve(euler_lagrange<fractional_action<F, G, Order, Root>> const& equation, Root const& T, boundary_values<V> const& ends,
           boundary_options const& options) {
    detail::require_two_sided_weights<fractional_difference<G, Order, side::minus>, Root>();
    detail::require_two_sided_order(equation.action().velocity.order.template as<typename Root::scalar_type>());
    auto const [q0, qN] = detail::given_ends<typename Root::scalar_type>(ends);
    fractional_action<F, G, Order, Root> action = equation.action();
    action.T = T; // as for local equations, which are solved on any scale
    return detail::boundary_solver<decltype(action), std::remove_cvref_t<decltype(q0)>>(action, q0, qN, options).solve();
}
/// The solution alone, without a report.
template <class F, generating_function G, class Order, class Root, class V>
auto solve(euler_lagrange<fractional_action<F, G, Order, Root>> const& equation, Root const& T, boundary_values<V> const& ends,
           no_force = {}) {
    return solve(equation, T, ends, boundary_options{}).q;
}

} // namespace hilger
