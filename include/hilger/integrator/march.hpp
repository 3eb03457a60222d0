// SPDX-License-Identifier: BSL-1.0
// Any local equation marches: where the operators of an action reach over several steps, the residual of its equation at t_i reads the
// positions from t_{i-l} to t_{i+r}, and is solved for the newest of them, row by row, from l + r values at the beginning:
//   auto const EL = variation(integral(L(q, (fraction<1, 2>{} * (Delta_plus + Delta_minus))[q]), T));
//   auto const x = solve(EL, T, std::vector{q0, q1, q2, q3});
// An equation that reaches over one step is solved from two values, and is the step that solve(EL, T, {.q0 = ..., .q1 = ...}) makes,
// slower. Such schemes have solutions beside those near the continuous ones; nothing here damps them.
#pragma once

#include <ranges>
#include <vector>

#include "hilger/function/function.hpp"
#include "hilger/newton/system.hpp"
#include "hilger/step/state.hpp"
#include "hilger/variational/given_state.hpp"
#include "hilger/variational/relative_residual.hpp"
#include "hilger/variational/variation.hpp"

namespace hilger {

namespace detail {

/// A list of states, numbers or vectors of S.
template <class Values, class S>
concept states_over = std::ranges::input_range<Values> and is_given_state<std::ranges::range_value_t<Values>> and
    is_exact_state<std::ranges::range_value_t<Values>, S>;

} // namespace detail

/// The solution on T with the given first values, numbers or vectors: l + r of them (see above), twice the number of steps that the
/// operators of the action reach over. With a force f(q, v) or f(t, q, v) beside dL/dq: solve(EL, T, values, f).
/// @throws error::mismatch when there are not so many; a row that has no solution, with its cause, says between which points the solution
/// ends
template <class Action, detail::states_over<typename Action::root_type::scalar_type> Values, class Force = no_force>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, Values const& first, Force const& force = {}) {
    using S = typename Action::root_type::scalar_type;
    using V = detail::given_state_t<S, std::ranges::range_value_t<Values>>;
    using EL = euler_lagrange<Action>;
    static_assert(EL::reads.is_local(),
                  "an action whose position or velocity reads all points before or after (Delta_minus_alpha, an antiderivative, an "
                  "operator that does not say what it reads) has an equation that looks to both ends of T, and first values do not "
                  "determine its solution; with both end values given, solve(equation, T, {.q0 = ..., .qN = ...}) solves it");
    constexpr index_type before = -EL::reads.on_T.first / 2, after = EL::reads.on_T.last / 2;
    std::vector<V> x;
    for (auto const& value : first) x.push_back(detail::as_state<V>(value));
    auto const given = static_cast<index_type>(x.size());
    detail::values_so_far<V, typename Action::root_type> const so_far{{}, &T, &x};
    auto const residual = equation.residual(so_far, force);
    auto const derivatives = equation.derivatives(force);
    using rows = typename decltype(residual)::domain_type;
    static_assert(rows::front >= before and rows::back >= after,
                  "an operator that has values where not all is there that it reads, as differences by weights have beside the ends of T, "
                  "has an equation with rows at both ends of T, which first values do not determine");
    constexpr index_type needed = rows::front + after;
    static_assert(before + after > 0,
                  "an action whose operators read the point itself alone has no motion: its equation has one position in it");
    for (V const& value : x) detail::require_same_dimension(x[0], value, "the first values");
    if (T.size() < given) error::raise<error::mismatch>("T has ", T.size(), " points, and there are ", given, " first values");
    if (given != needed)
        error::raise<error::mismatch>("the equation at a point reads ", before, " points before it and ", after,
                                      " after it, and is solved from ", needed, " values on; these are ", given);
    x.resize(static_cast<std::size_t>(T.size()), zero_like(x[0]));
    for (index_type n = needed; n < T.size(); ++n) {
        index_type const row = n - after;
        auto const at = [](std::vector<V>& all, index_type i) -> V& { return all[static_cast<std::size_t>(i)]; };
        V& unknown = at(x, n);
        V const& last = at(x, n - 1);
        V const guess = n < 2 ? last : V(last + (last - at(x, n - 2)) * S(T.step(n - 1) / T.step(n - 2)));
        auto const slope = equation.residual_slope(so_far, n, derivatives);
        auto const system = [&](V const& y) {
            unknown = y;
            return newton_system<V>{residual.get(row), slope.get(row)};
        };
        // The terms of the row are of this size.
        S reach = magnitude(guess);
        for (index_type i = row - before; i < n; ++i) reach = std::max(reach, S(magnitude(at(x, i))));
        auto jacobian = system(guess).jacobian;
        V rounding = zero_like(guess);
        for (int c = 0; c < detail::shape<V>::dimension(guess); ++c)
            detail::shape<V>::component(rounding, c) = S(detail::largest_entry(jacobian)) * reach;
        saying_where(state<S, V>{S(T.point(n - 1)), last, zero_like(last)}, S(T.step(n - 1)),
                     [&] { unknown = newton(system, guess, rounding, "the equation for the next position"); });
    }
    return function_on(T, std::move(x));
}

} // namespace hilger
