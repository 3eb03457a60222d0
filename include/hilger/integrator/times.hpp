// SPDX-License-Identifier: BSL-1.0
// The times of a motion whose time was transformed, dt = g(q) dtau (variational/time_transformation.hpp): t in C(T) is the integral of g
// over the steps of T, by the position operator and the weights of the embedding that made the motion.
//   auto const path = embed(transform_time(L, g, E), mid_point).along(T, q0, p0);
//   auto const t = times_of(path);          // t in C(T), with t = tau at the first point
#pragma once

#include <concepts>
#include <vector>

#include "hilger/integrator/residual.hpp"
#include "hilger/variational/time_transformation.hpp"

namespace hilger {

namespace detail {

/// g at a node of a step from tau. @throws error::invalid_parameter where it is not positive
template <class S>
S const& positive_rate(S const& g, S const& tau) {
    if (not(S(0) < g))
        error::raise<error::invalid_parameter>("a transformed time goes on, dt/dtau = g(q) > 0, and in the step from tau = ", tau, " g is ",
                                               g);
    return g;
}

/// t_{i+1} = t_i + sum_k w_k g(A_k) over the nodes of step i.
struct to_times {
    template <class Equation, class X, class Force>
    auto operator()(Equation const& equation, X const& x, Force const&) const {
        auto const& S = equation.action();
        using Action = std::remove_cvref_t<decltype(S)>;
        using number = typename X::root_type::scalar_type;
        auto const g = S.at_nodes(x, [&S](auto const&, auto const& q, auto const&) { return rate_at(S.function.rate, evaluated(q)); });
        using Base = base_of<decltype(g)>;
        constexpr index_type in_a_step = Base::last(2) - Base::last(1);
        constexpr index_type first = std::same_as<typename Action::weight, nabla_weight> ? 1 : 0;
        auto const& T = x.root();
        running_sum<number, number> t(number(0));
        t.add(number(T.point(0)));
        std::vector<number> times{t.value()};
        for (index_type i = 0; i < T.steps(); ++i) {
            for (index_type k = first + in_a_step * i; k < first + in_a_step * (i + 1); ++k)
                t.add(number(positive_rate(number(g.get(k)), number(T.point(i))) * weight_at<typename Action::weight>(g, k)));
            times.push_back(t.value());
        }
        return function_on(T, std::move(times));
    }
};

} // namespace detail

/// t in C(T) of a motion in a transformed time: along a trajectory, times_of(path); at recorded states, times_of(method, recording); at
/// positions in C(T), times_of(method, q); for compositions see composition/times.hpp. @throws error::invalid_parameter where g is not
/// positive; as largest_residual does
template <class Moved, class... Run>
    requires requires(Moved const& method, Run const&... run) {
        { judged(detail::to_times{}, method, run...) } -> discrete_function;
    }
auto times_of(Moved const& method, Run const&... run) { return judged(detail::to_times{}, method, run...); }

} // namespace hilger
