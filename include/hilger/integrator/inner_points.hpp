// SPDX-License-Identifier: BSL-1.0
// What a solution does inside its steps. Where the operators of an action read points inside the steps, as those of galerkin<s, Q> do, the
// equation at these points says what the values there are, each step for itself, once those on T are known:
//   auto const EL = variation(integral(L(G.position[q], G.velocity[q]), at_nodes<gauss, 3>(T)));
//   auto const x = with_inner_points(EL, values_on_T);        // on T/3; EL.residual(x) is then zero inside, and at T where x solves EL
#pragma once

#include <vector>

#include "hilger/function/function.hpp"
#include "hilger/integrator/rows.hpp"
#include "hilger/step/state.hpp"
#include "hilger/variational/variation.hpp"

namespace hilger {

/// The function that is x on T, and inside the steps solves the equation, of a Lagrangian with a force f(q, v) or f(t, q, v) beside dL/dq
/// or without. @throws newton_failure, error::singular, error::not_finite with the points between which there is no solution
template <class Action, discrete_function X, class Force = no_force>
auto with_inner_points(euler_lagrange<Action> const& equation, X const& x, Force const& force = {}) {
    using Root = typename Action::root_type;
    using Base = typename Action::position_type::from;
    using S = typename Root::scalar_type;
    using V = value_of<X>;
    static_assert(std::same_as<typename X::domain_type, domain<nodes>>, "the values that are known are those of a function on T");
    constexpr index_type parts = Base::last(1);
    Root const& T = x.root();
    std::vector<V> all(static_cast<std::size_t>(Base::last(T.steps()) + 1), V(x.get(0)));
    auto const at = [&](index_type j) -> V& { return all[static_cast<std::size_t>(j)]; };
    for (index_type i = 0; i <= T.steps(); ++i) at(parts * i) = V(x.get(i));
    if constexpr (parts > 1)
        for (index_type i = 0; i < T.steps(); ++i) {
            saying_where(state<S, V>{S(T.point(i)), at(parts * i), zero_like(at(0))}, S(T.step(i)), [&] {
                detail::put_straight_line(all, parts * i + 1, parts * (i + 1));
                detail::solve_rows(equation, T, all, parts * i + 1, parts * (i + 1), parts, force, "the equation inside a step");
            });
        }
    return function_on(derived_scale(T, domain<Base>{}), std::move(all));
}

} // namespace hilger
