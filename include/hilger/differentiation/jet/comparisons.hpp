// SPDX-License-Identifier: BSL-1.0
// Comparisons of jets look at values, so that branches work, and write down how they came out (differentiation/branches.hpp); and the
// functions that are made of branches. Where both sides are equal, a function has the derivative of the side that it returns, which is the
// one that std::max and its like return.
#pragma once

#include "hilger/differentiation/branches.hpp"
#include "hilger/differentiation/jet/arithmetic.hpp"
#include "hilger/inlining.hpp"

namespace hilger {

template <class S, int F, int C, int G, int D, int O>
HILGER_ALWAYS_INLINE constexpr bool operator==(jet<S, F, C, O> const& x, jet<S, G, D, O> const& y) {
    return detail::compared(x.value == y.value, x.on.v > 0 or y.on.v > 0);
}
template <class S, int F, int C, int G, int D, int O>
HILGER_ALWAYS_INLINE constexpr bool operator<(jet<S, F, C, O> const& x, jet<S, G, D, O> const& y) {
    return detail::compared(x.value<y.value, x.on.v> 0 or y.on.v > 0);
}
template <class S, int F, int C, int G, int D, int O>
HILGER_ALWAYS_INLINE constexpr bool operator>(jet<S, F, C, O> const& x, jet<S, G, D, O> const& y) {
    return y < x;
}
template <class S, int F, int C, int G, int D, int O>
HILGER_ALWAYS_INLINE constexpr bool operator<=(jet<S, F, C, O> const& x, jet<S, G, D, O> const& y) {
    return detail::compared(x.value <= y.value, x.on.v > 0 or y.on.v > 0);
}
template <class S, int F, int C, int G, int D, int O>
HILGER_ALWAYS_INLINE constexpr bool operator>=(jet<S, F, C, O> const& x, jet<S, G, D, O> const& y) {
    return y <= x;
}
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE constexpr bool operator==(jet<S, F, C, O> const& x, K const& c) {
    return detail::compared(x.value == S(c), x.on.v > 0);
}
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE constexpr bool operator<(jet<S, F, C, O> const& x, K const& c) {
    return detail::compared(x.value<S(c), x.on.v> 0);
}
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE constexpr bool operator>(jet<S, F, C, O> const& x, K const& c) {
    return detail::compared(S(c) < x.value, x.on.v > 0);
}
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE constexpr bool operator<=(jet<S, F, C, O> const& x, K const& c) {
    return detail::compared(x.value <= S(c), x.on.v > 0);
}
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE constexpr bool operator>=(jet<S, F, C, O> const& x, K const& c) {
    return detail::compared(S(c) <= x.value, x.on.v > 0);
}
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE constexpr bool operator<(K const& c, jet<S, F, C, O> const& x) {
    return x > c;
}
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE constexpr bool operator>(K const& c, jet<S, F, C, O> const& x) {
    return x < c;
}
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE constexpr bool operator<=(K const& c, jet<S, F, C, O> const& x) {
    return x >= c;
}
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE constexpr bool operator>=(K const& c, jet<S, F, C, O> const& x) {
    return x <= c;
}

namespace detail {

/// The jet in the variables of both, one of which may be a constant.
template <class X, class Y>
struct pair_of_jets_ {};
template <class S, int F, int C, int G, int D, int O>
struct pair_of_jets_<jet<S, F, C, O>, jet<S, G, D, O>> : hull_<jet<S, F, C, O>, jet<S, G, D, O>> {};
template <class S, int F, int C, int O, constant_for<S> K>
struct pair_of_jets_<jet<S, F, C, O>, K> {
    using type = jet<S, F, C, O>;
};
template <class S, int F, int C, int O, constant_for<S> K>
struct pair_of_jets_<K, jet<S, F, C, O>> {
    using type = jet<S, F, C, O>;
};
template <class X, class Y>
using pair_of_jets = typename pair_of_jets_<X, Y>::type;

} // namespace detail

template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE constexpr jet<S, F, C, O> abs(jet<S, F, C, O> const& x) {
    return x < S(0) ? -x : x;
}
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE constexpr jet<S, F, C, O> fabs(jet<S, F, C, O> const& x) {
    return abs(x);
}
template <class X, class Y>
HILGER_ALWAYS_INLINE constexpr detail::pair_of_jets<X, Y> max(X const& x, Y const& y) {
    using both = detail::pair_of_jets<X, Y>;
    return x < y ? both(y) : both(x);
}
template <class X, class Y>
HILGER_ALWAYS_INLINE constexpr detail::pair_of_jets<X, Y> min(X const& x, Y const& y) {
    using both = detail::pair_of_jets<X, Y>;
    return y < x ? both(y) : both(x);
}
/// max and min, but of a number and NaN the number.
template <class X, class Y>
HILGER_ALWAYS_INLINE constexpr detail::pair_of_jets<X, Y> fmax(X const& x, Y const& y) {
    using both = detail::pair_of_jets<X, Y>;
    both const a(x), b(y);
    return x < y or a.value != a.value ? b : a;
}
template <class X, class Y>
HILGER_ALWAYS_INLINE constexpr detail::pair_of_jets<X, Y> fmin(X const& x, Y const& y) {
    using both = detail::pair_of_jets<X, Y>;
    both const a(x), b(y);
    return y < x or a.value != a.value ? b : a;
}
/// |x| with the sign of y.
template <class X, class Y>
HILGER_ALWAYS_INLINE constexpr detail::pair_of_jets<X, Y> copysign(X const& x, Y const& y) {
    using both = detail::pair_of_jets<X, Y>;
    both const a(x), b(y);
    bool const turned = detail::compared(detail::has_minus_sign(a.value) != detail::has_minus_sign(b.value), a.on.v > 0 or b.on.v > 0);
    return turned ? -a : a;
}

} // namespace hilger
