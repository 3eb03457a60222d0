// SPDX-License-Identifier: BSL-1.0
// What a composition of order-one steps and their adjoints does to L = v.Mv/2 + a.v - U(q) with a constant mass (Hairer-Lubich-Wanner,
// Geometric Numerical Integration, II.5): kicks p + w dL/dq(q) and drifts q + w M^-1 (p - a) in turns. A kick after a kick is one, as is a
// drift after a drift, and the force at the end of a step is the first of the next: one force for each part, no velocity twice.
#pragma once

#include "hilger/composition/parts.hpp"
#include "hilger/composition/reversed.hpp"
#include "hilger/inlining.hpp"
#include "hilger/newton/small_solve.hpp"
#include "hilger/step/separable.hpp"
#include "hilger/step/small_node.hpp"

namespace hilger {

template <parts_of_a_step Parts, class... Flows>
class composed_flow;

namespace detail {

/// Parts of a step that are taken by flows of one problem, down to its numbers.
template <class Parts>
struct one_problem : Parts {};
template <class Parts>
inline constexpr bool of_one_problem = false;
template <class Parts>
inline constexpr bool of_one_problem<one_problem<Parts>> = true;
template <class Parts>
inline constexpr bool of_one_problem<backwards<Parts>> = of_one_problem<Parts>;

/// Which kicks and drifts a flow is made of, where it is: leaves are flows of order one or their adjoints.
template <class Flow>
struct turns {
    static constexpr bool possible = false;
};
template <class F, class E, sums Sums>
    requires(facts_of<E>.one_node and (facts_of<E>.at_start or facts_of<E>.at_end))
struct turns<flow<F, no_force, E, Sums>> {
    static constexpr bool possible = true, compensated = Sums == sums::compensated;
    static constexpr bool starts_with_kick = facts_of<E>.at_start;
    static constexpr std::size_t leaves = 1;
    using problem_type = problem<F, no_force>;
    template <class S, class Use>
    static void each(flow<F, no_force, E, Sums> const& f, S const& h, Use const& use) {
        S const w = tableau_of(f.embedding(), h).w(0);
        use(starts_with_kick, w);
        use(not starts_with_kick, w);
    }
};
template <class Parts, class First, class... Others>
    requires((sizeof...(Others) == 0 or of_one_problem<Parts>)and turns<First>::possible and (turns<Others>::possible and ...))
struct turns<composed_flow<Parts, First, Others...>> {
    static constexpr bool possible = true, compensated = turns<First>::compensated;
    static constexpr bool starts_with_kick = turns<First>::starts_with_kick;
    static constexpr std::size_t flows = 1 + sizeof...(Others);
    static constexpr std::size_t leaves = Parts::size / flows * (turns<First>::leaves + (turns<Others>::leaves + ... + 0));
    using problem_type = typename turns<First>::problem_type;
    template <class S, class Use>
    static void each(composed_flow<Parts, First, Others...> const& f, S const& h, Use const& use) {
        auto const parts = whole<S>(f.parts());
        for (std::size_t k = 0; k < Parts::size; k += flows)
            std::apply(
                [&, j = k](auto const&... flow) mutable {
                    (turns<std::remove_cvref_t<decltype(flow)>>::each(flow, S(parts[j++] * h), use), ...);
                },
                f.flows());
    }
};

/// The velocity and the force of a small Lagrangian, from its jets: what the types say to be zero is not computed. Where it compares
/// positions, M and a have to be the same at both ends of a drift; where it compares velocities, v = 0 says nothing of others.
template <class Problem, class S, class V>
class small_parts {
    using s = shape<V>;
    static constexpr std::size_t N = s::size;
    using components = std::array<S, N>;

public:
    using vector = components;
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
/// The same of a system that says so, of any size.
template <class Problem, class S, class V>
class large_parts {
    using s = shape<V>;

public:
    using vector = V;
    large_parts(Problem const& what, V const& like) : of_(what, like) {}
    static V const& taken(V const& x) { return x; }
    static void give(V const& x, V& to) { to = x; }
    void begin() {}
    bool velocity(Problem const&, V const&, V const& p, V& v) const {
        of_.velocity(p, v);
        return true;
    }
    bool force(Problem const& what, V const& q, V& g) { return of_.force(what, S(0), q, g); }
    template <class Sum>
    static void add(V& x, S const& w, V const& y, Sum& sum) {
        if constexpr (std::is_empty_v<Sum>)
            x += w * y;
        else
            for (int k = 0; k < s::dimension(x); ++k) sum.add(x(k), S(w * y(k)), k);
    }
    static S overflow(V const& q, V const& p) { return S((q - q).sum() + (p - p).sum()); }

private:
    separable<Problem, S, V> of_;
};

/// What one trajectory of such a composition remembers.
template <class Flow, class S, class V>
class splitting {
    using of = turns<Flow>;
    using Problem = typename of::problem_type;
    static constexpr bool large = is_mechanical<decltype(Problem::lagrangian)>;
    using parts = std::conditional_t<large, large_parts<Problem, S, V>, small_parts<Problem, S, V>>;
    using vector = typename parts::vector;

public:
    splitting(Flow const& f, S const& h, V const& like)
        : parts_(f.mechanics(), like), q_(parts_.taken(like)), p_(q_), v_(q_), g_(q_), last_(q_), sum_q_(shape<V>::dimension(like)),
          sum_p_(sum_q_), next_q_(sum_q_), next_p_(sum_q_) {
        prepare(f, h);
    }
    /// x one step h further. False, and nothing has happened, where L turns out to have other parts, or numbers are not finite.
    bool advance(Flow const& f, state<S, V>& x, S const& h) {
        if (not(h == h_)) [[unlikely]]
            prepare(f, h);
        if constexpr (not large and std::is_floating_point_v<S>)
            return flat_loop(f.mechanics(), x);
        else
            return loop(f.mechanics(), x);
    }

    [[nodiscard]] S const& h() const { return h_; }
    /// Everything that later steps depend on, for checkpoints.
    template <class Visit>
    void visit(Flow const& f, Visit& each) {
        each("step", h_);
        prepare(f, h_);
        int known = known_ ? 1 : 0;
        each("known", known);
        known_ = known != 0;
        for (std::size_t k = 0; k < size_of(last_); ++k) each("position", component(last_, k));
        for (std::size_t k = 0; k < size_of(g_); ++k) each("force", component(g_, k));
        sum_q_.visit(each);
        sum_p_.visit(each);
    }

private:
    static std::size_t size_of(vector const& x) { return static_cast<std::size_t>(x.size()); }
    static S& component(vector& x, std::size_t k) {
        if constexpr (large)
            return x(static_cast<index_type>(k));
        else
            return x[k];
    }
    /// Neighbours of one kind are one: their lengths add up.
    void prepare(Flow const& f, S const& h) {
        h_ = h;
        size_ = 0;
        of::each(f, h, [&](bool is_kick, S const& w) {
            bool const next = (size_ % 2 == 0) == (is_kick == of::starts_with_kick);
            if (next)
                lengths_[size_++] = w;
            else
                lengths_[size_ - 1] = lengths_[size_ - 1] + w;
        });
    }
    HILGER_FLATTEN bool flat_loop(Problem const& what, state<S, V>& x) { return loop(what, x); }
    HILGER_ALWAYS_INLINE bool loop(Problem const& what, state<S, V>& x) {
        next_q_ = sum_q_;
        next_p_ = sum_p_;
        room q = q_, p = p_, v = v_, g = g_;
        q = parts_.taken(x.q);
        p = parts_.taken(x.p);
        parts_.begin();
        std::size_t k = 0;
        if constexpr (of::starts_with_kick) {
            if (not(known_ and last_ == q) and not parts_.force(what, q, g)) return false;
            parts_.add(p, lengths_[k++], g, next_p_);
        }
        known_ = false;
        for (;;) {
            if (not parts_.velocity(what, q, p, v)) return false;
            parts_.add(q, lengths_[k++], v, next_q_);
            if (k == size_) break;
            if (not parts_.force(what, q, g)) return false;
            parts_.add(p, lengths_[k++], g, next_p_);
            if (k == size_) {
                last_ = q;
                g_ = g;
                known_ = true;
                break;
            }
        }
        if constexpr (not std::numeric_limits<S>::is_exact)
            if (not(parts_.overflow(q, p) == S(0))) return known_ = false;
        parts_.give(q, x.q);
        parts_.give(p, x.p);
        x.t = x.t + h_;
        sum_q_ = next_q_;
        sum_p_ = next_p_;
        return true;
    }
    /// What has few components is in registers while a step is made; what has many stays in its place.
    using room = std::conditional_t<large, vector&, vector>;

    parts parts_;
    S h_;
    std::size_t size_ = 0;
    std::array<S, 2 * of::leaves> lengths_;
    vector q_, p_, v_, g_, last_; ///< the state inside the step; where the force g is known, while it is
    bool known_ = false;
    /// What sums carry; and what they carry inside the step.
    [[no_unique_address]] summation<of::compensated, S, shape<V>::size> sum_q_, sum_p_, next_q_, next_p_;
};

/// Whether a composition of states V is made of kicks and drifts; of small Lagrangians their jets say it, when they are evaluated.
enum class kicks_and_drifts { no, perhaps, always };
template <class Flow, class S, class V>
inline constexpr kicks_and_drifts splits = [] {
    if constexpr (turns<Flow>::possible) {
        using F = decltype(turns<Flow>::problem_type::lagrangian);
        constexpr int N = shape<V>::size;
        if (is_mechanical<F>) return kicks_and_drifts::always;
        if (not is_timed<F, no_force, S, V> and N != Eigen::Dynamic and N <= one_evaluation) return kicks_and_drifts::perhaps;
    }
    return kicks_and_drifts::no;
}();

} // namespace detail
} // namespace hilger
