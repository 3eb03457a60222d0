// SPDX-License-Identifier: BSL-1.0
// What compensated sums need of a step beside its increments. With h = 0.1 the numbers q + c v and p + f dL/dq fall on few residues, and
// their rounding leans to one side: an error that grows with the number of steps, where that of the sums does not. So what is cut off of
// them, and what earlier sums have left, goes through the equation once more, to first order, with the matrix of its last round.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "hilger/differentiation/jet/jet.hpp"
#include "hilger/error_free.hpp"
#include "hilger/inlining.hpp"
#include "hilger/newton/small_solve.hpp"

namespace hilger::detail {

/// g_J + sum_K D_JK d_K
template <int J, class S, std::size_t N>
HILGER_ALWAYS_INLINE inline void add_row(std::array<S, N>& g, std::array<S, N * N> const& D, std::array<S, N> const& d) {
    [&]<std::size_t... K>(std::index_sequence<K...>) HILGER_ALWAYS_INLINE { ((g[J] = plus(g[J], times(D[J * N + K], d[K]))), ...); }
    (std::make_index_sequence<N>{});
}

/// What of x + the rest of its sum + y is cut off in x + y.
template <class Sum, class S>
HILGER_ALWAYS_INLINE inline S rest_of_sum(Sum const& sum, S const& x, S const& y, int k) {
    S rounded{}, rest{};
    two_sum(x, y, rounded, rest);
    return rest + sum.rest[static_cast<std::size_t>(k)];
}

/// The last round of Newton's method for r = p + f g(q + c v, v) - dL/dv(q + c v, v), J d = r.
template <class S, std::size_t N>
struct last_round {
    using components = std::array<S, N>;
    using matrix = std::array<S, N * N>;
    S c, f;
    components const &q, &p, &v, &g, &d; ///< v and g are those that r is made of
    matrix J, D;                         ///< D = dg/dv
    components more{};                   ///< how the rests correct v
    components of_g{};                   ///< and what they and the round itself add to g

    /// e are the derivatives that the round was made with, `change` is D d.
    template <class Derivatives, class SumOfQ, class SumOfP, int... K, int... M>
    HILGER_ALWAYS_INLINE void look_at_rests(Derivatives const& e, SumOfQ const& sum_q, SumOfP const& sum_p, components const& change,
                                            std::integer_sequence<int, K...>, std::integer_sequence<int, M...>) {
        constexpr int n = static_cast<int>(N);
        matrix const by_A{plus(S(0), e.template qq<M / n, M % n>())...}, by_A_of_v{plus(S(0), e.template vq<M / n, M % n>())...};
        components const below{rest_of_sum(sum_q, q[K], S(c * v[K]), K)...};
        components momentum{};
        (add_row<K>(of_g, by_A, below), ...);
        (add_row<K>(momentum, by_A_of_v, below), ...);
        more = components{S(rest_of_sum(sum_p, p[K], S(f * g[K]), K) + f * of_g[K] - momentum[K])...};
        (void)small_solve(J, more); // it was regular
        (add_row<K>(of_g, D, more), ...);
        of_g = components{S(of_g[K] + change[K])...};
    }
};

} // namespace hilger::detail
