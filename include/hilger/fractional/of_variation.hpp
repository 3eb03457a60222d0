// SPDX-License-Identifier: BSL-1.0
// The flow of a restricted principle, as flow_of(variation(S)) of local equations (integrator/flow.hpp):
//   flow_of(variation(S - rho * integral(Delta_minus_alpha<1, 4>[q] * Delta_plus_alpha<1, 4>[y], T)))     damped by impulses
#pragma once

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

/// Refused: other couplings are not stepped.
template <class Action, linear_map A, linear_map B, class Root, class... Options>
constexpr auto flow_of(restricted_euler_lagrange<Action, A, B, Root> const&, Options const&...) {
    return does_not_compile<"the first curve of a restricted principle is stepped where its coupling is Delta_minus_alpha<P, Q>[q] * "
                            "Delta_plus_alpha<R, S>[y], in this order, and here it is " +
                                A::name() + "[q] * " + B::name() + "[y]",
                            Action>{};
}

} // namespace hilger
