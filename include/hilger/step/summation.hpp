// SPDX-License-Identifier: BSL-1.0
// How the increments of a step are added to the state: as they are, or compensated, where what rounding cuts off is kept and added with the
// next increment (Kahan, in the form that is exact for every two summands).
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "hilger/error_free.hpp"
#include "hilger/inlining.hpp"

namespace hilger {

/// How a flow adds up its steps.
enum class sums { plain, compensated };
inline constexpr std::integral_constant<sums, sums::compensated> compensated{};

} // namespace hilger

namespace hilger::detail {

/// For states of dimension N, or Eigen::Dynamic.
template <bool Compensated, class S, int N>
struct summation {
    constexpr explicit summation(int = N) {}
    HILGER_ALWAYS_INLINE static void add(S& x, S const& increment, int) { x = x + increment; }
    template <class Visit>
    static void visit(Visit&) {}
};

template <class S, int N>
struct summation<true, S, N> {
    std::conditional_t<N == Eigen::Dynamic, std::vector<S>, std::array<S, static_cast<std::size_t>(N < 0 ? 1 : N)>> rest{};

    explicit summation(int d = N) {
        if constexpr (N == Eigen::Dynamic) rest.assign(static_cast<std::size_t>(d), S(0));
    }
    HILGER_ALWAYS_INLINE void add(S& x, S const& increment, int k) {
        S& carry = rest[static_cast<std::size_t>(k)];
        two_sum(x, S(increment + carry), x, carry);
    }
    /// Everything that later sums depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        for (S& carry : rest) each("carry", carry);
    }
};

} // namespace hilger::detail
