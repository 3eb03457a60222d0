// SPDX-License-Identifier: BSL-1.0
// The elementary functions of jets, comparisons (which look at values, so that branches work), and what Eigen must know to make vectors of
// jets.
#pragma once

#include <Eigen/Core>

#include "hilger/inlining.hpp"
#include "hilger/mechanics/jet_arithmetic.hpp"

namespace hilger {

template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE inline jet<S, F, C, O> sin(jet<S, F, C, O> const& x) {
    using std::cos, std::sin;
    S const s = sin(x.value);
    return chain_rule(x, s, S(cos(x.value)), S(-s));
}
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE inline jet<S, F, C, O> cos(jet<S, F, C, O> const& x) {
    using std::cos, std::sin;
    S const c = cos(x.value);
    return chain_rule(x, c, S(-sin(x.value)), S(-c));
}
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE inline jet<S, F, C, O> tan(jet<S, F, C, O> const& x) {
    using std::tan;
    S const t = tan(x.value);
    S const slope = S(1) + t * t;
    return chain_rule(x, t, slope, S((t + t) * slope));
}
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE inline jet<S, F, C, O> exp(jet<S, F, C, O> const& x) {
    using std::exp;
    S const e = exp(x.value);
    return chain_rule(x, e, e, e);
}
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE inline jet<S, F, C, O> log(jet<S, F, C, O> const& x) {
    using std::log;
    S const i = S(1) / x.value;
    return chain_rule(x, S(log(x.value)), i, S(-i * i));
}
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE inline jet<S, F, C, O> sqrt(jet<S, F, C, O> const& x) {
    using std::sqrt;
    S const root = sqrt(x.value);
    S const i = S(1) / root;
    return chain_rule(x, root, i, S(i * i * i), S(S(1) / S(2)), S(S(-1) / S(2)));
}
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE inline jet<S, F, C, O> sinh(jet<S, F, C, O> const& x) {
    using std::cosh, std::sinh;
    S const s = sinh(x.value);
    return chain_rule(x, s, S(cosh(x.value)), s);
}
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE inline jet<S, F, C, O> cosh(jet<S, F, C, O> const& x) {
    using std::cosh, std::sinh;
    S const c = cosh(x.value);
    return chain_rule(x, c, S(sinh(x.value)), c);
}
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE inline jet<S, F, C, O> tanh(jet<S, F, C, O> const& x) {
    using std::tanh;
    S const t = tanh(x.value);
    S const slope = S(1) - t * t;
    return chain_rule(x, t, slope, S(-(t + t) * slope));
}
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE inline jet<S, F, C, O> asin(jet<S, F, C, O> const& x) {
    using std::asin, std::sqrt;
    S const slope = S(1) / S(sqrt(S(S(1) - x.value * x.value)));
    return chain_rule(x, S(asin(x.value)), slope, S(x.value * slope * slope * slope));
}
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE inline jet<S, F, C, O> acos(jet<S, F, C, O> const& x) {
    using std::acos, std::sqrt;
    S const slope = S(-1) / S(sqrt(S(S(1) - x.value * x.value)));
    return chain_rule(x, S(acos(x.value)), slope, S(x.value * slope * slope * slope));
}
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE inline jet<S, F, C, O> atan(jet<S, F, C, O> const& x) {
    using std::atan;
    S const slope = S(1) / S(S(1) + x.value * x.value);
    return chain_rule(x, S(atan(x.value)), slope, S(-(x.value + x.value) * slope * slope));
}
template <class S, int F, int C, int O>
HILGER_ALWAYS_INLINE inline jet<S, F, C, O> abs(jet<S, F, C, O> const& x) {
    return x.value < S(0) ? -x : x;
}
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
    S const g1 = e == S(0) ? S(0) : power(1);
    S const g2 = e == S(0) or e == S(1) ? S(0) : power(2);
    return chain_rule(x, power(0), g1, g2, e, S(e - S(1)));
}
template <class S, int F, int C, int G, int D, int O>
HILGER_ALWAYS_INLINE inline auto pow(jet<S, F, C, O> const& x, jet<S, G, D, O> const& y) {
    return exp(y * log(x));
}
/// The angle of (x, y), continuous across the axes where atan(y / x) is not.
template <class S, int F, int C, int G, int D, int O>
HILGER_ALWAYS_INLINE inline auto atan2(jet<S, F, C, O> const& y, jet<S, G, D, O> const& x) {
    using std::abs, std::atan2;
    auto angle = abs(x.value) < abs(y.value) ? -atan(x / y) : atan(y / x);
    angle.value = atan2(y.value, x.value);
    return angle;
}
template <class S, int F, int C, int G, int D, int O>
HILGER_ALWAYS_INLINE inline auto hypot(jet<S, F, C, O> const& x, jet<S, G, D, O> const& y) {
    return sqrt(x * x + y * y);
}

template <class S, int F, int C, int G, int D, int O>
constexpr bool operator==(jet<S, F, C, O> const& x, jet<S, G, D, O> const& y) {
    return x.value == y.value;
}
template <class S, int F, int C, int G, int D, int O>
constexpr bool operator<(jet<S, F, C, O> const& x, jet<S, G, D, O> const& y) {
    return x.value < y.value;
}
template <class S, int F, int C, int G, int D, int O>
constexpr bool operator>(jet<S, F, C, O> const& x, jet<S, G, D, O> const& y) {
    return y.value < x.value;
}
template <class S, int F, int C, int G, int D, int O>
constexpr bool operator<=(jet<S, F, C, O> const& x, jet<S, G, D, O> const& y) {
    return x.value <= y.value;
}
template <class S, int F, int C, int G, int D, int O>
constexpr bool operator>=(jet<S, F, C, O> const& x, jet<S, G, D, O> const& y) {
    return x.value >= y.value;
}
template <class S, int F, int C, int O, constant_for<S> K>
constexpr bool operator==(jet<S, F, C, O> const& x, K const& c) {
    return x.value == S(c);
}
template <class S, int F, int C, int O, constant_for<S> K>
constexpr auto operator<(jet<S, F, C, O> const& x, K const& c) {
    return x.value < S(c);
}
template <class S, int F, int C, int O, constant_for<S> K>
constexpr auto operator<(K const& c, jet<S, F, C, O> const& x) {
    return S(c) < x.value;
}
template <class S, int F, int C, int O, constant_for<S> K>
constexpr auto operator>(jet<S, F, C, O> const& x, K const& c) {
    return c < x;
}
template <class S, int F, int C, int O, constant_for<S> K>
constexpr auto operator>(K const& c, jet<S, F, C, O> const& x) {
    return x < c;
}
template <class S, int F, int C, int O, constant_for<S> K>
constexpr auto operator<=(jet<S, F, C, O> const& x, K const& c) {
    return x.value <= S(c);
}
template <class S, int F, int C, int O, constant_for<S> K>
constexpr auto operator>=(jet<S, F, C, O> const& x, K const& c) {
    return x.value >= S(c);
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
// A vector in q beside a vector in v makes a vector in both; beside constants it stays what it is.
template <class S, int F, int C, int G, int D, int O, class Operation>
    requires(F != G or C != D)
struct ScalarBinaryOpTraits<hilger::jet<S, F, C, O>, hilger::jet<S, G, D, O>, Operation> {
    using ReturnType = hilger::detail::hull<hilger::jet<S, F, C, O>, hilger::jet<S, G, D, O>>;
};
template <class S, int F, int C, int O, class K, class Operation>
    requires hilger::constant_for<K, S>
struct ScalarBinaryOpTraits<hilger::jet<S, F, C, O>, K, Operation> {
    using ReturnType = hilger::jet<S, F, C, O>;
};
template <class S, int F, int C, int O, class K, class Operation>
    requires hilger::constant_for<K, S>
struct ScalarBinaryOpTraits<K, hilger::jet<S, F, C, O>, Operation> {
    using ReturnType = hilger::jet<S, F, C, O>;
};

} // namespace Eigen
