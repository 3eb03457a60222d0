// SPDX-License-Identifier: BSL-1.0
// Sums and products together with their rounding errors (Moeller 1965, Dekker 1971, Knuth): x + y = sum + rest and x y = product + rest,
// exactly but for overflow and underflow. They hold also where the compiler contracts a b + c into one operation that rounds once
// (-march=native, -mfma, -ffp-contract=fast; always on aarch64): products that must be rounded are protected from that. A sum has no
// product in it; where x or y is one that the compiler did not round, rest is off by epsilon^2 |sum| at most (Boldo, Graillat, Muller 2017:
// the sum need not be the nearest number).
#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>

#include "hilger/inlining.hpp"

namespace hilger::detail {

/// sum + rest = x + y for any two numbers or vectors. sum and rest may be x and y.
template <class V>
HILGER_ALWAYS_INLINE constexpr void two_sum(V const& x, V const& y, V& sum, V& rest) {
    V const z = x + y, part = z - x;
    rest = (x - (z - part)) + (y - part);
    sum = z;
}
/// The same for |x| >= |y|; else rest is rounded.
template <class V>
HILGER_ALWAYS_INLINE constexpr void fast_two_sum(V const& x, V const& y, V& sum, V& rest) {
    V const z = x + y;
    rest = y - (z - x);
    sum = z;
}

/// x rounded, hidden from the compiler's contractions.
template <std::floating_point S>
HILGER_ALWAYS_INLINE constexpr S rounded(S x) {
    if (std::is_constant_evaluated()) return x;
#if defined(__GNUC__) && (defined(__x86_64__) || defined(__aarch64__))
    if constexpr (sizeof(S) <= 8) { // wider ones have no contracted operation there
#if defined(__x86_64__)
        asm("" : "+x"(x));
#else
        asm("" : "+w"(x));
#endif
    }
    return x;
#else
    S volatile kept = x;
    return kept;
#endif
}

/// Whether fma is an instruction; else it is a slow function.
template <class S>
inline constexpr bool has_fused_product =
#if defined(__FP_FAST_FMA) || defined(__FMA__) || defined(__ARM_FEATURE_FMA)
    std::is_same_v<S, double> or std::is_same_v<S, float>;
#else
    false;
#endif

/// product + rest = x y: by one fused operation, or by splitting both into halves (Veltkamp, Dekker) whose products are exact.
template <std::floating_point S>
constexpr void two_product(S const& x, S const& y, S& product, S& rest) {
    S const p = rounded(S(x * y));
    if (has_fused_product<S> and not std::is_constant_evaluated())
        rest = std::fma(x, y, -p);
    else {
        constexpr int digits = std::numeric_limits<S>::digits;
        constexpr S factor = static_cast<S>((1ULL << ((digits + 1) / 2)) + 1);
        S const a = rounded(S(factor * x)), b = rounded(S(factor * y));
        S const x1 = a - (a - x), x2 = x - x1, y1 = b - (b - y), y2 = y - y1;
        rest = ((x1 * y1 - p) + x1 * y2 + x2 * y1) + x2 * y2;
    }
    product = p;
}

} // namespace hilger::detail
