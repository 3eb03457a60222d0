// SPDX-License-Identifier: BSL-1.0
// Compositions of order-one steps and their adjoints for L = v.Mv/2 + a.v - U(q) with a constant mass (Hairer-Lubich-Wanner, Geometric
// Numerical Integration, II.5): alternating kicks p + w dL/dq(q) and drifts q + w M^-1 (p - a). Neighbouring kicks or drifts merge, and the
// force at the end of a step is the first of the next: one force for each part, no velocity twice.
#pragma once

#include "hilger/composition/parts.hpp"
#include "hilger/composition/reversed.hpp"
#include "hilger/composition/split_parts.hpp"

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

/// The kicks and drifts of a flow, where it consists of them: leaves are flows of order one or their adjoints.
template <class Flow>
struct kick_drift_sequence {
    static constexpr bool possible = false;
};
template <class F, class E, sums Sums>
    requires(facts_of<E>.one_node and (facts_of<E>.at_start or facts_of<E>.at_end))
struct kick_drift_sequence<flow<F, no_force, E, Sums>> {
    static constexpr bool possible = true, compensated = Sums == sums::compensated;
    static constexpr bool starts_with_kick = facts_of<E>.at_start;
    static constexpr std::array<bool, 2> is_kick{starts_with_kick, not starts_with_kick};
    using problem_type = problem<F, no_force>;
    template <class S, class Use>
    static void each(flow<F, no_force, E, Sums> const& f, S const& h, Use const& use) {
        S const w = tableau_of(f.embedding(), h).w(0);
        for (bool const kick : is_kick) use(kick, w);
    }
};
template <class Parts, class First, class... Others>
    requires((sizeof...(Others) == 0 or of_one_problem<Parts>)and kick_drift_sequence<First>::possible and
             (kick_drift_sequence<Others>::possible and ...))
struct kick_drift_sequence<composed_flow<Parts, First, Others...>> {
    static constexpr bool possible = true, compensated = kick_drift_sequence<First>::compensated;
    static constexpr bool starts_with_kick = kick_drift_sequence<First>::starts_with_kick;
    static constexpr std::size_t flows = 1 + sizeof...(Others);
    /// For each kick and drift, in their order.
    static constexpr auto is_kick = [] {
        constexpr std::size_t in_turn =
            kick_drift_sequence<First>::is_kick.size() + (kick_drift_sequence<Others>::is_kick.size() + ... + 0);
        std::array<bool, Parts::size / flows * in_turn> kinds{};
        std::size_t k = 0;
        auto const add = [&](auto const& of_flow) {
            for (bool const kick : of_flow) kinds[k++] = kick;
        };
        while (k < kinds.size()) add(kick_drift_sequence<First>::is_kick), (add(kick_drift_sequence<Others>::is_kick), ...);
        return kinds;
    }();
    using problem_type = typename kick_drift_sequence<First>::problem_type;
    template <class S, class Use>
    static void each(composed_flow<Parts, First, Others...> const& f, S const& h, Use const& use) {
        auto const parts = whole<S>(f.parts());
        for (std::size_t k = 0; k < Parts::size; k += flows)
            std::apply(
                [&, j = k](auto const&... flow) mutable {
                    (kick_drift_sequence<std::remove_cvref_t<decltype(flow)>>::each(flow, S(parts[j++] * h), use), ...);
                },
                f.flows());
    }
};

/// The memory of one trajectory of such a composition.
template <class Flow, class S, class V>
class splitting {
    using of = kick_drift_sequence<Flow>;
    using Problem = typename of::problem_type;
    using parts = split_parts<Problem, S, V>;
    static constexpr bool large = parts::has_whole_vectors;
    using vector = typename parts::vector;

    /// Neighbours of one kind merge.
    static constexpr std::size_t size = [] {
        std::size_t n = 1;
        for (std::size_t k = 1; k < of::is_kick.size(); ++k) n += of::is_kick[k] != of::is_kick[k - 1];
        return n;
    }();
    static constexpr bool ends_with_kick = of::is_kick.back();

public:
    /// Whether a step is short enough to be unrolled, and small enough for registers.
    static constexpr bool in_registers = not large and size <= 8 and std::is_floating_point_v<S>;

    splitting(Flow const& f, S const& h, V const& like)
        : parts_(f.mechanics(), like), q_(parts_.taken(like)), p_(q_), v_(q_), g_(q_), last_(q_), sum_q_(shape<V>::dimension(like)),
          sum_p_(sum_q_), next_q_(sum_q_), next_p_(sum_q_) {
        prepare(f, h);
    }
    /// Prepares steps of length h from x; the force of another state is forgotten.
    void begin(Flow const& f, state<S, V> const& x, S const& h) {
        if (not(h == h_)) [[unlikely]]
            prepare(f, h);
        known_ = known_ and last_ == parts_.taken(x.q);
    }
    /// Advances x by one step h. Returns false, with x unchanged, where L turns out to have other parts or numbers are not finite.
    bool advance(Flow const& f, state<S, V>& x, S const& h) {
        begin(f, x, h);
        if constexpr (not large and std::is_floating_point_v<S>)
            return flat_step(f.mechanics(), x);
        else
            return step(f.mechanics(), x);
    }
    /// The same from the last state, with the same length.
    HILGER_ALWAYS_INLINE bool advance_equally(Flow const& f, state<S, V>& x) { return flat_step(f.mechanics(), x); }

    [[nodiscard]] S const& h() const { return h_; }
    [[nodiscard]] int dimension() const { return static_cast<int>(last_.size()); }
    /// Everything that later steps depend on, for checkpoints.
    template <class Visit>
    void visit(Flow const& f, Visit& each) {
        each("step", h_);
        prepare(f, h_);
        each("known", known_);
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
    /// Lengths of merged neighbours add up.
    void prepare(Flow const& f, S const& h) {
        h_ = h;
        std::size_t made = 0;
        bool was_kick = not of::starts_with_kick;
        of::each(f, h, [&](bool is_kick, S const& w) {
            if (is_kick != was_kick)
                lengths_[made++] = w;
            else
                lengths_[made - 1] = lengths_[made - 1] + w;
            was_kick = is_kick;
        });
    }
    HILGER_FLATTEN bool flat_step(Problem const& what, state<S, V>& x) { return step(what, x); }
    HILGER_ALWAYS_INLINE bool step(Problem const& what, state<S, V>& x) {
        next_q_ = sum_q_;
        next_p_ = sum_p_;
        room q = q_, p = p_, v = v_, g = g_;
        q = parts_.taken(x.q);
        p = parts_.taken(x.p);
        parts_.begin();
        bool const knew = known_;
        known_ = false;
        auto const turn = [&](auto k) HILGER_ALWAYS_INLINE -> bool {
            if ((k % 2 == 0) == of::starts_with_kick) {
                if (not(k == 0 and knew) and not parts_.force(what, q, g)) return false;
                parts_.add(p, lengths_[k], g, next_p_);
            } else {
                if (not parts_.velocity(what, q, p, v)) return false;
                parts_.add(q, lengths_[k], v, next_q_);
            }
            return true;
        };
        if (not turns_made(turn, std::make_index_sequence<size>{})) return false;
        if constexpr (not std::numeric_limits<S>::is_exact)
            if (not parts_.are_finite(q, p)) [[unlikely]]
                return false;
        if constexpr (ends_with_kick) {
            last_ = q;
            g_ = g;
            known_ = true;
        }
        parts_.give(q, x.q);
        parts_.give(p, x.p);
        x.t = x.t + h_;
        sum_q_ = next_q_;
        sum_p_ = next_p_;
        return true;
    }
    /// Short sequences are unrolled, so that their index is no run-time number.
    template <class Turn, std::size_t... K>
    HILGER_ALWAYS_INLINE static bool turns_made(Turn const& turn, std::index_sequence<K...>) {
        if constexpr (in_registers)
            return (turn(std::integral_constant<std::size_t, K>{}) and ...);
        else {
            for (std::size_t k = 0; k < size; ++k)
                if (not turn(k)) return false;
            return true;
        }
    }
    /// Vectors of few components are in registers during a step; large ones stay in memory.
    using room = std::conditional_t<is_traced_state<V>, vector&, vector>;

    parts parts_;
    S h_;
    std::array<S, size> lengths_;
    vector q_, p_, v_, g_, last_; ///< the state inside the step; the position of the force g, while that is known
    bool known_ = false;
    /// The compensation of the sums, and its value inside the step.
    [[no_unique_address]] summation<of::compensated, S, shape<V>::size> sum_q_, sum_p_, next_q_, next_p_;
};

/// Whether a composition consists of kicks and drifts for states V; `perhaps` is decided by the jets or the formula of L when evaluated.
enum class kicks_and_drifts { no, perhaps, always };
template <class Flow, class S, class V>
inline constexpr kicks_and_drifts splits = [] {
    if constexpr (kick_drift_sequence<Flow>::possible) {
        using F = decltype(kick_drift_sequence<Flow>::problem_type::lagrangian);
        if (is_mechanical<F>) return kicks_and_drifts::always;
        if (may_split<F, S, V>) return kicks_and_drifts::perhaps;
    }
    return kicks_and_drifts::no;
}();

} // namespace detail
} // namespace hilger
