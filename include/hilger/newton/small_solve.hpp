// SPDX-License-Identifier: BSL-1.0
// K x = r for at most four unknowns, in scalars that the optimiser can keep in registers: matrices known to be diagonal by division, two
// equations by their determinant if it is a normal number, all others by elimination. Also the stopping rules of Newton's iteration.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "hilger/differentiation/jet/jet.hpp"
#include "hilger/inlining.hpp"
#include "hilger/linear/elimination.hpp"
#include "hilger/newton/stop.hpp"
#include "hilger/scalar.hpp"

namespace hilger::detail {

template <std::size_t M, class S, std::size_t... I>
HILGER_ALWAYS_INLINE inline bool is_known_diagonal(std::array<S, M * M> const& K, std::index_sequence<I...>) {
    return ((I / M == I % M or is_known_zero(K[I])) and ...);
}
/// Solves by elimination. @returns false if K is singular to rounding
template <class S, std::size_t M, std::size_t MM>
bool eliminate(std::array<S, MM> const& K, std::array<S, M>& r) {
    elimination<S, static_cast<int>(M)> full(static_cast<int>(M));
    std::copy(K.begin(), K.end(), full.data().begin()); // by rows, as here
    if (not full.factorize()) return false;
    auto const unknown = [&r](int k) -> S& { return r[static_cast<std::size_t>(k)]; };
    full.solve(unknown);
    return true;
}
/// Two equations whose determinant is no normal number, as with masses of 1e+-160. By value: arguments passed by address would stay in
/// memory throughout the caller's loop.
template <class S>
struct pair_solution {
    S x, y;
    bool regular;
};
template <class S>
[[gnu::noinline, gnu::cold]] pair_solution<S> eliminate_pair(S a, S b, S c, S d, S x, S y) {
    std::array<S, 2> r{x, y};
    bool const regular = eliminate(std::array<S, 4>{a, b, c, d}, r);
    return {r[0], r[1], regular};
}
/// Below this the reciprocal of a determinant may overflow, or the determinant has lost digits.
template <class S>
S smallest_determinant() {
    if constexpr (std::numeric_limits<S>::is_exact)
        return S(0);
    else
        return S(4) * (std::numeric_limits<S>::min)();
}

/// Solves K x = r for a small row-major matrix, with x in r. @returns false if K is singular to rounding, or not finite
template <class S, std::size_t M, std::size_t MM>
HILGER_ALWAYS_INLINE inline bool small_solve(std::array<S, MM> const& K, std::array<S, M>& r) {
    using std::abs;
    if constexpr (M == 1) {
        if (not is_divisor(K[0])) return false;
        r[0] = r[0] / K[0];
        return true;
    } else if constexpr (M == 2) {
        S const ad = K[0] * K[3], bc = times(K[1], K[2]);
        S const det = minus(ad, bc);
        if (not(epsilon<S>() * (abs(ad) + abs(bc)) + smallest_determinant<S>() < abs(det))) [[unlikely]] {
            auto const z = eliminate_pair<S>(K[0], K[1], K[2], K[3], r[0], r[1]);
            r = {z.x, z.y};
            return z.regular;
        }
        S const i = S(1) / det;
        S const x = minus(S(K[3] * r[0]), times(K[1], r[1])), y = minus(S(K[0] * r[1]), times(K[2], r[0]));
        r[0] = x * i;
        r[1] = y * i;
        return true;
    } else {
        if (is_known_diagonal<M>(K, std::make_index_sequence<MM>{})) { // a mass for each component, under order one
            for (std::size_t k = 0; k < M; ++k) {
                if (not is_divisor(K[k * M + k])) return false;
                r[k] = r[k] / K[k * M + k];
            }
            return true;
        }
        return eliminate(K, r);
    }
}

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

/// Whether no number but zeros is below 1/1024 of the largest.
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
/// Admissible remainder of Newton's method, in units of epsilon. Compensated sums must not show it.
template <class S, bool Compensated>
HILGER_ALWAYS_INLINE inline S rest_of_newton() {
    return Compensated ? S(1) / S(1024) : S(1) / S(2);
}
/// Whether the error after this correction is of order epsilon, as convergence is quadratic: in each component if their sizes differ.
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
/// The same if v enters quadratically and the error is in dL/dq alone: c d is the correction of the position, `change` its effect on g to
/// first order. Relative to these its second-order effect is of the size of c d / A: a quotient, for the squares of positions leave the
/// range of the scalar long before positions do.
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
        if (S const x = c * abs(d[k]) / (abs(A[k]) + c * abs(v[k])); relative < x) relative = x; // 0 for a component at rest at 0
    bool each = true;
    for (std::size_t k = 0; k < N; ++k)
        each = each and w * relative * (abs(g[k]) * relative + abs(change[k])) <= bound * (abs(p[k]) + w * abs(g[k]));
    return each;
}

} // namespace hilger::detail
