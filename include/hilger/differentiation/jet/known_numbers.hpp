// SPDX-License-Identifier: BSL-1.0
// Sums and products of numbers that a compiler may know to be 0 or 1. IEEE rules forbid it to drop 0 * x and 0 + x for these.
#pragma once

#include <concepts>
#include <type_traits>

#include "hilger/inlining.hpp"

namespace hilger::detail {

/// Numbers that tell whether a compiler sees them as constants, as those that count operations.
template <class S>
concept says_what_is_constant = requires(S const& x) {
    { x.is_constant() } -> std::same_as<bool>;
};
/// Whether the compiler sees x as a constant; true for other scalars, whose zeros are found at run time.
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
/// Whether the compiler sees both as the same constant.
template <class S>
HILGER_ALWAYS_INLINE constexpr bool is_one_constant(S const& x, S const& y) {
    if constexpr (std::is_floating_point_v<S> or says_what_is_constant<S>)
        return is_seen(x) and is_seen(y) and x == y;
    else
        return false;
}
/// Whether checks for known numbers are worth the calls.
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
