// SPDX-License-Identifier: BSL-1.0
// The elementary functions of jets, and Eigen's traits for vectors of jets.
#pragma once

#include <Eigen/Core>

#include "hilger/differentiation/functions.hpp"
#include "hilger/differentiation/jet/arithmetic.hpp"
#include "hilger/differentiation/jet/pairs.hpp"
#include "hilger/inlining.hpp"
#include "hilger/scalar.hpp"

namespace hilger {

#define HILGER_JET_FUNCTION(function)                                                                                                      \
    template <class S, int F, int C, int O>                                                                                                \
    HILGER_ALWAYS_INLINE inline jet<S, F, C, O> function(jet<S, F, C, O> const& x) {                                                       \
        using rule = detail::function##_function;                                                                                          \
        S const y = rule::value(x.value), s = rule::slope(x.value, y);                                                                     \
        return chain_rule(x, y, s, rule::bend(x.value, y, s));                                                                             \
    }
HILGER_FOR_EACH_FUNCTION(HILGER_JET_FUNCTION)
#undef HILGER_JET_FUNCTION

namespace detail {
/// Whether all derivatives vanish, as at the bottom of a sum of squares.
template <class S, int F, int C, int O, int... K>
HILGER_ALWAYS_INLINE inline bool is_level(jet<S, F, C, O> const& x, std::integer_sequence<int, K...>) {
    return ((x.template by<F + K>() == S(0)) and ...);
}
} // namespace detail
/// At v = 0 the slope of |v| = sqrt(v v) is set to 0, the mean of its slopes: a drag |v| v then has its derivatives at rest.
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE inline jet<S, F, C, O> sqrt(jet<S, F, C, O> const& x) {
    using std::sqrt;
    S const root = sqrt(x.value);
    S i = S(1) / root;
    if (root == S(0)) [[unlikely]]
        if (detail::is_level(x, std::make_integer_sequence<int, C>{})) i = S(0);
    return chain_rule(x, root, i, S(i * i * i), S(S(1) / S(2)), S(S(-1) / S(2)));
}
namespace detail {
/// c g(x) for a finite g' and an infinite c r g'': the second derivative is infinite for variables of x, and for no others.
template <class S, int F, int C, int O>
[[gnu::noinline, gnu::cold]] jet<S, F, C, O> bent_sharply(jet<S, F, C, O> const& x, S const& value, S const& slope, S const& bend) {
    jet<S, F, C, O> z(value);
    z.on = x.on.of_function();
    auto const in = [](auto& list, int k) -> S& { return list[static_cast<std::size_t>(k)]; };
    for (int j = 0, n = 0; j < C; ++j) {
        S const by_j = x.derivative(F + j);
        in(z.d1, j) = slope * by_j;
        if constexpr (O == 2)
            for (int k = 0; k <= j; ++k, ++n) {
                S const by_k = x.derivative(F + k);
                in(z.d2, n) = slope * x.derivative(F + j, F + k);
                if (not(by_j == S(0)) and not(by_k == S(0))) in(z.d2, n) = in(z.d2, n) + bend * by_j * by_k;
            }
    }
    return z;
}
} // namespace detail
/// x^n with a whole n is exact for every x; other powers need x > 0.
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE inline jet<S, F, C, O> pow(jet<S, F, C, O> const& x, K const& exponent) {
    using std::pow;
    auto power = [&](int less) {
        if constexpr (std::is_integral_v<K>) {
            S y(1);
            long long const n = static_cast<long long>(exponent) - less;
            for (long long k = 0; k < (n < 0 ? -n : n); ++k) y = y * x.value;
            return n < 0 ? S(S(1) / y) : y;
        } else
            return S(pow(x.value, S(S(exponent) - S(less))));
    };
    S const e(exponent);
    // The factor is zero exactly where x^(n-1) or x^(n-2) would be 1/0 at x = 0.
    S g1 = e == S(0) ? S(0) : power(1);
    S g2 = e == S(0) or e == S(1) ? S(0) : power(2);
    if constexpr (not std::is_integral_v<K>)
        if (x.value == S(0)) [[unlikely]] { // as sqrt
            if (not hilger::is_finite(g1) and detail::is_level(x, std::make_integer_sequence<int, C>{})) g1 = S(0);
            if (hilger::is_finite(g1) and not hilger::is_finite(g2))
                return detail::bent_sharply(x, power(0), S(e * g1), S(e * S(e - S(1)) * g2));
        }
    return chain_rule(x, power(0), g1, g2, e, S(e - S(1)));
}
template <class S, int F, int C, int G, int D, int O>
HILGER_ALWAYS_INLINE inline auto pow(jet<S, F, C, O> const& x, jet<S, G, D, O> const& y) {
    return exp(y * log(x));
}
template <class S, int F, int C, int O, constant_for<S> K>
HILGER_ALWAYS_INLINE inline jet<S, F, C, O> pow(K const& base, jet<S, F, C, O> const& x) {
    using std::log, std::pow;
    S const b(base);
    S const p = pow(b, x.value);
    S const slope = p == S(0) ? S(0) : S(p * S(log(b))); // 0^x is 0 for all x > 0
    return chain_rule(x, p, slope, p == S(0) ? S(0) : S(slope * S(log(b))));
}

} // namespace hilger

namespace Eigen {

template <class S, int F, int C, int O>
struct NumTraits<hilger::jet<S, F, C, O>> : NumTraits<S> {
    using Real = hilger::jet<S, F, C, O>;
    using NonInteger = Real;
    using Nested = Real;
    using Literal = typename NumTraits<S>::Literal;
    enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1, ReadCost = C + 1, AddCost = C + 1, MulCost = 3 * C + 1 };
};

} // namespace Eigen
