// SPDX-License-Identifier: BSL-1.0
// Comparisons of jets and of traced numbers look at values, so that branches work, and record their outcomes (branches.hpp); and the
// functions made of branches. For equal arguments a function has the derivative of the one that it returns, which std::max and its like
// return. In a formula without values these functions are operations (traced/choices.hpp).
#pragma once

#include <type_traits>

#include "hilger/differentiation/branches.hpp"
#include "hilger/differentiation/numbers.hpp"
#include "hilger/inlining.hpp"

namespace hilger {

namespace detail {

template <class T>
HILGER_ALWAYS_INLINE constexpr bool is_written_out() {
    if constexpr (requires { T::is_written_out(); })
        return T::is_written_out();
    else
        return false;
}

} // namespace detail

template <class X, class Y>
requires detail::watched_pair<X, Y> HILGER_ALWAYS_INLINE constexpr bool operator==(X const& x, Y const& y) {
    return watched(detail::relation::equal, x, y);
}
template <class X, class Y>
requires detail::watched_pair<X, Y> HILGER_ALWAYS_INLINE constexpr bool operator<(X const& x, Y const& y) {
    return watched(detail::relation::less, x, y);
}
template <class X, class Y>
requires detail::watched_pair<X, Y> HILGER_ALWAYS_INLINE constexpr bool operator<=(X const& x, Y const& y) {
    return watched(detail::relation::less_or_equal, x, y);
}
template <class X, class Y>
requires detail::watched_pair<X, Y> HILGER_ALWAYS_INLINE constexpr bool operator>(X const& x, Y const& y) { return y < x; }
template <class X, class Y>
requires detail::watched_pair<X, Y> HILGER_ALWAYS_INLINE constexpr bool operator>=(X const& x, Y const& y) { return y <= x; }

namespace detail {

template <bool Largest, class T>
HILGER_ALWAYS_INLINE constexpr T extremum(T const& x, T const& y) {
    if constexpr (requires { T::is_written_out(); })
        if (T::is_written_out()) return written_extremum(std::bool_constant<Largest>(), x, y);
    return (Largest ? x < y : y < x) ? y : x;
}

} // namespace detail

/// |x|; at 0 with the derivative of x.
template <class X>
requires detail::watched_pair<X, X> HILGER_ALWAYS_INLINE constexpr X abs(X const& x) {
    if constexpr (requires { X::is_written_out(); })
        if (X::is_written_out()) return written_abs(x);
    return x < typename X::scalar_type(0) ? -x : x;
}
/// The larger and the smaller of x and y; x if they are equal.
template <class X>
requires detail::watched_pair<X, X> HILGER_ALWAYS_INLINE constexpr X fabs(X const& x) { return abs(x); }
template <class X, class Y>
HILGER_ALWAYS_INLINE constexpr detail::pair_of<X, Y> max(X const& x, Y const& y) {
    using both = detail::pair_of<X, Y>;
    return detail::extremum<true>(both(x), both(y));
}
template <class X, class Y>
HILGER_ALWAYS_INLINE constexpr detail::pair_of<X, Y> min(X const& x, Y const& y) {
    using both = detail::pair_of<X, Y>;
    return detail::extremum<false>(both(x), both(y));
}
/// max and min; for a number and NaN the number.
template <class X, class Y>
HILGER_ALWAYS_INLINE constexpr detail::pair_of<X, Y> fmax(X const& x, Y const& y) {
    using both = detail::pair_of<X, Y>;
    both const a(x), b(y);
    if (detail::is_written_out<both>()) return detail::extremum<true>(a, b);
    return x < y or a.value != a.value ? b : a;
}
template <class X, class Y>
HILGER_ALWAYS_INLINE constexpr detail::pair_of<X, Y> fmin(X const& x, Y const& y) {
    using both = detail::pair_of<X, Y>;
    both const a(x), b(y);
    if (detail::is_written_out<both>()) return detail::extremum<false>(a, b);
    return y < x or a.value != a.value ? b : a;
}
/// |x| with the sign of y.
template <class X, class Y>
HILGER_ALWAYS_INLINE constexpr detail::pair_of<X, Y> copysign(X const& x, Y const& y) {
    using both = detail::pair_of<X, Y>;
    both const a(x), b(y);
    if constexpr (requires { both::is_written_out(); })
        if (both::is_written_out()) return abs(a) * written_sign(b);
    return watched(detail::relation::signs_differ, a, b) ? -a : a;
}

} // namespace hilger
