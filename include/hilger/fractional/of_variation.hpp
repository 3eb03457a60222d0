// SPDX-License-Identifier: BSL-1.0
// The flow of a restricted principle, as flow_of(variation(S)) of local equations (integrator/flow.hpp):
//   flow_of(variation(S - rho * integral(Delta_minus_alpha<1, 4>[q] * Delta_plus_alpha<1, 4>[y], T)))     damped by impulses
//   flow_of(variation(integral(L(A[q], B[q]), nodes)
//                     - rho * integral(Delta_minus_radau<s, 1, 4>[A[minus_start_inside<s>[q]]] * Delta_plus_radau<s, 1, 4>[A[y]], nodes)))
//                                                                                     at the nodes of galerkin<s, radau>, on any T
#pragma once

#include "hilger/embedding/stage_difference.hpp"
#include "hilger/fractional/flow.hpp"
#include "hilger/variational/restricted.hpp"

namespace hilger {

/// The flow of the first curve of a restricted principle (Jimenez, Ober-Bloebaum (20)), with a history policy. The second one is the same
/// in reversed time. In the principle the damping is an explicit impulse at each point: with_fractional_impulses, of order one and with a
/// limit of stability, and not with_fractional_damping. As in the equation, the history is that of q itself, which is 0 before t_0: for
/// q(t_0) != 0 the curve jumps there. {.history = initial_history::caputo} takes q - q(t_0) instead, without a jump.
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

/// The flow of the first curve at the nodes of galerkin<s, radau> with the position A and the velocity B: that of
/// with_fractional_damping(L, rho, order, exponentials{tolerance}). Its damping is Caputo's, of q - q(t_0), and its order at most 1: above
/// it Caputo's takes the velocity at t_0, which no coupling of positions has. @throws error::invalid_parameter for an order above 1
template <class F, linear_map A, linear_map B, class Root, int Stages, class O, class R, class Base, class W>
auto flow_of(restricted_euler_lagrange<action<F, A, B, step_weight, Root>,
                                       composition<stage_difference<Stages, O, side::minus>, composition<A, from_start_on<Base, W>>>,
                                       composition<stage_difference<Stages, R, side::plus>, A>, Root> const& equation,
             exponentials policy = {}) {
    auto const& S = equation.conservative().action();
    auto const& coupling = equation.action().damping;
    auto const order = detail::sum_of_orders(coupling.first.a.order, coupling.second.a.order);
    if (auto const beta = order.template as<typename Root::scalar_type>(); typename Root::scalar_type(1) < beta)
        error::raise<error::invalid_parameter>("a coupling of positions damps with an order up to 1, and the orders here have the sum ",
                                               beta);
    auto const damped = [&] {
        if constexpr (requires { order.value; })
            return with_fractional_damping(S.function, equation.factor(), order.value, policy);
        else
            return with_fractional_damping(S.function, equation.factor(), order, policy);
    }();
    return embed(damped, make_embedding<step_weight>(S.position, S.velocity, "the embedding of an action"));
}

/// Refused: other couplings are not stepped.
template <class Action, linear_map A, linear_map B, class Root, class... Options>
constexpr auto flow_of(restricted_euler_lagrange<Action, A, B, Root> const&, Options const&...) {
    return does_not_compile<"the first curve of a restricted principle is stepped where its coupling is Delta_minus_alpha<P, Q>[q] * "
                            "Delta_plus_alpha<R, S>[y], in this order, or at the nodes of radau of q - q(a) and y, and here it is " +
                                A::name() + "[q] * " + B::name() + "[y]",
                            Action>{};
}

} // namespace hilger
