// SPDX-License-Identifier: BSL-1.0
// The equation is the judge: what a trajectory leaves of the discrete Euler-Lagrange equation that its method was derived from,
//   A*[dL/dq + f] + B*[dL/dv]   at the inner points of T,
// evaluated by the operators of the embedding (variational/variation.hpp), of which a step uses nothing but numbers.
//   largest_residual(embed(with_force(L, f), mid_point).along(T, q0, p0))
#pragma once

#include "hilger/integrator/flow.hpp"
#include "hilger/integrator/inner_points.hpp"
#include "hilger/trajectory/diagnostics.hpp"
#include "hilger/trajectory/recording.hpp"

namespace hilger {

/// The discrete Euler-Lagrange equation of a flow's Lagrangian on T, without its forces.
template <class F, class Force, linear_map A, linear_map B, class W, bool Checked, sums Sums, class Root>
constexpr auto equation_of(flow<F, Force, embedding<A, B, W, Checked>, Sums> const& f, Root const& T) {
    auto const& how = f.embedding();
    return variation(action<F, A, B, W, Root>{f.mechanics().lagrangian, how.position, how.velocity, T});
}

namespace detail {
template <class F, linear_map A, linear_map B, class W, bool Checked, class Root>
constexpr auto action_on(F const& L, embedding<A, B, W, Checked> const& how, Root const& T) {
    return action<F, A, B, W, Root>{L, how.position, how.velocity, T};
}
template <class F, class G, class First, class Second, class Root>
constexpr auto action_on(lagrangian_by_node<F, G> const& L, embedding_sum<First, Second> const& how, Root const& T) {
    auto first = action_on(L.first, how.first, T);
    auto second = action_on(L.second, how.second, T);
    return action_sum<decltype(first), decltype(second)>{std::move(first), std::move(second)};
}
} // namespace detail
template <class F, class Force, class First, class Second, sums Sums, class Root>
constexpr auto equation_of(flow<F, Force, embedding_sum<First, Second>, Sums> const& f, Root const& T) {
    return variation(detail::action_on(f.mechanics().lagrangian, f.embedding(), T));
}

namespace detail {

/// The points that a trajectory walks, as a scale of its own where they are a part of one.
template <class Scale>
auto scale_of_steps(Scale const& T) {
    if constexpr (std::same_as<typename Scale::domain_type, domain<nodes>>)
        return T.root();
    else {
        std::vector<typename Scale::root_type::scalar_type> points;
        for (auto const& t : T) points.push_back(t);
        return time_scale(std::move(points));
    }
}

/// At positions in C(T), also where the equation has points inside the steps.
template <class Action, discrete_function X, class Force>
auto largest_of_equation(euler_lagrange<Action> const& equation, X const& q, Force const& force) {
    if constexpr (std::same_as<typename Action::position_type::from, nodes>)
        return largest_residual(equation, q, force);
    else
        return largest_residual(equation, with_inner_points(equation, q, force), force);
}
/// At states on a scale, as the flow walked them.
template <class Flow, class Scale, class S, class V>
auto largest_of_walk(Flow const& method, Scale const& scale, std::vector<state<S, V>> const& states) {
    auto const T = scale_of_steps(scale);
    auto const equation = equation_of(method, T);
    return largest_residual(equation, inner_points_of_walk(method, equation, T, states), method.mechanics().force);
}

} // namespace detail

/// The largest component of the residual of the equation that a flow was derived from, at positions q in C(T), forces included. Terms of
/// the size |p| / h cancel in it, and so do their rounding errors, epsilon |p| / h and epsilon |dp/dv| |q| / h^2: of this size it is along
/// a solution. For flows under embeddings by operators; compositions and adjoints are judged along trajectories (composition/residual.hpp).
/// @throws error::singular, newton_failure where there are points inside the steps and no solution for them
template <class F, class Force, linear_map A, linear_map B, class W, bool Checked, sums Sums, discrete_function X>
auto largest_residual(flow<F, Force, embedding<A, B, W, Checked>, Sums> const& method, X const& q) {
    return detail::largest_of_equation(equation_of(method, q.root()), q, method.mechanics().force);
}
template <class F, class Force, class First, class Second, sums Sums, discrete_function X>
auto largest_residual(flow<F, Force, embedding_sum<First, Second>, Sums> const& method, X const& q) {
    return detail::largest_of_equation(equation_of(method, q.root()), q, method.mechanics().force);
}
/// The same along a trajectory, at the points inside the steps that the steps led to. @throws as walking does
template <class F, class Force, class E, sums Sums, class Scale, class V>
    requires requires(flow<F, Force, E, Sums> const& method, Scale const& T) { equation_of(method, detail::scale_of_steps(T)); }
auto largest_residual(trajectory<flow<F, Force, E, Sums>, Scale, V> const& path) {
    auto const& method = path.method();
    auto const T = detail::scale_of_steps(path.scale());
    auto const equation = equation_of(method, T);
    return largest_residual(equation, detail::positions_along(equation, T, path), method.mechanics().force);
}
/// The same of states that were kept. @throws error::mismatch where there is not one at each point of their scale
template <class F, class Force, class E, sums Sums, class S, class V, class Scale>
    requires requires(flow<F, Force, E, Sums> const& method, Scale const& T) { equation_of(method, detail::scale_of_steps(T)); }
auto largest_residual(flow<F, Force, E, Sums> const& method, recording<S, V, Scale> const& run) {
    detail::require_complete(run);
    return detail::largest_of_walk(method, run.scale, run.states);
}

} // namespace hilger
