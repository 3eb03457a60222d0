// SPDX-License-Identifier: BSL-1.0
// K x = r for at most four unknowns, in scalars that the optimiser can put into registers: what is known to be diagonal is divided, two
// equations are solved by their determinant where it is a normal number, and all others by elimination.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
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
/// By elimination; false where K is singular to rounding.
template <class S, std::size_t M, std::size_t MM>
bool eliminate(std::array<S, MM> const& K, std::array<S, M>& r) {
    elimination<S, static_cast<int>(M)> full(static_cast<int>(M));
    std::copy(K.begin(), K.end(), full.data().begin()); // by rows, as here
    if (not full.factorize()) return false;
    auto const unknown = [&r](int k) -> S& { return r[static_cast<std::size_t>(k)]; };
    full.solve(unknown);
    return true;
}
/// Two equations whose determinant is no normal number, as with masses of 1e+-160. By value: what a loop hands over by address is in
/// memory in all of its rounds.
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
/// Below it the reciprocal of a determinant may overflow, or the determinant has lost digits itself.
template <class S>
S smallest_determinant() {
    if constexpr (std::numeric_limits<S>::is_exact)
        return S(0);
    else
        return S(4) * (std::numeric_limits<S>::min)();
}

/// x in K x = r for a small row-major matrix; false where K is singular to rounding, or not finite.
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

} // namespace hilger::detail
