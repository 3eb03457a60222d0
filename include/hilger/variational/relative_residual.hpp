// SPDX-License-Identifier: BSL-1.0
// A residual in units of the rounding of its own terms: at most some tens if x solves the equation, for any step and units.
//   rho = max |r| / (epsilon s),    s = |A*| |dL/dq + f| + |B*| |dL/dv| + |dr/dx| |x|
// The first two sums are those of the terms; the third is the effect of the rounding of x, epsilon |p| / h and epsilon |dp/dv| |q| / h^2,
// of each component of each row in its own units. A sum of n terms is off by less than n epsilon times the sum of their magnitudes (Higham,
// Accuracy and Stability of Numerical Algorithms, 2002, section 4.2), and the n of a row does not depend on the number of points. This is
// the componentwise backward error of Oettli and Prager (Higham, theorem 7.3).
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "hilger/function/function.hpp"
#include "hilger/variational/sum_of_actions.hpp"
#include "hilger/variational/variation.hpp"

namespace hilger {

namespace detail {

/// The larger of a bound and a magnitude; NaN if either is NaN, so that it is not overlooked.
template <class S>
S larger(S const& bound, S const& x) {
    return x <= bound or not(bound == bound) ? bound : x;
}
/// |r| / (epsilon size), without the epsilon in exact scalars; 0 for r = 0.
template <class S>
S in_roundings(S const& r, S const& size) {
    S const off = magnitude(r);
    if (off == S(0)) return S(0);
    return std::numeric_limits<S>::is_exact ? S(off / size) : S(off / size / epsilon<S>());
}
/// The largest of these among the components.
template <class V>
scalar_of<V> largest_in_roundings(V const& r, V const& size) {
    scalar_of<V> worst(0);
    for (int c = 0; c < shape<V>::dimension(r); ++c)
        worst = larger(worst, in_roundings<scalar_of<V>>(shape<V>::component(r, c), shape<V>::component(size, c)));
    return worst;
}
/// to += |block| |x|
template <class V, class Block>
void add_sizes(V& to, Block const& block, V const& x) {
    using s = shape<V>;
    for (int c = 0; c < s::dimension(to); ++c)
        for (int e = 0; e < s::dimension(x); ++e) s::component(to, c) += magnitude(s::entry(block, c, e)) * magnitude(s::component(x, e));
}
/// A function on T, or on T with points inside its steps, with the values made so far.
template <class V, class Root, class Base = nodes>
struct values_so_far : function_interface<values_so_far<V, Root, Base>> {
    using root_type = Root;
    using domain_type = hilger::domain<Base>;
    Root const* T;
    std::vector<V> const* values;
    [[nodiscard]] Root const& root() const { return *T; }
    [[nodiscard]] static constexpr domain_type domain() { return {}; }
    [[nodiscard]] V const& get(index_type i) const { return (*values)[static_cast<std::size_t>(i)]; }
};

/// How many values of x before and behind its own number a row of the equation reads.
template <class Equation, class Base>
inline constexpr index_type reach_of_rows = Base::last(1) * ((std::max(-Equation::reads.on_T.first, Equation::reads.on_T.last) + 1) / 2);

/// The sums s of the rows from `first` to `last`.
template <class Equation, discrete_function X, class Derivatives>
auto sizes_of_rows(Equation const& equation, X const& x, index_type first, index_type last, Derivatives const& derivatives) {
    using V = value_of<X>;
    static_assert(Equation::reads.is_local(), "the relative residual is that of equations that are local");
    constexpr index_type reach = reach_of_rows<Equation, typename X::domain_type::base_type>;
    std::vector<V> all;
    for (index_type m = first; m <= last; ++m) all.push_back(equation.residual_size(x, m, derivatives));
    for (index_type k = std::max(x.first(), first - reach); k <= std::min(x.last(), last + reach); ++k) {
        auto const slope = equation.residual_slope(x, k, derivatives);
        V const value = x.get(k);
        for (index_type m = std::max(first, k - reach); m <= std::min(last, k + reach); ++m)
            add_sizes(all[static_cast<std::size_t>(m - first)], slope.get(m), value);
    }
    return all;
}

} // namespace detail

/// The largest component of the residual of a discrete Euler-Lagrange equation at x in C(T), each divided by epsilon times the sum of the
/// magnitudes of its own terms: dimensionless, below some tens along a solution. Exact scalars divide by the magnitudes alone. A force f(q,
/// v) or f(t, q, v) may be added to dL/dq. For local equations.
template <class Action, discrete_function X, class Force = no_force>
auto relative_residual(euler_lagrange<Action> const& equation, X const& x, Force const& force = {}) {
    using V = value_of<X>;
    using D = typename X::domain_type;
    static_assert(D::front == 0 and D::back == 0, "an equation is judged at a function on its whole scale");
    std::vector<V> const values(x.begin(), x.end());
    detail::values_so_far<V, typename X::root_type, typename D::base_type> const there{{}, &x.root(), &values};
    auto const residual = equation.residual(there, force);
    auto const size = detail::sizes_of_rows(equation, there, residual.first(), residual.last(), equation.derivatives(force));
    scalar_of<V> worst(0);
    for (index_type m = residual.first(); m <= residual.last(); ++m)
        worst =
            detail::larger(worst, detail::largest_in_roundings(V(residual.get(m)), size[static_cast<std::size_t>(m - residual.first())]));
    return worst;
}

namespace detail {
/// The measures of a residual.
struct by_size {
    template <class Equation, class X, class Force>
    auto operator()(Equation const& equation, X const& x, Force const& force) const {
        return largest_residual(equation, x, force);
    }
};
struct by_rounding {
    template <class Equation, class X, class Force>
    auto operator()(Equation const& equation, X const& x, Force const& force) const {
        return relative_residual(equation, x, force);
    }
};
} // namespace detail

} // namespace hilger
