// SPDX-License-Identifier: BSL-1.0
// Whole numbers that a user gives where a scalar is wanted: 0 for 0.0. Each has an equal in a rational or a wide scalar; float and double
// have those whose odd part is below 2^24 or 2^53, and the others are refused.
#pragma once

#include <optional>

#include "hilger/error.hpp"
#include "hilger/scalar.hpp"

namespace hilger::detail {

/// x as a number of S. @throws error::invalid_parameter for a whole number that has no equal in S
template <class S, class X>
constexpr S exactly(X const& x) {
    constexpr int digits = std::numeric_limits<S>::digits;
    if constexpr (not std::same_as<X, S> and std::numeric_limits<X>::is_integer and not std::numeric_limits<S>::is_exact and digits > 0 and
                  digits < std::numeric_limits<X>::digits) {
        X odd = x;
        if (not(odd == X(0)))
            while (odd % X(2) == X(0)) odd = odd / X(2);
        X const most = X(1) << digits;
        bool below = false;
        if constexpr (std::numeric_limits<X>::is_signed) below = odd < -most;
        if (below or most < odd)
            error::raise<error::invalid_parameter>("the whole number ", x, " has no equal in this scalar, which has all of them up to 2^",
                                                   digits);
    }
    if constexpr (std::integral<X>)
        return S(static_cast<std::conditional_t<std::is_signed_v<X>, long long, unsigned long long>>(x));
    else
        return S(x);
}

template <class N>
concept arithmetic = std::is_arithmetic_v<N> and not std::same_as<N, bool>;

/// A count given as a floating number, as 1e6; nothing where it is not whole, as a rounded b/h may be.
template <arithmetic N>
constexpr std::optional<index_type> whole(N count) {
    if constexpr (std::floating_point<N>)
        if (not(count > N(-9e18)) or not(count < N(9e18)) or not(static_cast<N>(static_cast<index_type>(count)) == count))
            return std::nullopt;
    return static_cast<index_type>(count);
}

} // namespace hilger::detail
