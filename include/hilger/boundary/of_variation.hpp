// SPDX-License-Identifier: BSL-1.0
// From an equation to what solves it: flows of local equations are flow_of(variation(S)) (flow.hpp); here are those of fractional ones.
//   flow_of(variation(S - rho * integral(Delta_minus_alpha<1, 4>[q] * Delta_plus_alpha<1, 4>[y], T)))     damped by impulses
//   solve(variation(nabla_integral(L(q, Delta_minus_alpha<3, 4>[q]), T)), T, {.q0 = x, .qN = y})          two-sided
// solve_boundary says more: the residual, and how many iterations there were.
#pragma once

#include "hilger/boundary/solve.hpp"
#include "hilger/fractional/flow.hpp"
#include "hilger/variational/restricted.hpp"

namespace hilger {

/// The flow of the first curve of a restricted principle (Jimenez, Ober-Bloebaum (20)), with a history policy. The second one is it in
/// reversed time. The principle says that the damping is an explicit impulse at each point: with_fractional_impulses, of order one and
/// with a limit of stability, and not with_fractional_damping. As the equation says, the history is that of q itself, which is 0 before
/// t_0: for q(t_0) != 0 the curve jumps there. {.history = initial_history::caputo} has the differences of q - q(t_0) in its place, and no
/// jump.
template <class F, linear_map A, linear_map B, class W, class Root, class G, class O, class R, class Policy = direct>
constexpr auto flow_of(restricted_euler_lagrange<action<F, A, B, W, Root>, fractional_difference<G, O, side::minus>,
                                                 fractional_difference<G, R, side::plus>, Root> const& equation,
                       Policy policy = {}, impulse_options options = {.history = initial_history::riemann_liouville}) {
    auto const S = equation.conservative().action();
    auto const order = equation.damping().order;
    auto const damped = [&] {
        if constexpr (requires { order.value; })
            return with_fractional_impulses<G>(S.function, equation.factor(), order.value, std::move(policy), options);
        else
            return with_fractional_impulses<G>(S.function, equation.factor(), order, std::move(policy), options);
    }();
    return embed(damped, make_embedding<W>(S.position, S.velocity, "the embedding of an action"));
}

/// The function on T with x(a) and x(b) given that solves the fractional Euler-Lagrange equation (Bourdin et al. (EL_h^alpha)).
/// Throws as solve_boundary(fractional_problem, ...) does.
template <class F, class Order, class Root, class First, class Last>
auto solve_boundary(euler_lagrange<action<F, identity_on<nodes, delta_weight>, fractional_difference<grunwald_letnikov, Order, side::minus>,
                                          nabla_weight, Root>> const& equation,
                    First const& first, Last const& last, boundary_options const& options = {}) {
    auto const& S = equation.action();
    return solve_boundary(fractional_problem(S.function, S.velocity.order), S.T, first, last, options);
}
/// The same function alone.
template <class F, class Order, class Root, class V>
auto solve(euler_lagrange<action<F, identity_on<nodes, delta_weight>, fractional_difference<grunwald_letnikov, Order, side::minus>,
                                 nabla_weight, Root>> const& equation,
           Root const& T, boundary_values<V> const& ends, no_force = {}) {
    return solve_boundary(fractional_problem(equation.action().function, equation.action().velocity.order), T, ends.q0, ends.qN).q;
}

} // namespace hilger
