// SPDX-License-Identifier: BSL-1.0
// The parts of L = v.Mv/2 + a.v - U(q) with a constant mass as a composition of kicks and drifts asks for them: v = M^-1 (p - a), and dL/dq
// whatever the velocity is.
#pragma once

#include "hilger/inlining.hpp"
#include "hilger/linear/patterned_matrix.hpp"
#include "hilger/newton/small_solve.hpp"
#include "hilger/step/separable.hpp"
#include "hilger/step/small_node.hpp"
#include "hilger/variational/node_derivatives.hpp"

namespace hilger::detail {

/// The velocity and the force of a small Lagrangian, from its jets: what the types say to be zero is not computed. Where it compares
/// positions, M and a have to be the same at both ends of a drift; where it compares velocities, v = 0 says nothing of others.
template <class Problem, class S, class V>
class small_parts {
    using s = shape<V>;
    static constexpr std::size_t N = s::size;
    using components = std::array<S, N>;

public:
    using vector = components;
    static constexpr bool has_whole_vectors = false;
    small_parts(Problem const&, V const&) {}
    static vector taken(V const& x) { return taken(x, all{}); }
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
    /// A step begins, with no drift before its first kick.
    void begin() { has_drifted_ = false; }
    template <class Sum>
    HILGER_ALWAYS_INLINE static void add(vector& x, S const& w, vector const& y, Sum& sum) {
        add(x, w, y, sum, all{});
    }
    /// 0, or NaN where not all numbers are finite.
    HILGER_ALWAYS_INLINE static S overflow(vector const& q, vector const& p) { return overflow(q, p, all{}); }

private:
    using all = std::make_integer_sequence<int, static_cast<int>(N)>;
    template <int... K>
    HILGER_ALWAYS_INLINE static vector taken(V const& x, std::integer_sequence<int, K...>) {
        return {s::component(x, K)...};
    }
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
    HILGER_ALWAYS_INLINE static S overflow(vector const& q, vector const& p, std::integer_sequence<int, K...>) {
        return S((S(q[K] - q[K]) + ...) + (S(p[K] - p[K]) + ...));
    }
    using matrix = std::array<S, N * N>;
    matrix inertia_{}; ///< M and a where the last drift began
    vector at_rest_{};
    bool has_drifted_ = false;
};
/// States that stay where they are.
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
            for (int k = 0; k < shape<V>::dimension(x); ++k) sum.add(x(k), S(w * y(k)), k);
    }
    static S overflow(V const& q, V const& p) { return S((q - q).sum() + (p - p).sum()); }
};
/// The same of a system that says so, of any size.
template <class Problem, class S, class V>
class large_parts : public whole_vectors<S, V> {
public:
    large_parts(Problem const& what, V const& like) : of_(what, like) {}
    bool velocity(Problem const&, V const&, V const& p, V& v) const {
        of_.velocity(p, v);
        return true;
    }
    bool force(Problem const& what, V const& q, V& g) { return of_.force(what, S(0), q, g); }

private:
    separable<Problem, S, V> of_;
};
/// The same of a Lagrangian whose formula is traced, and says whether it has these parts: second derivatives by q and v that are not there,
/// and by v twice that never change. One with branches, or that reads the time, is left to its flows.
template <class Problem, class S, class V>
class traced_parts : public whole_vectors<S, V> {
    using s = shape<V>;

public:
    traced_parts(Problem const&, V const& like) : at_rest_(zero_like(like)) {}
    bool velocity(Problem const& what, V const& q, V const& p, V& v) {
        if (not is_known_) learn(what, q);
        if (not has_parts_) return false;
        v = p - at_rest_;
        if (is_diagonal_)
            v.array() *= inverse_.array();
        else
            mass_.solve(v);
        return true;
    }
    bool force(Problem const& what, V const& q, V& g) {
        if (not is_known_) learn(what, q);
        if (not has_parts_) return false;
        int const d = s::dimension(q);
        std::copy_n(q.data(), d, node_.arguments());
        (void)node_.evaluate_here(what, S(0), d, wanted::forces_only);
        node_.put_by_q(S(1), g);
        return true;
    }

private:
    static bool reads_time(Problem const& what) {
        using F = std::remove_cvref_t<decltype(what.lagrangian)>;
        if constexpr (requires { what.lagrangian.reads_time(); })
            return what.lagrangian.reads_time();
        else
            return is_timed<F, no_force, S, V>;
    }
    /// At v = 0, where the arguments of the formula stay.
    void learn(Problem const& what, V const& q) {
        is_known_ = true;
        if (reads_time(what)) return;
        (void)node_.evaluate(what, S(0), q, zero_like(q), wanted::with_seconds);
        auto const& at = node_.places();
        if (node_.has_branches() or not at.entries[block_qv].empty() or not at.constant[block_vv]) return;
        for (int k = 0; k < s::dimension(q); ++k) at_rest_(k) = node_.by_v(k);
        has_parts_ = weigh(at.entries[block_vv], s::dimension(q));
    }
    /// M^-1, or the factors of M. False where it is singular.
    template <class Entries>
    bool weigh(Entries const& entries, int d) {
        is_diagonal_ = std::all_of(entries.begin(), entries.end(), [](auto const& e) { return e.row == e.column; });
        if (is_diagonal_) {
            inverse_ = zero_like(at_rest_);
            for (auto const& e : entries) {
                if (node_.value(e.place) == S(0)) return false;
                inverse_(e.row) = S(1) / node_.value(e.place);
            }
            return static_cast<int>(entries.size()) == d;
        }
        std::vector<std::pair<int, int>> pattern;
        for (auto const& e : entries) pattern.emplace_back(e.row, e.column);
        mass_.prepare(d, pattern);
        mass_.set_zero();
        for (auto const& e : entries) mass_[mass_.place(e.row, e.column)] = node_.value(e.place);
        return mass_.factorize();
    }
    node_derivatives<Problem, V> node_;
    bool is_known_ = false, has_parts_ = false, is_diagonal_ = false;
    V at_rest_, inverse_; ///< a; M^-1 where M is diagonal
    patterned_matrix<S> mass_;
};

/// Whether L may turn out to have these parts.
template <class F, class S, class V>
inline constexpr bool may_split = [] {
    if constexpr (is_traced_state<V>)
        return node_derivatives<problem<F, no_force>, V>::has_room;
    else
        return not is_timed<F, no_force, S, V>;
}();
template <class Problem, class S, class V>
using split_parts = std::conditional_t<is_mechanical<decltype(Problem::lagrangian)>, large_parts<Problem, S, V>,
                                       std::conditional_t<is_traced_state<V>, traced_parts<Problem, S, V>, small_parts<Problem, S, V>>>;

} // namespace hilger::detail
