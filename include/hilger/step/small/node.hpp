// SPDX-License-Identifier: BSL-1.0
// Node derivatives for steps of up to four degrees of freedom: jets of the Lagrangian, and of a force beside dL/dq, that an optimiser keeps
// in registers, or a table for a Lagrangian with derivatives of its own. Also the rounding errors in the equation of the node.
#pragma once

#include "hilger/error_free.hpp"
#include "hilger/newton/small_solve.hpp"
#include "hilger/variational/problem.hpp"

namespace hilger::detail {

/// Derivatives at one node: by_q<J>, by_v<J>, and qq<J, K> = second derivative by component J of q, then K of q. A force f adds itself to
/// by_q, df/dq to qq and df/dv to qv, so that qv is the transpose of vq without forces only.
template <int N, class Jet>
struct node_jet {
    Jet z;
    HILGER_ALWAYS_INLINE dependence on() const { return z.on; }
    template <int J>
    HILGER_ALWAYS_INLINE auto by_q() const {
        return z.template by<J>();
    }
    template <int J>
    HILGER_ALWAYS_INLINE auto by_v() const {
        return z.template by<N + J>();
    }
    template <int J, int K>
    HILGER_ALWAYS_INLINE auto qq() const {
        return z.template by<std::max(J, K), std::min(J, K)>();
    }
    template <int J, int K>
    HILGER_ALWAYS_INLINE auto qv() const {
        return z.template by<N + K, J>();
    }
    template <int J, int K>
    HILGER_ALWAYS_INLINE auto vq() const {
        return z.template by<N + J, K>();
    }
    template <int J, int K>
    HILGER_ALWAYS_INLINE auto vv() const {
        return z.template by<N + std::max(J, K), N + std::min(J, K)>();
    }
};
/// The same from jets of L and of a force's components, by all of q and v.
template <int N, class Jet, class ForceJet>
struct forced_node_jet : node_jet<N, Jet> {
    using base = node_jet<N, Jet>;
    using base::z;
    std::array<ForceJet, static_cast<std::size_t>(N)> force;

    template <class... F>
    HILGER_ALWAYS_INLINE explicit forced_node_jet(Jet const& of_lagrangian, F const&... of_force)
        : base{of_lagrangian}, force{of_force...} {}
    /// A force counts as the derivative by q of a term of one degree more.
    HILGER_ALWAYS_INLINE dependence on() const {
        dependence all = z.on;
        for (ForceJet const& f : force) all = {std::max(all.q, f.on.q + 1), std::max(all.v, f.on.v + 1), all.coupled or f.on.coupled};
        return all;
    }
    template <int J>
    HILGER_ALWAYS_INLINE auto by_q() const {
        return plus(base::template by_q<J>(), force[J].value);
    }
    template <int J, int K>
    HILGER_ALWAYS_INLINE auto qq() const {
        return plus(z.template by<std::max(J, K), std::min(J, K)>(), force[J].template by<K>());
    }
    template <int J, int K>
    HILGER_ALWAYS_INLINE auto qv() const {
        return plus(z.template by<N + K, J>(), force[J].template by<N + K>());
    }
};

/// Small states: straight from the jets. Rare calls are not flattened: with a second call site a compiler keeps the first in memory.
template <bool Scalar, bool Flat, class F, class S, std::size_t Size, int... K>
HILGER_ALWAYS_INLINE inline auto lagrangian_jets(F const& L, S const& t, std::array<S, Size> const& q, std::array<S, Size> const& v,
                                                 std::integer_sequence<int, K...> all) {
    constexpr int N = static_cast<int>(Size);
    using X = std::conditional_t<Scalar, q_jet<S, N>, Eigen::Matrix<q_jet<S, N>, N, 1>>;
    using Y = std::conditional_t<Scalar, v_jet<S, N>, Eigen::Matrix<v_jet<S, N>, N, 1>>;
    constexpr bool timed = std::invocable<F const&, S const&, X const&, Y const&>;
    require_callable<timed or std::invocable<F const&, X const&, Y const&>>();
    if constexpr (timed and Flat)
        return jets_of<2, Scalar>(L, q, v, all, t);
    else if constexpr (Flat)
        return jets_of<2, Scalar>(L, q, v, all);
    else if constexpr (timed)
        return plain_jets_of<2, Scalar>(L, q, v, all, t);
    else
        return plain_jets_of<2, Scalar>(L, q, v, all);
}
template <bool Scalar, class J, class Jet, class Force, class S, std::size_t Size, int... K>
HILGER_ALWAYS_INLINE inline auto with_force_jets(Jet const& z, Force const& force, S const& t, std::array<S, Size> const& q,
                                                 std::array<S, Size> const& v, std::integer_sequence<int, K...>) {
    constexpr int N = static_cast<int>(Size);
    using node = forced_node_jet<N, Jet, J>;
    if constexpr (Scalar) {
        auto const f = at_time{force, t}(J::variable(q[0], 0, {1, 0}), J::variable(v[0], 1, {0, 1}));
        require_force<S>(f, 1);
        return node(z, J(f));
    } else {
        jet_vector<J, N> x, y;
        ((x(K) = J::variable(q[K], K, {1, 0}), y(K) = J::variable(v[K], N + K, {0, 1})), ...);
        auto const f = at_time{force, t}(x, y);
        require_force<Eigen::Matrix<S, N, 1>>(f, N);
        return node(z, J(component_of(f, K))...);
    }
}
template <bool Scalar, bool Flat = true, class F, class Force, class S, std::size_t Size, int... K>
HILGER_ALWAYS_INLINE inline auto evaluate(problem<F, Force> const& what, S const& t, std::array<S, Size> const& q,
                                          std::array<S, Size> const& v, std::integer_sequence<int, K...> all) {
    constexpr int N = static_cast<int>(Size);
    using V = std::conditional_t<Scalar, S, Eigen::Matrix<S, N, 1>>;
    if constexpr (requires(V const& x) { at_time{what.lagrangian, t}.expand(x, x); }) {
        using s = shape<V>;
        V x, y;
        ((s::component(x, K) = q[K], s::component(y, K) = v[K]), ...);
        return expand_at(what, t, x, y);
    } else if constexpr (std::same_as<Force, no_force>)
        return node_jet<N, qv_jet<S, N>>{lagrangian_jets<Scalar, Flat>(what.lagrangian, t, q, v, all)};
    else
        return with_force_jets<Scalar, jet<S, 0, 2 * N, 1>>(lagrangian_jets<Scalar, Flat>(what.lagrangian, t, q, v, all), what.force, t, q,
                                                            v, all);
}

/// g_J + sum_K D_JK d_K
template <int J, class S, std::size_t N>
HILGER_ALWAYS_INLINE inline void add_row(std::array<S, N>& g, std::array<S, N * N> const& D, std::array<S, N> const& d) {
    [&]<std::size_t... K>(std::index_sequence<K...>) HILGER_ALWAYS_INLINE { ((g[J] = plus(g[J], times(D[J * N + K], d[K]))), ...); }
    (std::make_index_sequence<N>{});
}

/// Rounding error of x + y, plus the carried rest of the sum that x belongs to.
template <class Sum, class S>
HILGER_ALWAYS_INLINE inline S rest_of_sum(Sum const& sum, S const& x, S const& y, int k) {
    S rounded{}, rest{};
    two_sum(x, y, rounded, rest);
    return rest + sum.rest[static_cast<std::size_t>(k)];
}

/// Rounding terms of a step for compensated sums. With h = 0.1 the numbers q + c v and p + f dL/dq fall on few residues, and their rounding
/// is biased: an error that grows with the number of steps, unlike that of the sums. These errors, and the rests of earlier sums, therefore
/// pass through the equation once more, to first order, with the matrix of its last round: Newton's method for r = p + f g(q + c v, v) -
/// dL/dv(q + c v, v), J d = r.
template <class S, std::size_t N>
struct last_round {
    using components = std::array<S, N>;
    using matrix = std::array<S, N * N>;
    S c, f;
    components const &q, &p, &v, &g, &d; ///< v and g are those that r is made of
    matrix J, D;                         ///< D = dg/dv
    components more{};                   ///< correction of v by the rests
    components of_g{};                   ///< correction of g by the rests and the round

    /// e: the derivatives used by the round; `change` is D d.
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
