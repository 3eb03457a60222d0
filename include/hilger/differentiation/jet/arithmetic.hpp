// SPDX-License-Identifier: BSL-1.0
// The four operations on jets and constants. All derivatives of a result are one expression: optimisers see less through loops and lambdas.
#pragma once

#include "hilger/differentiation/comparisons.hpp"
#include "hilger/differentiation/jet/jet.hpp"

namespace hilger {

namespace detail {

/// Row and column of the n-th entry of a lower triangle.
constexpr int row(int n) {
    int j = 0;
    while ((j + 1) * (j + 2) / 2 <= n) ++j;
    return j;
}
constexpr int column(int n) { return n - row(n) * (row(n) + 1) / 2; }

/// A jet whose derivatives are given by a rule: Rule::by<J>(arguments...) and Rule::by<J, K>(arguments...).
template <class Jet, class Rule>
struct build {
    template <class... Arguments>
    HILGER_ALWAYS_INLINE static constexpr Jet from(typename Jet::scalar_type const& value, dependence on, Arguments const&... arguments) {
        return expand(std::make_integer_sequence<int, Jet::count>{}, std::make_integer_sequence<int, Jet::packed>{}, value, on,
                      arguments...);
    }

private:
    template <int... J, int... N, class... Arguments>
    HILGER_ALWAYS_INLINE static constexpr Jet expand(std::integer_sequence<int, J...>, std::integer_sequence<int, N...>,
                                                     typename Jet::scalar_type const& value, dependence on, Arguments const&... arguments) {
        return {value,
                {Rule::template by<Jet::first + J>(arguments...)...},
                {Rule::template by<Jet::first + row(N), Jet::first + column(N)>(arguments...)...},
                on};
    }
};

struct widened {
    template <int... JK, class X>
    HILGER_ALWAYS_INLINE static constexpr auto by(X const& x) {
        return x.template by<JK...>();
    }
};
/// x + y; with a common factor left out, x / c + y / c.
struct added {
    template <int... JK, class X, class Y>
    HILGER_ALWAYS_INLINE static constexpr auto by(X const& x, Y const& y, bool common) {
        return common ? plus(x.template unscaled<JK...>(), y.template unscaled<JK...>())
                      : plus(x.template by<JK...>(), y.template by<JK...>());
    }
};
struct multiplied {
    template <int J, class X, class Y>
    HILGER_ALWAYS_INLINE static constexpr auto by(X const& x, Y const& y) {
        return plus(times(x.template by<J>(), y.value), times(x.value, y.template by<J>()));
    }
    template <int J, int K, class X, class Y>
    HILGER_ALWAYS_INLINE static constexpr auto by(X const& x, Y const& y) {
        return plus(plus(times(x.value, y.template by<J, K>()), times(x.template by<J>(), y.template by<K>())),
                    plus(times(x.template by<J, K>(), y.value), times(x.template by<K>(), y.template by<J>())));
    }
};

/// Two jets make one in the variables of both.
template <class S, int F, int C, int G, int D, int O>
struct pair_of_<jet<S, F, C, O>, jet<S, G, D, O>> {
    static constexpr int first = std::min(F, G), last = std::max(F + C, G + D);
    using type = jet<S, first, last - first, O>;
};

} // namespace detail

template <class S, int First, int Count, int Order>
template <int F, int C>
    requires(F >= First and F + C <= First + Count and C < Count)
constexpr jet<S, First, Count, Order>::jet(jet<S, F, C, Order> const& x)
    : jet(detail::build<jet, detail::widened>::from(x.value, x.on, x)) {}

/// c x
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE constexpr jet<S, F, C, O> scaled_by(jet<S, F, C, O> x, S const& image, S const& c) {
    x.value = image;
    x.factor = detail::times(x.factor, c);
    return x;
}
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE constexpr jet<S, F, C, O> operator-(jet<S, F, C, O> const& x) {
    return scaled_by(x, S(-x.value), S(-1));
}
template <class S, int F, int C, int G, int D, int O>
HILGER_ALWAYS_INLINE constexpr auto operator+(jet<S, F, C, O> const& x, jet<S, G, D, O> const& y) {
    using both = detail::pair_of<jet<S, F, C, O>, jet<S, G, D, O>>;
    // One constant factor stays a factor: the derivative of (x x + y y) / 2 is then x, and not 2 x / 2.
    bool const common = detail::is_one_constant(x.constant(), y.constant());
    both z = detail::build<both, detail::added>::from(S(x.value + y.value), x.on + y.on, x, y, common);
    z.factor = common ? x.constant() : S(1);
    return z;
}
template <class S, int F, int C, int G, int D, int O>
HILGER_ALWAYS_INLINE constexpr auto operator-(jet<S, F, C, O> const& x, jet<S, G, D, O> const& y) {
    return x + (-y);
}
/// g(x) for given g, g' = c g1 and g'' = c r g2: constants are kept apart, so that they meet other constants first.
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE constexpr jet<S, F, C, O> chain_rule(jet<S, F, C, O> x, S const& g, S const& g1, S const& g2, S const& c = S(1),
                                                          S const& r = S(1)) {
    using detail::plus, detail::times;
    x.value = g;
    x.slope = times(x.outer, x.slope);
    if constexpr (O == 2) x.bend = plus(times(g1, x.bend), times(times(r, x.constant()), times(g2, times(x.slope, x.slope))));
    x.outer = g1;
    x.factor = times(c, x.constant());
    x.power = 1;
    x.which = -1;
    x.on = x.on.of_function();
    return x;
}

namespace detail {

/// Whether x is a power of a variable and y that variable.
template <class Jet>
HILGER_ALWAYS_INLINE constexpr bool is_power_of(Jet const& x, Jet const& y) {
    return x.which >= 0 and x.which == y.which and y.power == 1 and is_known_one(y.factor);
}
/// x y where x is a power of the variable y
template <class Jet>
HILGER_ALWAYS_INLINE constexpr Jet next_power(Jet const& x, Jet const& y) {
    using S = typename Jet::scalar_type;
    Jet z = x;
    z.value = x.value * y.value;
    z.slope = times(x.slope, y.value);
    z.bend = times(S(x.power), x.slope);
    z.power = x.power + 1;
    z.on = x.on * y.on;
    return z;
}

} // namespace detail

template <class S, int F, int C, int G, int D, int O>
HILGER_ALWAYS_INLINE constexpr auto operator*(jet<S, F, C, O> const& x, jet<S, G, D, O> const& y) {
    if constexpr (std::same_as<jet<S, F, C, O>, jet<S, G, D, O>>) {
        if (detail::is_power_of(x, y)) return detail::next_power(x, y);
        if (detail::is_power_of(y, x)) return detail::next_power(y, x);
        if (&x == &y) {
            auto z = chain_rule(x, S(x.value * x.value), x.value, S(1), S(2));
            z.on = x.on * x.on;
            return z;
        }
    }
    return detail::build<detail::pair_of<jet<S, F, C, O>, jet<S, G, D, O>>, detail::multiplied>::from(S(x.value * y.value), x.on * y.on, x,
                                                                                                      y);
}
/// 1 / x
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE constexpr jet<S, F, C, O> inverse(jet<S, F, C, O> const& x) {
    S const i = S(1) / x.value;
    S const ii = i * i;
    return chain_rule(x, i, ii, S(ii * i), S(-1), S(-2));
}
// The value of a quotient is rounded once, as in plain numbers and traced formulas: comparisons take the same branch in all of them.
template <class S, int F, int C, int G, int D, int O>
HILGER_ALWAYS_INLINE constexpr auto operator/(jet<S, F, C, O> const& x, jet<S, G, D, O> const& y) {
    auto z = x * inverse(y);
    z.value = x.value / y.value;
    return z;
}

// Constants: whole numbers and doubles meet wide scalars exactly as the user wrote them.
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE constexpr jet<S, F, C, O> operator+(jet<S, F, C, O> x, K const& c) {
    x.value = x.value + S(c);
    x.which = -1;
    return x;
}
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE constexpr jet<S, F, C, O> operator+(K const& c, jet<S, F, C, O> const& x) {
    return x + c;
}
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE constexpr jet<S, F, C, O> operator-(jet<S, F, C, O> x, K const& c) {
    x.value = x.value - S(c);
    x.which = -1;
    return x;
}
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE constexpr jet<S, F, C, O> operator-(K const& c, jet<S, F, C, O> const& x) {
    return -x + c;
}
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE constexpr jet<S, F, C, O> operator*(jet<S, F, C, O> const& x, K const& c) {
    return scaled_by(x, S(x.value * S(c)), S(c));
}
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE constexpr jet<S, F, C, O> operator*(K const& c, jet<S, F, C, O> const& x) {
    return x * c;
}
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE constexpr jet<S, F, C, O> operator/(jet<S, F, C, O> const& x, K const& c) {
    return scaled_by(x, S(x.value / S(c)), S(S(1) / S(c)));
}
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE constexpr jet<S, F, C, O> operator/(K const& c, jet<S, F, C, O> const& x) {
    auto z = inverse(x) * c;
    if (S const n(c); not detail::is_known_one(n)) z.value = n / x.value;
    return z;
}

} // namespace hilger
