// SPDX-License-Identifier: BSL-1.0
// Two-sided problems: x in C(T) with x(t_0) and x(t_N) given that solves (EL_h^alpha) of Bourdin, Cresson, Greff, Inizan (2013),
//   dL/dx_k + (Delta_+^alpha dL/dv)_k = 0 for k = 1..N-1,  v = Delta_-^alpha x.
//   auto const solution = solve_boundary(fractional_problem(L, fraction<3, 4>{}), T, 0.0, 1.0);     solution.q is a function on T
// How it is solved: boundary/solver.hpp; what there is to solve for alpha <= 1/2: boundary/equation.hpp.
#pragma once

#include "hilger/boundary/solver.hpp"

namespace hilger {

/// The function x in C(T) with x(t_0) = first and x(t_N) = last that solves (EL_h^alpha). Boundary values are numbers or vectors of one
/// length, or what becomes such without losing a digit (hilger/variational/given_state.hpp). O(N log N) time and O(N) memory; exact scalars
/// in O(N^2) for L = v.M v / 2 and O(N^3) else.
/// @throws error::invalid_parameter when alpha is not in ]0, 1] or h^alpha is no number of an exact scalar; error::mismatch when the
///         boundary values have different lengths; error::not_finite; error::singular where d^2 L / dv dv is;
///         newton_failure<std::vector<V>>, an error::no_convergence with the last iterate and its residual.
template <class F, class Order, ordered_scalar S, index_type Steps, class First, class Last>
auto solve_boundary(fractional_problem<F, Order> const& problem, uniform_scale<S, Steps> const& T, First const& first, Last const& last,
                    boundary_options const& options = {}) {
    if constexpr (not detail::are_given_states<S, First, Last>()) detail::refuse_states<S, First, Last>();
    using V = detail::given_state_t<S, First>;
    V const q0 = detail::as_state<V>(first), qN = detail::as_state<V>(last);
    detail::require_same_dimension(q0, qN, "the boundary values of a problem");
    if (not detail::all_finite(q0) or not detail::all_finite(qN))
        error::raise<error::not_finite>("the boundary values of a problem are finite");
    return detail::boundary_solver<F, Order, uniform_scale<S, Steps>, V>(problem, T, q0, qN, options).solve();
}
/// Other scales are refused: on them a fractional difference is no convolution.
template <class F, class Order, time_scale_like Scale, class First, class Last>
    requires(not Scale::root_type::is_uniform)
auto solve_boundary(fractional_problem<F, Order> const&, Scale const&, First const&, Last const&, boundary_options const& = {}) {
    using Root = typename Scale::root_type;
    return detail::solved_elsewhere<Root>();
}

} // namespace hilger
