// SPDX-License-Identifier: BSL-1.0
// Richardson's extrapolation of two-sided fractional problems. For L = v^2 / 2, x(t_0) = 0 and 1/2 < alpha <= 1 the solution is
//   Q_k = sum_j beta_{k-j} beta_{N-j} / sum_j beta_j^2 x(t_N).
// At a fixed t the sum above is a Gruenwald-Letnikov integral of a smooth function, right up to h, h^2, ...; the one below is a sum of
// j^(2 alpha - 2) (1 + c / j + ...), an integral up to h^(2 alpha - 1), h, h^2, ... So the quotient has errors with the exponents
//   { m (2 alpha - 1) + n,  m, n = 0, 1, ... } without 0:  1/2, 1, 3/2, 2, ... for alpha = 3/4.
// Near alpha = 1/2 they are too close to each other to be told apart: for alpha = 0.6 nine levels gain two digits, for 0.55 none.
// An L that depends on x has the same first two, 2 alpha - 1 and (for alpha >= 3/4) 1, and others too, 1 + alpha among them.
#pragma once

#include <algorithm>

#include "hilger/boundary/solve.hpp"

namespace hilger {

/// The first `count` exponents of h in the error of L = v^2 / 2, ascending. @throws error::invalid_parameter when alpha is not in ]1/2, 1].
template <class S>
std::vector<S> error_exponents(S const& alpha, int count) {
    S const step = S(2) * alpha - S(1);
    if (not(S(0) < step) or not(alpha <= S(1)))
        error::raise<error::invalid_parameter>("two-sided problems converge for alpha in ]1/2, 1], and this alpha is ", alpha);
    std::vector<S> all;
    for (int m = 0; m <= count; ++m)
        for (int n = 0; n <= count; ++n)
            if (m + n > 0) all.push_back(S(m) * step + S(n));
    std::sort(all.begin(), all.end());
    std::vector<S> exponents;
    for (S const& e : all) // those that differ by rounding are one
        if (exponents.empty() or exponents.back() * (S(1) + S(64) * epsilon<S>()) < e) exponents.push_back(e);
    exponents.resize(static_cast<std::size_t>(count));
    return exponents;
}

/// The result of extrapolated().
template <class Root, class V>
struct extrapolated_solution {
    decltype(function_on(std::declval<Root const&>(), std::declval<std::vector<V>>())) q;
    scalar_of<V> change; ///< the change by the last level, in the largest component: of the size of the error where the exponents are right
};

/// The solution for h -> 0 at the points of T, from those with h, h/2, ..., h/2^m for m exponents of the error, each with its report.
/// @throws error::invalid_parameter when alpha < 1 and x(t_0) is not 0: (EL_h^alpha) forgets it like h^(1 - alpha), as a function with a
///         square integrable Riemann-Liouville derivative begins at 0, so that x - x(t_0) is the unknown to take; and as solve
template <class F, class Order, ordered_scalar S, class V>
auto extrapolated(euler_lagrange<fractional_action<F, grunwald_letnikov, Order, uniform_scale<S>>> const& equation,
                  boundary_values<V> const& ends, std::vector<S> const& exponents, boundary_options const& options = {}) {
    using State = detail::given_state_t<S, V>;
    auto const& action = equation.action();
    auto const& T = action.T;
    if (action.velocity.order.template as<S>() != S(1) and magnitude(State(detail::as_state<State>(ends.q0))) != S(0))
        error::raise<error::invalid_parameter>("for alpha < 1 the limit h -> 0 of a two-sided problem begins at 0, whatever x(t_0) is: "
                                               "extrapolate the problem for x - x(t_0)");
    // Neville's table, one row at a time: entry j is without the first j exponents.
    std::vector<std::vector<State>> row;
    index_type refinement = 1;
    for (std::size_t level = 0; level <= exponents.size(); ++level, refinement *= 2) {
        uniform_scale<S> const fine(T.min(), S(T.h() / S(static_cast<long long>(refinement))), T.max(), T.steps() * refinement);
        fractional_action<F, grunwald_letnikov, Order, uniform_scale<S>> const refined{action.function, action.position, action.velocity,
                                                                                       fine};
        auto const solution = solve(variation(refined), fine, ends, options);
        std::vector<State> next;
        for (index_type k = 0; k <= T.steps(); ++k) next.push_back(solution.q.get(k * refinement));
        for (std::size_t j = 0; j < level; ++j) {
            using std::pow;
            S const gain = S(pow(S(2), exponents[j])) - S(1);
            std::vector<State> better = next;
            for (std::size_t k = 0; k < next.size(); ++k) better[k] = next[k] + (next[k] - row[j][k]) / gain;
            row[j] = std::move(next);
            next = std::move(better);
        }
        row.push_back(std::move(next));
    }
    S change(0);
    if (row.size() > 1)
        for (std::size_t k = 0; k < row.back().size(); ++k)
            change = std::max(change, S(magnitude(State(row.back()[k] - row[row.size() - 2][k]))));
    return extrapolated_solution<uniform_scale<S>, State>{function_on(T, std::move(row.back())), change};
}
/// The same with the exponents of L = v^2 / 2 and so many levels beyond T.
template <class F, class Order, ordered_scalar S, class V>
auto extrapolated(euler_lagrange<fractional_action<F, grunwald_letnikov, Order, uniform_scale<S>>> const& equation,
                  boundary_values<V> const& ends, int levels, boundary_options const& options = {}) {
    if (levels < 0)
        error::raise<error::invalid_parameter>("a solution is extrapolated from T and some levels beyond it, not from ", levels);
    return extrapolated(equation, ends, error_exponents(equation.action().velocity.order.template as<S>(), levels), options);
}

} // namespace hilger
