// SPDX-License-Identifier: BSL-1.0
// The step of an embedding whose integral has one node: mid-point, order one, theta. With the velocity v at the node as the unknown,
//   A = q_i + a_1 h v,   p_i + a_0 h dL/dq(A, v) - dL/dv(A, v) = 0,   q_{i+1} = q_i + h v,   p_{i+1} = p_i + h dL/dq(A, v),
// which is p_i = -d_1 L_h, p_{i+1} = d_2 L_h written out (Cresson-Safi (95), (96) for a_0 = a_1 = 1/2). For d <= 4 everything is kept in
// scalars that the optimiser can put into registers: no Eigen arithmetic, no loop that is not unrolled.
#pragma once

#include "hilger/inlining.hpp"
#include "hilger/newton/small_solve.hpp"
#include "hilger/step/force.hpp"
#include "hilger/step/small/node.hpp"
#include "hilger/step/small/search.hpp"
#include "hilger/step/state.hpp"
#include "hilger/step/summation.hpp"
#include "hilger/step/tableau.hpp"

namespace hilger::detail {

/// State that one trajectory keeps from step to step.
template <class Problem, embedding_facts Facts, bool Compensated, class S, class V, class Extra = no_step_force>
class one_node {
    using s = shape<V>;
    static constexpr int N = s::size;
    using components_ = std::array<S, static_cast<std::size_t>(N)>;
    using matrix_ = std::array<S, static_cast<std::size_t>(N* N)>;
    using all = std::make_integer_sequence<int, N>;
    using every = std::make_integer_sequence<int, N * N>;

    using search = small_search<Compensated, S, V, all>;
    static constexpr bool exact = std::numeric_limits<S>::is_exact;
    static constexpr bool at_start = Facts.at_start, at_end = Facts.at_end, order_one = at_start or at_end;
    /// Whether a position or a momentum is rounded inside the step.
    static constexpr bool keeps_rests = Compensated and not exact and not order_one;
    /// Number of velocities that the first guess is extrapolated from; rationals would only grow.
    static constexpr int history = exact or order_one ? 1 : 7;

public:
    /// `like` has the dimension of the states to come.
    one_node(tableau<S> const& t, S const& h, V const& /*like*/, Extra extra = {}) : extra_(std::move(extra)) { prepare(t, h); }
    void prepare(tableau<S> const& t, S const& h) {
        h_ = h;
        w_ = t.w(0);
        node_ = t.a(0, 1) * h;
        c_ = w_ * t.a(0, 1);
        f_ = w_ * t.a(0, 0);
        add_up_to(w_, c_, f_);
        known_ = known_ > 0 ? 1 : 0; // velocities at other distances do not extrapolate
    }
    [[nodiscard]] S const& h() const { return h_; }
    /// The velocity guess of a first step.
    void guess(V const& v) {
        if (known_ > 0) return;
        past_[0] = components(v, all{});
        known_ = 1;
    }
    [[nodiscard]] bool needs_guess() const { return known_ == 0; }
    [[nodiscard]] Extra& extra() { return extra_; }
    /// Everything that later steps depend on and h does not determine, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        each("known", known_);
        for (auto& v : past_)
            for (S& x : v) each("velocity", x);
        sum_q_.visit(each);
        sum_p_.visit(each);
    }

    /// @throws error::no_convergence, error::singular, error::not_finite as a step_failure; `x` is then as it was.
    HILGER_ALWAYS_INLINE void advance(Problem const& problem, state<S, V>& x) { chosen_advance(problem, x); }

private:
    HILGER_ALWAYS_INLINE void chosen_advance(Problem const& problem, state<S, V>& x) {
        std::uint64_t const compared_before = comparisons_made();
        if (not flat_or_not(problem, x)) [[unlikely]]
            search_step(problem, x, comparisons_made() != compared_before, all{});
    }
    HILGER_ALWAYS_INLINE bool flat_or_not(Problem const& problem, state<S, V>& x) {
        if constexpr (std::is_floating_point_v<S>)
            return flat_advance(problem, x);
        else
            return advance(problem, x, all{}, every{});
    }
    HILGER_FLATTEN bool flat_advance(Problem const& problem, state<S, V>& x) { return advance(problem, x, all{}, every{}); }

    /// Newton's method. @returns false, with x unchanged, if it fails: with branches it finds a root on the branch of the last round, which
    /// may not be that of the root; an extrapolated guess may lie outside the domain of L, or too far away in long steps.
    template <int... K, int... M>
    HILGER_ALWAYS_INLINE bool advance(Problem const& problem, state<S, V>& x, std::integer_sequence<int, K...> every_component,
                                      std::integer_sequence<int, M...>) {
        using std::abs;
        components_ const q{s::component(x.q, K)...}, p{start<K>(x.p)...};
        // Equal numbers share one name where the type says so: the compiler then evaluates their expressions once.
        S const w = w_, c = at_end ? w : c_, f = at_start ? w : f_, t = x.t + node_;
        // Magnitudes: a step may go back in time.
        S const w_size = abs(w), c_size = abs(c), f_size = abs(f), rest = rest_of_newton<S, Compensated>();
        // For order one dL/dv = p + ... is often linear in v, and any first guess serves.
        components_ v = order_one ? components_{} : first_guess(every_component);
        components_ r{};
        components_ d{};
        int settled = 0; // how often all components together were at their floor, and one of them not
        for (int iteration = 0; iteration < most_iterations<S>; ++iteration) {
            std::uint64_t const compared = comparisons_made();
            components_ const A{(at_start ? q[K] : S(q[K] + c * v[K]))...};
            auto const e = evaluate<s::is_scalar>(problem, t, A, v, every_component);
            bool const branched = comparisons_made() != compared;
            components_ g{(at_end ? S(0) : S(e.template by_q<K>()))...}; // at the end it is evaluated once v is known
            r = components_{S(minus(at_end ? p[K] : S(p[K] + f * g[K]), e.template by_v<K>()))...};
            // c and f are zero by the type where the position is one of the ends
            if constexpr (has_step_force<Extra>) ((r[K] = r[K] - half_resistance<K>() * v[K]), ...);
            matrix_ const D{(order_one ? e.template qv<M / N, M % N>()
                                       : plus(times(c, e.template qq<M / N, M % N>()), e.template qv<M / N, M % N>()))...};
            matrix_ J{minus(at_start ? e.template vv<M / N, M % N>()
                                     : plus(e.template vv<M / N, M % N>(), times(c, e.template vq<M / N, M % N>())),
                            at_end ? S(0) : times(f, D[M]))...};
            if constexpr (has_step_force<Extra>) ((J[static_cast<std::size_t>(K * N + K)] += half_resistance<K>()), ...);
            bool const quadratic = not e.on().coupled and e.on().v <= 2;
            if constexpr (order_one)
                if (iteration == 0 and not quadratic) {
                    v = past_[0];
                    continue;
                }
            d = r;
            if (not small_solve(J, d)) [[unlikely]]
                return false; // singular at this guess, perhaps not at the velocity
            [[maybe_unused]] components_ const v_before = v;
            components_ g_rest{};
            v = components_{order_one and iteration == 0 ? d[K] : S(v[K] + d[K])...};
            bool done;
            if constexpr (order_one) {
                done = quadratic or is_at_the_floor(d, v, r, p, f_size, g);
                if (at_start and (not quadratic or has_force<Problem>)) (add_row<K>(g, D, d), ...); // g is of the v before
            } else {
                components_ change{};
                (add_row<K>(change, D, d), ...);
                done = quadratic ? e.on().q <= 2 or is_negligible(c_size, A, v, d, w_size, g, change, p, rest)
                                 : is_at_the_floor(d, v, r, p, f_size, g);
                if constexpr (keeps_rests)
                    if (done)
                        look_at_rests(last_round<S, static_cast<std::size_t>(N)>{c, f, q, p, v_before, g, d, J, D}, e, v, g_rest, change,
                                      every_component);
                g = components_{plus(g[K], change[K])...};
            }
            if (not done and (iteration == 0 or not is_rounding<K...>(r, p, f_size, g, settled))) continue;
            if constexpr (at_end) {
                components_ const B{plus(q[K], S(c * v[K]))...};
                auto const again = evaluate<s::is_scalar>(problem, t, B, v, every_component);
                g = components_{again.template by_q<K>()...};
            }
            if (branched or not is_near_the_last<K...>(iteration, v)) [[unlikely]]
                return false;
            // A finite v and g may still lead beyond the largest number.
            if constexpr (not exact)
                if (not(overflow_in<K...>(q, p, w, v, g, g_rest) == S(0))) [[unlikely]]
                    return false;
            take<K...>(x, w, v, g, g_rest);
            return true;
        }
        return false;
    }
    /// If masses grow without bound, as near the speed of light, corrections are small: they prove nothing beside a large r.
    HILGER_ALWAYS_INLINE static bool is_at_the_floor(components_ const& d, components_ const& v, components_ const& r, components_ const& p,
                                                     S const& f_size, components_ const& g) {
        return at_the_floor(d, v, rest_of_newton<S, Compensated>()) and (exact or largest(r) <= largest(p) + f_size * largest(g));
    }
    /// Adds the rounding errors to v and g after the last round; g_rest then includes `change`.
    template <class Derivatives, int... K>
    HILGER_ALWAYS_INLINE void look_at_rests(last_round<S, static_cast<std::size_t>(N)> round, Derivatives const& e, components_& v,
                                            components_& g_rest, components_& change, std::integer_sequence<int, K...> every_component) {
        round.look_at_rests(e, sum_q_, sum_p_, change, every_component, every{});
        v = components_{S(round.v[K] + (round.d[K] + round.more[K]))...};
        g_rest = round.of_g;
        change = components_{}; // included in g_rest
    }
    /// Whether the residual before the last correction was rounding. Convergence is quadratic in each component: small ones beside large
    /// ones take up to two more rounds.
    template <int... K>
    HILGER_ALWAYS_INLINE static bool is_rounding(components_ const& r, components_ const& p, S const& f_size, components_ const& g,
                                                 int& settled) {
        using std::abs;
        if (not(largest(r) <= S(4) * epsilon<S>() * (largest(p) + f_size * largest(g)))) return false;
        if constexpr (N > 1)
            if (settled < 2 and not((abs(r[K]) <= S(4) * epsilon<S>() * (abs(p[K]) + f_size * abs(g[K]))) and ...)) {
                ++settled;
                return false;
            }
        return true;
    }
    template <int... K>
    HILGER_ALWAYS_INLINE bool is_near_the_last(int iteration, components_ const& v) const {
        if constexpr (exact or order_one)
            return true;
        else
            return is_near(iteration, known_, change_of<K...>(v, past_[0]), change_of<K...>(past_[0], past_[1]),
                           change_of<K...>(past_[1], past_[2]));
    }
    /// The step by a search, from its beginning.
    template <int... K>
    HILGER_ALWAYS_INLINE void search_step(Problem const& problem, state<S, V>& x, bool has_branches,
                                          std::integer_sequence<int, K...> every_component) {
        S const c = at_end ? w_ : c_, f = at_start ? w_ : f_;
        components_ const v = first_guess(every_component);
        auto const found = search::root(problem, has_branches, x.t, h_, node_, w_, c, f, s::component(x.q, K)..., start<K>(x.p)..., v[K]...,
                                        past_[0][K]..., half_resistance<K>()...);
        take<K...>(x, w_, found.v, found.g, components_{});
    }
    template <int... K>
    HILGER_ALWAYS_INLINE void take(state<S, V>& x, S const& w, components_ const& v, components_ const& g, components_ const& g_rest) {
        ((sum_q_.add(s::component(x.q, K), S(w * v[K]), K), sum_p_.add(s::component(x.p, K), gained<K>(w, g, v, g_rest), K)), ...);
        x.t = x.t + h_;
        remember(v);
    }
    /// The momentum at the start plus the velocity-independent part of the extra force.
    template <int K>
    HILGER_ALWAYS_INLINE S start(V const& p) const {
        if constexpr (has_step_force<Extra>)
            return S(s::component(p, K) + h_ / S(2) * s::component(extra_.constant, K));
        else
            return s::component(p, K);
    }
    /// -h/2 dF/dv
    template <int K>
    HILGER_ALWAYS_INLINE S half_resistance() const {
        if constexpr (not has_step_force<Extra>)
            return S(0);
        else
            return S(h_ / S(2) * w_ * s::component(extra_.slope, K));
    }
    /// The change of the momentum in the step.
    template <int K>
    HILGER_ALWAYS_INLINE S gained(S const& w, components_ const& g, components_ const& v, components_ const& g_rest) const {
        S sum = w * g[K];
        if constexpr (has_step_force<Extra>) sum = sum + h_ * extra_.at(S(w * v[K]), K);
        if constexpr (keeps_rests) sum = sum + w * g_rest[K];
        return sum;
    }
    template <int... K>
    HILGER_ALWAYS_INLINE static S change_of(components_ const& v, components_ const& before) {
        return largest(components_{S(v[K] - before[K])...});
    }
    template <int... K>
    HILGER_ALWAYS_INLINE S overflow_in(components_ const& q, components_ const& p, S const& w, components_ const& v, components_ const& g,
                                       components_ const& g_rest) const {
        return S((overflow(S(q[K] + w * v[K])) + ...) + (overflow(S(p[K] + gained<K>(w, g, v, g_rest))) + ...));
    }
    /// Extrapolates the polynomial through the last velocities to the next node.
    template <int... K>
    HILGER_ALWAYS_INLINE components_ first_guess(std::integer_sequence<int, K...>) const {
        if (known_ == history) return {extrapolated<K>(std::make_integer_sequence<int, history>{})...};
        if constexpr (history > 1)
            if (known_ >= 2) return {S(past_[0][K] + (past_[0][K] - past_[1][K]))...};
        return past_[0];
    }
    template <int K, int... I>
    HILGER_ALWAYS_INLINE S extrapolated(std::integer_sequence<int, I...>) const {
        return ((S(extrapolation(history, I)) * past_[I][K]) + ...);
    }
    template <int... I>
    HILGER_ALWAYS_INLINE void shift(std::integer_sequence<int, I...>) {
        ((past_[history - 1 - I] = past_[history - 2 - I]), ...);
    }
    HILGER_ALWAYS_INLINE void remember(components_ const& v) {
        if constexpr (history > 1) {
            shift(std::make_integer_sequence<int, history - 1>{});
            if (known_ < history) ++known_;
        }
        past_[0] = v;
    }
    S h_, w_, node_, c_, f_;
    [[no_unique_address]] Extra extra_;
    std::array<components_, static_cast<std::size_t>(history)> past_{};
    int known_ = 0;
    [[no_unique_address]] summation<Compensated, S, N> sum_q_;
    [[no_unique_address]] summation<Compensated, S, N> sum_p_;
};

} // namespace hilger::detail
