// SPDX-License-Identifier: BSL-1.0
// The residual of a trajectory in the discrete Euler-Lagrange equation from which its method was derived,
//   A*[dL/dq + f] + B*[dL/dv]   at the inner points of T,
// evaluated by the operators of the embedding (variational/variation.hpp), and not by the tableau that a step uses.
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

/// The points of a trajectory as a scale of their own, where they are a part of one.
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
template <class Judge, class Flow, discrete_function X>
    requires requires(Flow const& method, X const& q) { equation_of(method, q.root()); }
auto judged(Judge const& judge, Flow const& method, X const& q) {
    auto const equation = equation_of(method, q.root());
    auto const& force = method.mechanics().force;
    if constexpr (std::same_as<typename std::remove_cvref_t<decltype(equation.action())>::position_type::from, nodes>)
        return judge(equation, q, force);
    else
        return judge(equation, with_inner_points(equation, q, force), force);
}
/// Along a trajectory, with its own values inside the steps.
template <class Judge, class F, class Force, class E, sums Sums, class Scale, class V>
    requires requires(flow<F, Force, E, Sums> const& method, Scale const& T) { equation_of(method, scale_of_steps(T)); }
auto judged(Judge const& judge, trajectory<flow<F, Force, E, Sums>, Scale, V> const& path) {
    auto const& method = path.method();
    auto const T = scale_of_steps(path.scale());
    auto const equation = equation_of(method, T);
    return judge(equation, positions_along(equation, T, path), method.mechanics().force);
}
/// At recorded states of the flow.
template <class Judge, class F, class Force, class E, sums Sums, class S, class V, class Scale>
    requires requires(flow<F, Force, E, Sums> const& method, Scale const& T) { equation_of(method, scale_of_steps(T)); }
auto judged(Judge const& judge, flow<F, Force, E, Sums> const& method, recording<S, V, Scale> const& run) {
    require_complete(run);
    auto const T = scale_of_steps(run.scale);
    auto const equation = equation_of(method, T);
    return judge(equation, inner_points_of_walk(method, equation, T, run.states), method.mechanics().force);
}

} // namespace detail

/// The largest component of the residual of the equation that a flow was derived from, forces included: at positions q in C(T),
/// largest_residual(method, q); along a trajectory, largest_residual(path); at recorded states, largest_residual(method, recording). Terms
/// of the size |p| / h cancel in it, but not their rounding errors, epsilon |p| / h and epsilon |dp/dv| |q| / h^2, which are its size along
/// a solution. For compositions and adjoints along trajectories (composition/residual.hpp), and with fractional damping
/// (fractional/residual.hpp).
/// @throws error::singular, newton_failure where there are points inside the steps and no solution for them; error::mismatch where there is
/// not a state at each point of its scale; the errors of the trajectory
template <class Judged, class... Run>
    requires requires(Judged const& method, Run const&... run) { judged(detail::by_size{}, method, run...); }
auto largest_residual(Judged const& method, Run const&... run) { return judged(detail::by_size{}, method, run...); }
/// The same, each component divided by the rounding of the terms of its own row (variational/relative_residual.hpp): below some tens along
/// a solution, in any units and steps.
template <class Judged, class... Run>
    requires requires(Judged const& method, Run const&... run) { judged(detail::by_rounding{}, method, run...); }
auto relative_residual(Judged const& method, Run const&... run) { return judged(detail::by_rounding{}, method, run...); }

} // namespace hilger
