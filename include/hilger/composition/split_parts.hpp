// SPDX-License-Identifier: BSL-1.0
// The parts of L = v.Mv/2 + a.v - U(q) with a constant mass for a composition of kicks and drifts: v = M^-1 (p - a), and dL/dq independent
// of the velocity.
#pragma once

#include <optional>

#include "hilger/inlining.hpp"
#include "hilger/newton/small_solve.hpp"
#include "hilger/step/separable.hpp"
#include "hilger/step/small/node.hpp"
#include "hilger/variational/separated_hamiltonian.hpp"

namespace hilger::detail {

/// The velocity and the force of a small Lagrangian, from its jets; derivatives that are zero by their types are not computed. Where L
/// compares positions, M and a must agree at both ends of a drift; where it compares velocities, their values at v = 0 do not suffice.
template <class Problem, class S, class V>
class small_parts {
    using s = shape<V>;
    static constexpr std::size_t N = s::size;

public:
    using vector = std::array<S, N>;
    static constexpr bool has_whole_vectors = false;
    small_parts(Problem const&, V const&) {}
    static vector taken(V const& x) { return components(x, all{}); }
    static void give(vector const& x, V& to) {
        for (std::size_t k = 0; k < N; ++k) s::component(to, static_cast<int>(k)) = x[k];
    }
    /// False where L has other parts, or no velocity.
    HILGER_ALWAYS_INLINE bool velocity(Problem const& what, vector const& q, vector const& p, vector& v) {
        return velocity(what, q, p, v, all{}, std::make_index_sequence<N * N>{});
    }
    HILGER_ALWAYS_INLINE bool force(Problem const& what, vector const& q, vector& g) {
        return force(what, q, g, all{}, std::make_index_sequence<N * N>{});
    }
    /// Begins a step, with no drift before its first kick.
    void begin() { has_drifted_ = false; }
    template <class Sum>
    HILGER_ALWAYS_INLINE static void add(vector& x, S const& w, vector const& y, Sum& sum) {
        add(x, w, y, sum, all{});
    }
    /// Whether all numbers are finite: their sum is, or each of them.
    HILGER_ALWAYS_INLINE static bool are_finite(vector const& q, vector const& p) { return are_finite(q, p, all{}); }

private:
    using all = std::make_integer_sequence<int, static_cast<int>(N)>;
    template <int... K, std::size_t... M>
    HILGER_ALWAYS_INLINE bool velocity(Problem const& what, vector const& q, vector const& p, vector& v,
                                       std::integer_sequence<int, K...> every, std::index_sequence<M...>) {
        std::uint64_t const compared = comparisons_made(), of_velocity = comparisons_of_velocity();
        auto const e = evaluate<s::is_scalar>(what, S(0), q, vector{}, every);
        matrix inertia{S(e.template vv<static_cast<int>(M / N), static_cast<int>(M % N)>())...};
        v = {S(minus(p[K], e.template by_v<K>()))...};
        if (comparisons_made() != compared) [[unlikely]] {
            if (comparisons_of_velocity() != of_velocity) return false;
            inertia_ = inertia;
            at_rest_ = {S(e.template by_v<K>())...};
            has_drifted_ = true;
        }
        return not e.on().coupled and e.on().v <= 2 and small_solve(inertia, v);
    }
    template <int... K, std::size_t... M>
    HILGER_ALWAYS_INLINE bool force(Problem const& what, vector const& q, vector& g, std::integer_sequence<int, K...> every,
                                    std::index_sequence<M...>) {
        std::uint64_t const compared = comparisons_made(), of_velocity = comparisons_of_velocity();
        auto const e = evaluate<s::is_scalar>(what, S(0), q, vector{}, every);
        g = {S(e.template by_q<K>())...};
        if (comparisons_made() != compared) [[unlikely]] {
            matrix const inertia{S(e.template vv<static_cast<int>(M / N), static_cast<int>(M % N)>())...};
            vector const at_rest{S(e.template by_v<K>())...};
            if (comparisons_of_velocity() != of_velocity or (has_drifted_ and not(inertia == inertia_ and at_rest == at_rest_)))
                return false;
        }
        return not e.on().coupled;
    }
    template <class Sum, int... K>
    HILGER_ALWAYS_INLINE static void add(vector& x, S const& w, vector const& y, Sum& sum, std::integer_sequence<int, K...>) {
        (sum.add(x[K], S(w * y[K]), K), ...);
    }
    template <int... K>
    HILGER_ALWAYS_INLINE static bool are_finite(vector const& q, vector const& p, std::integer_sequence<int, K...>) {
        return is_finite(S((q[K] + ...) + (p[K] + ...))) or ((is_finite(q[K]) and is_finite(p[K])) and ...);
    }
    using matrix = std::array<S, N * N>;
    matrix inertia_{}; ///< M and a where the last drift began
    vector at_rest_{};
    bool has_drifted_ = false;
};
/// States that stay in memory.
template <class S, class V>
class whole_vectors {
public:
    using vector = V;
    static constexpr bool has_whole_vectors = true;
    static V const& taken(V const& x) { return x; }
    static void give(V const& x, V& to) { to = x; }
    void begin() {}
    template <class Sum>
    static void add(V& x, S const& w, V const& y, Sum& sum) {
        if constexpr (std::is_empty_v<Sum>)
            x += w * y;
        else
            for (int k = 0; k < s::dimension(x); ++k) sum.add(s::component(x, k), S(w * s::component(y, k)), k);
    }
    static bool are_finite(V const& q, V const& p) {
        if constexpr (s::is_scalar)
            return is_finite(q) and is_finite(p);
        else
            return is_finite(S(q.sum() + p.sum())) or (all_finite(q) and all_finite(p));
    }

private:
    using s = shape<V>;
};
/// The same for mechanical systems, traced formulas and Lagrangians with their own derivatives (step/separable.hpp).
template <class Problem, class S, class V>
class large_parts : public whole_vectors<S, V> {
public:
    large_parts(Problem const& what, V const& like) : of_(what, like) {}
    bool velocity(Problem const& what, V const& q, V const& p, V& v) {
        if (not has_parts(what, q)) return false;
        of_.velocity(p, v);
        return true;
    }
    bool force(Problem const& what, V const& q, V& g) { return has_parts(what, q) and of_.force(what, S(0), q, g); }

private:
    bool has_parts(Problem const& what, V const& q) {
        if (not has_parts_) has_parts_ = of_.inspect(what, state<S, V>{S(0), q, q});
        return *has_parts_;
    }
    std::optional<bool> has_parts_; ///< once checked
    separable<Problem, S, V> of_;
};
/// Those of a Hamiltonian A(p) + B(q) (variational/separated_hamiltonian.hpp): v = dA/dp, and the force is -dB/dq.
template <class A, class B, class S, class V>
class large_parts<problem<legendre_transform<separated<A, B>>, no_force>, S, V> : public whole_vectors<S, V> {
    using what_type = problem<legendre_transform<separated<A, B>>, no_force>;

public:
    large_parts(what_type const&, V const&) {}
    bool velocity(what_type const& what, V const&, V const& p, V& v) {
        v = gradient_by(p, what.lagrangian.given().of_momentum);
        return true;
    }
    bool force(what_type const& what, V const& q, V& g) {
        g = -gradient_by(q, what.lagrangian.given().of_position);
        return true;
    }
};

/// Whether L may turn out to have these parts.
template <class F, class S, class V>
inline constexpr bool may_split = not always_reads_time<F, S, V>;
template <class Problem, class S, class V>
using split_parts =
    std::conditional_t<is_traced_state<V> or has_own_derivatives<Problem, V>, large_parts<Problem, S, V>, small_parts<Problem, S, V>>;

} // namespace hilger::detail
