// SPDX-License-Identifier: BSL-1.0
// When Newton's iteration for a step of up to four unknowns is done, each of them in its own size: in scalars that stay in registers.
#pragma once

#include <array>
#include <cstddef>

#include "hilger/inlining.hpp"
#include "hilger/newton/stop.hpp"

namespace hilger::detail {

template <class S, std::size_t N>
HILGER_ALWAYS_INLINE inline S largest(std::array<S, N> const& x) {
    using std::abs;
    S m = abs(x[0]);
    for (std::size_t k = 1; k < N; ++k) {
        S const y = abs(x[k]);
        if (m < y) m = y;
    }
    return m;
}

/// Whether all numbers are of a size: none is below a thousandth of the largest, but for zeros.
template <class S, std::size_t N>
HILGER_ALWAYS_INLINE inline bool are_alike(std::array<S, N> const& x) {
    using std::abs;
    S const most = largest(x);
    int other = 0; // without jumps
    for (std::size_t k = 0; k < N; ++k) other |= static_cast<int>(S(1024) * abs(x[k]) < most) & static_cast<int>(not(x[k] == S(0)));
    return other == 0;
}

/// 0 for a number, NaN for NaN and infinity.
template <class S>
HILGER_ALWAYS_INLINE inline S overflow(S const& x) {
    return x - x;
}
/// What Newton may leave, in units of epsilon. With compensated sums it must not be seen beside what they keep.
template <class S, bool Compensated>
HILGER_ALWAYS_INLINE inline S rest_of_newton() {
    return Compensated ? S(1) / S(1024) : S(1) / S(2);
}
/// Convergence is quadratic: after this correction the error is of the size of epsilon, in each component where they are of different
/// sizes.
template <class S, std::size_t N>
HILGER_ALWAYS_INLINE inline bool at_the_floor(std::array<S, N> const& d, std::array<S, N> const& v, S const& rest) {
    using std::abs;
    S const bound = square_root_of_epsilon<S>() * rest;
    bool const together = largest(d) <= bound * largest(v);
    if (N == 1 or not together or are_alike(v)) return together;
    bool each = true;
    for (std::size_t k = 0; k < N; ++k) each = each and abs(d[k]) <= bound * abs(v[k]);
    return each;
}
/// The same where v enters quadratically and the error is in dL/dq alone: c d is the correction of the position, `change` what it
/// does to g to first order. What it does to second order is, relative to these, of the size of c d / A: as a quotient, for the
/// squares of positions leave the range of the scalar long before positions do.
template <class S, std::size_t N>
HILGER_ALWAYS_INLINE inline bool is_negligible(S const& c, std::array<S, N> const& A, std::array<S, N> const& v, std::array<S, N> const& d,
                                               S const& w, std::array<S, N> const& g, std::array<S, N> const& change,
                                               std::array<S, N> const& p, S const& rest) {
    using std::abs;
    S const bound = epsilon<S>() * rest, g_size = largest(g), of_all = c * largest(d) / (largest(A) + c * largest(v));
    bool const together = w * of_all * (g_size * of_all + largest(change)) <= bound * (largest(p) + w * g_size);
    if (N == 1 or not together or (are_alike(p) and are_alike(A))) return together;
    S relative(0);
    for (std::size_t k = 0; k < N; ++k)
        if (S const x = c * abs(d[k]) / (abs(A[k]) + c * abs(v[k])); relative < x) relative = x; // what stands still at 0 has none
    bool each = true;
    for (std::size_t k = 0; k < N; ++k)
        each = each and w * relative * (abs(g[k]) * relative + abs(change[k])) <= bound * (abs(p[k]) + w * abs(g[k]));
    return each;
}

} // namespace hilger::detail
