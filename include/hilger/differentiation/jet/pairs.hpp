// SPDX-License-Identifier: BSL-1.0
// Two jets, or a jet and a constant: comparisons, and functions f(x, y) by their five derivatives.
#pragma once

#include "hilger/differentiation/jet/arithmetic.hpp"
#include "hilger/inlining.hpp"

namespace hilger {

namespace detail {

template <class S, class X>
HILGER_ALWAYS_INLINE constexpr decltype(auto) value_in(X const& x) {
    if constexpr (is_jet<X>)
        return (x.value);
    else
        return S(x);
}
template <class X>
HILGER_ALWAYS_INLINE constexpr bool reads_velocity(X const& x) {
    if constexpr (is_jet<X>)
        return x.on.v > 0;
    else
        return false;
}
template <class X, class Y>
requires is_jet<pair_of<X, Y>> HILGER_ALWAYS_INLINE constexpr bool watched(relation how, X const& x, Y const& y) {
    using S = typename pair_of<X, Y>::scalar_type;
    return compared(holds<S>(how, value_in<S>(x), value_in<S>(y)), reads_velocity(x) or reads_velocity(y));
}

template <class S>
struct derivatives_of_two {
    S x, y, xx, xy, yy;
};
struct of_two {
    template <int J, class X, class P>
    HILGER_ALWAYS_INLINE static constexpr auto by(X const& x, X const& y, P const& f) {
        return plus(times(f.x, x.template by<J>()), times(f.y, y.template by<J>()));
    }
    template <int J, int K, class X, class P>
    HILGER_ALWAYS_INLINE static constexpr auto by(X const& x, X const& y, P const& f) {
        auto const xj = x.template by<J>(), yj = y.template by<J>();
        return plus(plus(times(f.x, x.template by<J, K>()), times(f.y, y.template by<J, K>())),
                    plus(times(plus(times(f.xx, xj), times(f.xy, yj)), x.template by<K>()),
                         times(plus(times(f.xy, xj), times(f.yy, yj)), y.template by<K>())));
    }
};
template <class Jet, class S>
HILGER_ALWAYS_INLINE constexpr Jet function_of_two(Jet const& x, Jet const& y, S const& value, derivatives_of_two<S> const& f) {
    return build<Jet, of_two>::from(value, (x.on + y.on).of_function(), x, y, f);
}

} // namespace detail

/// sqrt(x^2 + y^2), also if the squares overflow. Its slopes at 0 are set to 0, as those of sqrt(x x + y y).
template <class X, class Y>
requires is_jet<detail::pair_of<X, Y>> HILGER_ALWAYS_INLINE inline detail::pair_of<X, Y> hypot(X const& x, Y const& y) {
    using std::hypot;
    using both = detail::pair_of<X, Y>;
    using S = typename both::scalar_type;
    both const a(x), b(y);
    S const r = hypot(a.value, b.value), by = r == S(0) ? S(1) : r, c = a.value / by, s = b.value / by;
    return detail::function_of_two(a, b, r, {c, s, S(s * s / by), S(-c * s / by), S(c * c / by)});
}
/// The angle of (x, y), continuous across the axes where atan(y / x) is not.
template <class X, class Y>
requires is_jet<detail::pair_of<X, Y>> HILGER_ALWAYS_INLINE inline detail::pair_of<X, Y> atan2(Y const& y, X const& x) {
    using std::atan2, std::hypot;
    using both = detail::pair_of<X, Y>;
    using S = typename both::scalar_type;
    both const a(x), b(y);
    S const r = hypot(a.value, b.value);
    S const c = a.value / r, s = b.value / r;
    S const dx = -s / r, dy = c / r; // squares of r may overflow
    S const twice = S(-2) * dx * dy;
    return detail::function_of_two(a, b, S(atan2(b.value, a.value)), {dx, dy, twice, S((dx - dy) * (dx + dy)), S(-twice)});
}

} // namespace hilger
