// SPDX-License-Identifier: BSL-1.0
// The values of a solution inside its steps. Where the operators of an action read such points, as those of galerkin<s, Q> do, the equation
// there determines the values in each step separately, once those on T are known:
//   auto const EL = variation(integral(L(G.position[q], G.velocity[q]), at_nodes<gauss, 3>(T)));
//   auto const x = with_inner_points(EL, values_on_T);        // on T/3; EL.residual(x) is then zero inside, and at T where x solves EL
#pragma once

#include <optional>
#include <vector>

#include "hilger/function/function.hpp"
#include "hilger/integrator/flow.hpp"
#include "hilger/integrator/solve_rows.hpp"
#include "hilger/step/state.hpp"
#include "hilger/variational/variation.hpp"

namespace hilger {

namespace detail {

/// with_inner_points for steps whose values are unknown: put_known(all, i) puts the known values of step i into `all`, which has those on
/// T.
template <class Action, class X, class Force, class PutKnown>
auto inner_points_unless(euler_lagrange<Action> const& equation, X const& x, Force const& force, PutKnown const& put_known) {
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
    if constexpr (parts > 1) {
        auto const flow = flow_of(equation, force);
        for (index_type i = 0; i < T.steps(); ++i) {
            saying_where(state<S, V>{S(T.point(i)), at(parts * i), zero_like(at(0))}, S(T.step(i)), [&] {
                if (put_known(all, i)) return;
                put_straight_line(all, parts * i + 1, parts * (i + 1));
                solve_rows(flow, T, all, i, i + 1, "the equation inside a step", search::alone, much_work, all);
            });
        }
    }
    return function_on(derived_scale(T, domain<Base>{}), std::move(all));
}
template <class S, class V>
std::vector<V> positions_of(std::vector<state<S, V>> const& states) {
    std::vector<V> q;
    q.reserve(states.size());
    for (auto const& x : states) q.push_back(x.q);
    return q;
}
/// The positions of a trajectory, with those inside its steps where the equation has points there.
template <class Action, class Path>
auto positions_along(euler_lagrange<Action> const&, typename Action::root_type const& T, Path const& path) {
    using Base = typename Action::position_type::from;
    auto at = path.begin();
    std::vector<std::remove_cvref_t<decltype(at->q)>> all{at->q};
    all.reserve(static_cast<std::size_t>(Base::last(T.steps()) + 1));
    for (++at; not(at == path.end()); ++at) {
        if constexpr (Base::last(1) > 1) {
            auto const start = all.back();
            for (int m = 1; m < static_cast<int>(Base::last(1)); ++m) all.push_back(start + at.remembered().inside(m));
        }
        all.push_back(at->q);
    }
    return function_on(derived_scale(T, domain<Base>{}), std::move(all));
}
/// The same for recorded states at the points of T, by a step of the flow from each state to the next. In long steps the positions alone
/// may not determine them.
template <class Flow, class Action, class S, class V>
auto inner_points_of_walk(Flow const& method, euler_lagrange<Action> const& equation, typename Action::root_type const& T,
                          std::vector<state<S, V>> const& states) {
    constexpr index_type parts = Action::position_type::from::last(1);
    std::optional<typename Flow::template stepper<S, V>> stepper;
    return inner_points_unless(equation, function_on(T, positions_of(states)), method.mechanics().force, [&](auto& all, index_type i) {
        auto const first = states.begin() + i;
        state<S, V> const& next = first[1];
        S const h(T.step(i));
        try {
            if (not stepper) {
                stepper.emplace(method, h, first->q);
                stepper->start_with(method, *first, V((next.q - first->q) / h));
            }
            state<S, V> x = *first;
            stepper->advance(method, x, h);
            if (square_root_of_epsilon<S>() * (magnitude(first->q) + magnitude(next.q)) < magnitude(V(x.q - next.q))) return false;
            for (index_type m = 1; m < parts; ++m)
                all[static_cast<std::size_t>(parts * i + m)] = first->q + stepper->inside(static_cast<int>(m));
            return true;
        } catch (error::exception const&) { // states of another trajectory
            return false;
        }
    });
}

} // namespace detail

/// The function that equals x on T and solves the equation inside the steps, with a force f(q, v) or f(t, q, v) beside dL/dq or without. In
/// long steps there may be several: it is one near the straight lines.
/// @throws newton_failure, error::singular, error::not_finite with the points between which there is no solution
template <class Action, discrete_function X, class Force = no_force>
auto with_inner_points(euler_lagrange<Action> const& equation, X const& x, Force const& force = {}) {
    return detail::inner_points_unless(equation, x, force, [](auto&, index_type) { return false; });
}

} // namespace hilger
