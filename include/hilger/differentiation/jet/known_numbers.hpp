// SPDX-License-Identifier: BSL-1.0
// Sums and products of numbers of which a compiler may see that they are 0 or 1. IEEE rules forbid it to drop 0 * x and 0 + x; derivatives
// are full of zeros that are exact.
#pragma once

#include <concepts>
#include <type_traits>

#include "hilger/inlining.hpp"

namespace hilger::detail {

/// Numbers that say themselves what a compiler sees of them, as those that count their operations.
template <class S>
concept says_what_is_constant = requires(S const& x) {
    { x.is_constant() } -> std::same_as<bool>;
};
/// Whether x is a constant that the compiler can see; of other scalars, whose zeros are looked for when a program runs, true.
template <class S>
HILGER_ALWAYS_INLINE constexpr bool is_seen([[maybe_unused]] S const& x) {
    if constexpr (std::is_floating_point_v<S>)
        return __builtin_constant_p(x);
    else if constexpr (says_what_is_constant<S>)
        return x.is_constant();
    else
        return true;
}
template <class S>
HILGER_ALWAYS_INLINE constexpr bool is_known_zero(S const& x) {
    if constexpr (requires { x.is_zero(); }) // many digits: nothing is made to compare with
        return is_seen(x) and x.is_zero();
    else
        return is_seen(x) and x == S(0);
}
template <class S>
HILGER_ALWAYS_INLINE constexpr bool is_known_one(S const& x) {
    return is_seen(x) and x == S(1);
}
/// Both are one constant that the compiler can see.
template <class S>
HILGER_ALWAYS_INLINE constexpr bool is_one_constant(S const& x, S const& y) {
    if constexpr (std::is_floating_point_v<S> or says_what_is_constant<S>)
        return is_seen(x) and is_seen(y) and x == y;
    else
        return false;
}
/// Whether to look for numbers that are known is worth the calls.
template <class S>
inline constexpr bool knows_numbers = numbers_are_known or not std::is_floating_point_v<S>;
template <class S>
HILGER_ALWAYS_INLINE constexpr S times(S const& x, S const& y) {
    if constexpr (knows_numbers<S>) {
        if (is_known_zero(x) or is_known_zero(y)) return S(0);
        if (is_known_one(x)) return y;
        if (is_known_one(y)) return x;
    }
    return x * y;
}
template <class S>
HILGER_ALWAYS_INLINE constexpr S plus(S const& x, S const& y) {
    if constexpr (knows_numbers<S>) {
        if (is_known_zero(x)) return y;
        if (is_known_zero(y)) return x;
    }
    return x + y;
}
template <class S>
HILGER_ALWAYS_INLINE constexpr S minus(S const& x, S const& y) {
    if constexpr (knows_numbers<S>) {
        if (is_known_zero(y)) return x;
        if (is_known_zero(x)) return -y;
    }
    return x - y;
}

} // namespace hilger::detail
