// SPDX-License-Identifier: BSL-1.0
// Comparisons of traced numbers, and what is made of them: absolute values, the smaller and the larger one. Comparisons look at values; how
// they came out is kept, for the graph holds where they come out the same.
#pragma once

#include "hilger/differentiation/traced/choices.hpp"
#include "hilger/error.hpp"

namespace hilger {

namespace detail {
/// Either a traced number, or both operands of which one is.
template <class X, class Y>
struct traced_pair_ {};
template <class S>
struct traced_pair_<traced<S>, traced<S>> {
    using type = traced<S>;
};
template <class S, constant_beside<S> K>
struct traced_pair_<traced<S>, K> {
    using type = traced<S>;
};
template <class S, constant_beside<S> K>
struct traced_pair_<K, traced<S>> {
    using type = traced<S>;
};
template <class X, class Y>
using traced_pair = typename traced_pair_<X, Y>::type;

/// Whether both stand in a formula that has no values.
template <class X, class Y>
bool is_written_out() {
    return makes_derivatives<typename traced_pair<X, Y>::scalar_type>();
}
/// A comparison, written down in the graph and for those who watch (differentiation/branches.hpp).
/// @throws error::no_formula in a formula without values
template <class X, class Y>
bool watched(relation how, X const& of, Y const& with) {
    using T = traced_pair<X, Y>;
    using S = typename T::scalar_type;
    T const x(of), y(with);
    bool const outcome = holds(how, x.value, y.value);
    if (x.is_constant() and y.is_constant()) return outcome;
    auto& g = *formula_graph<S>::of_this_thread();
    if (not g.has_values)
        error::raise<error::no_formula>(
            "what compares its arguments, by if or otherwise, is not one formula, nor is what iterates, as the "
            "Legendre transform of a Hamiltonian does: constants can be compared, and min, max and abs are formulas");
    int const a = x.place(), b = y.place();
    g.watch(how, a, b, outcome);
    return compared(outcome, ((g[a].on | g[b].on) & on_velocity) != 0);
}
/// At least one of two operands is traced, the other one may be a constant.
template <class X, class Y>
concept compared_traced = requires {
    typename traced_pair<X, Y>;
};
} // namespace detail

template <class X, class Y>
    requires detail::compared_traced<X, Y>
bool operator==(X const& x, Y const& y) { return detail::watched(detail::relation::equal, x, y); }
template <class X, class Y>
    requires detail::compared_traced<X, Y>
bool operator<(X const& x, Y const& y) { return detail::watched(detail::relation::less, x, y); }
template <class X, class Y>
    requires detail::compared_traced<X, Y>
bool operator<=(X const& x, Y const& y) { return detail::watched(detail::relation::less_or_equal, x, y); }
template <class X, class Y>
    requires detail::compared_traced<X, Y>
bool operator>(X const& x, Y const& y) { return y < x; }
template <class X, class Y>
    requires detail::compared_traced<X, Y>
bool operator>=(X const& x, Y const& y) { return y <= x; }

template <class S>
traced<S> abs(traced<S> const& x) {
    if (not x.is_constant() and detail::makes_derivatives<S>()) return detail::make_traced<detail::abs_traced>(x);
    return x < S(0) ? -x : x;
}
template <class S>
traced<S> fabs(traced<S> const& x) {
    return abs(x);
}
namespace detail {
template <bool Largest, class S>
traced<S> extremum(traced<S> const& x, traced<S> const& y) {
    if (makes_derivatives<S>()) return not x.is_constant() and x.node == y.node ? x : make_traced<extremum_traced<Largest>>(x, y);
    return (Largest ? x < y : y < x) ? y : x;
}
} // namespace detail
template <class X, class Y>
detail::traced_pair<X, Y> max(X const& x, Y const& y) {
    using T = detail::traced_pair<X, Y>;
    return detail::extremum<true>(T(x), T(y));
}
template <class X, class Y>
detail::traced_pair<X, Y> min(X const& x, Y const& y) {
    using T = detail::traced_pair<X, Y>;
    return detail::extremum<false>(T(x), T(y));
}
template <class X, class Y>
detail::traced_pair<X, Y> fmax(X const& x, Y const& y) {
    using T = detail::traced_pair<X, Y>;
    if (detail::is_written_out<X, Y>()) return detail::extremum<true>(T(x), T(y));
    return x < y or T(x).value != T(x).value ? T(y) : T(x);
}
template <class X, class Y>
detail::traced_pair<X, Y> fmin(X const& x, Y const& y) {
    using T = detail::traced_pair<X, Y>;
    if (detail::is_written_out<X, Y>()) return detail::extremum<false>(T(x), T(y));
    return y < x or T(x).value != T(x).value ? T(y) : T(x);
}
/// |x| with the sign of y.
template <class X, class Y>
detail::traced_pair<X, Y> copysign(X const& x, Y const& y) {
    using T = detail::traced_pair<X, Y>;
    T const a(x);
    if (detail::is_written_out<X, Y>()) return detail::make_traced<detail::abs_traced>(a) * detail::make_traced<detail::sign_traced>(T(y));
    return detail::watched(detail::relation::signs_differ, x, y) ? -a : a;
}

} // namespace hilger
