// SPDX-License-Identifier: BSL-1.0
// The step of any embedding without control values inside the step, given by its tableau, in any dimension: q_{i+1} = y with
//   p_i + sum_k w_k (a_k0 dL/dq + b_k0 dL/dv)(A_k, B_k) = 0,   A_k = a_k0 q_i + a_k1 y,   B_k = b_k0 q_i + b_k1 y,
// which is p_i = -d_1 L_h, and then p_{i+1} = d_2 L_h = sum_k w_k (a_k1 dL/dq + b_k1 dL/dv). Solved by Newton's method for y - q_i: of y
// itself, which differs little from q_i in a short step, a velocity would have the rounding divided by h.
//
// What the formula of L is made of decides what a step costs: its derivatives are those of a traced graph, the matrix is solved in the
// pattern that they leave, and where none of its entries ever changes it is factorized once, one correction solves the equation, and
// what does not enter the equation is evaluated at its solution only. An explicit scheme is that case.
#pragma once

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "hilger/integrator/state.hpp"
#include "hilger/integrator/step_force.hpp"
#include "hilger/integrator/summation.hpp"
#include "hilger/integrator/tableau.hpp"
#include "hilger/linear/patterned_matrix.hpp"
#include "hilger/mechanics/branch_newton.hpp"
#include "hilger/mechanics/newton_stop.hpp"
#include "hilger/mechanics/node_derivatives.hpp"
#include "hilger/mechanics/problem.hpp"

namespace hilger::detail {

template <class Problem, bool Compensated, class S, class V, class Extra = no_step_force>
class many_nodes {
    using s = shape<V>;
    using matrix = patterned_matrix<S>;
    static constexpr int history = 8;

public:
    many_nodes(tableau<S> const& t, S const& h, V const& like, Extra extra = {})
        : extra_(std::move(extra)), d_(s::dimension(like)), velocity_(s::zero(d_)), moved_(s::zero(d_)), r_(matrix::vector::Zero(d_)),
          correction_(r_), sum_q_(d_), sum_p_(d_) {
        past_.fill(s::zero(d_));
        prepare(t, h);
    }
    void prepare(tableau<S> const& t, S const& h) {
        if (steps_ > 0) velocity_ = moved_ / h_;
        if (nodes_.size() != static_cast<std::size_t>(t.nodes)) {
            nodes_.clear();
            nodes_.resize(static_cast<std::size_t>(t.nodes));
            prepared_ = false;
        }
        t_ = t;
        h_ = h;
        steps_ = 0;
        stiff_ = false;
        constants_ = reproduces_constants();
    }
    [[nodiscard]] S const& h() const { return h_; }
    void guess(V const& v) {
        velocity_ = v;
        guessed_ = 1;
    }
    [[nodiscard]] bool needs_guess() const { return guessed_ == 0; }
    [[nodiscard]] Extra& extra() { return extra_; }
    /// Everything that later steps depend on and h does not determine, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        each("steps", steps_);
        each("guessed", guessed_);
        each("newest", newest_);
        int stiff = stiff_ ? 1 : 0;
        each("stiff", stiff);
        stiff_ = stiff != 0;
        for (int c = 0; c < d_; ++c) each("velocity", s::component(velocity_, c));
        for (int c = 0; c < d_; ++c) each("increment", s::component(moved_, c));
        for (V& x : past_)
            for (int c = 0; c < d_; ++c) each("past", s::component(x, c));
        sum_q_.visit(each);
        sum_p_.visit(each);
    }

    void advance(Problem const& problem, state<S, V>& x) {
        branch_watch const watch;
        if (not prepared_) {
            moved_ = velocity_ * h_;
            evaluate(problem, x, derivatives::first_order);
            watch.forget(); // it is no part of the step
        }
        first_guess();
        long long const made = std::exchange(steps_, 0); // what a step that fails was led to is no guess for another one
        correction_.setZero();
        bool const by_newton = not constant_matrix_ and (stiff_ or not constant_mass_);
        if (not by_newton) evaluate(problem, x, derivatives::first_order);
        if (watch.saw_any())
            search(problem, x);
        else if (by_newton)
            newton(problem, x, watch);
        else if (not iterate(problem, x, watch)) {
            stiff_ = true;
            steps_ = made;
            first_guess();
            steps_ = 0;
            newton(problem, x, watch);
        }
        finish(problem, x);
        steps_ = made + 1;
    }

private:
    using derivatives = node_derivatives<Problem, V>;
    static constexpr char const* name = "the step p = -d_1 L_h(q, y)";
    static constexpr std::size_t at(int j) { return static_cast<std::size_t>(j); }
    static V value_of_nan(V x, S const& bad) {
        s::component(x, 0) = bad;
        return x;
    }
    [[nodiscard]] V const& past(int k) const { return past_[at((newest_ + k) % history)]; }
    /// By the polynomial through the last increments, as far as there are some of this step's length.
    void first_guess() {
        if (steps_ == 0)
            moved_ = velocity_ * h_;
        else if (constant_matrix_)
            moved_ = past(0); // any will do
        else if (steps_ >= history) {
            moved_ = past(0) * S(extrapolation(history, 0));
            for (int k = 1; k < history; ++k) moved_ = moved_ + past(k) * S(extrapolation(history, k));
        } else if (steps_ >= 2)
            moved_ = past(0) * S(2) - past(1);
        else
            moved_ = past(0);
    }
    /// What block `b` of node k is multiplied by in the matrix.
    [[nodiscard]] S factor(int k, int b) const {
        S const w = t_.w(k) * (b == block_qq or b == block_qv ? t_.a(k, 0) : t_.b(k, 0));
        return w * (b == block_qq or b == block_vq ? t_.a(k, 1) : t_.b(k, 1));
    }
    /// Whether the gradients at node k are affine in y: then a correction to first order is the whole of it.
    [[nodiscard]] bool is_affine(int k) const {
        auto const& places = nodes_[at(k)].places();
        auto const block = [&](block_number b) { return places.constant[b] or places.entries[b].empty(); };
        return (t_.a(k, 1) == S(0) or (block(block_qq) and block(block_vq))) and
               (t_.b(k, 1) == S(0) or (block(block_qv) and block(block_vv)));
    }
    [[nodiscard]] V position(state<S, V> const& x, int k) const {
        return x.q * (constants_ ? S(1) : S(t_.a(k, 0) + t_.a(k, 1))) + moved_ * t_.a(k, 1);
    }
    [[nodiscard]] V velocity(state<S, V> const& x, int k) const {
        return constants_ ? V(moved_ * t_.b(k, 1)) : V(x.q * S(t_.b(k, 0) + t_.b(k, 1)) + moved_ * t_.b(k, 1));
    }
    void evaluate(Problem const& problem, state<S, V> const& x, int which) {
        bool is_new = not prepared_;
        for (int k = 0; k < t_.nodes; ++k) {
            bool const no_force =
                prepared_ and constant_matrix_ and which == derivatives::first_order and again_[at(k)] and t_.w(k) * t_.a(k, 0) == S(0);
            if (nodes_[at(k)].compute(problem, t_.time(k, x.t, h_), position(x, k), velocity(x, k),
                                      no_force ? derivatives::momenta_only : which))
                is_new = true;
        }
        if (is_new) prepare_matrices();
    }
    /// For the formulas that there are now: the matrix of the equation, and what of it never changes, which is all of it, or the masses at
    /// least, or is not used.
    void prepare_matrices() {
        std::vector<std::pair<int, int>> entries, constant;
        constant_matrix_ = constant_mass_ = true;
        again_.assign(at(t_.nodes), false);
        for (int k = 0; k < t_.nodes; ++k) {
            again_[at(k)] = not is_affine(k);
            auto const& places = nodes_[at(k)].places();
            if (nodes_[at(k)].has_branches()) constant_matrix_ = false; // the next branch may be another formula
            if (places.entries[block_vv].empty() or not places.constant[block_vv]) constant_mass_ = false;
            for (int b = 0; b < blocks; ++b) {
                auto const& block = places.entries[at(b)];
                if (block.empty() or factor(k, b) == S(0)) continue;
                for (auto const& e : block) entries.emplace_back(e.row, e.column);
                if (places.constant[at(b)])
                    for (auto const& e : block) constant.emplace_back(e.row, e.column);
                else
                    constant_matrix_ = false;
            }
        }
        if (std::numeric_limits<S>::is_exact) constant_mass_ = false; // an iteration converges, and is never exact
        K_.prepare(d_, constant);
        factors_are_of_ = S(0);
        J_.prepare(d_, entries);
        places_.assign(at(t_.nodes), {});
        for (int k = 0; k < t_.nodes; ++k)
            for (int b = 0; b < blocks; ++b)
                if (not(factor(k, b) == S(0)))
                    for (auto const& e : nodes_[at(k)].places().entries[at(b)]) places_[at(k)][at(b)].push_back(J_.place(e.row, e.column));
        prepared_ = true;
    }
    /// With what of the matrix never changes: one correction where that is all of it, else a gradient and a correction a round, each
    /// smaller by a factor of the size h^2 |M^-1 U''|. False where that is not much less than one.
    bool iterate(Problem const& problem, state<S, V> const& x, branch_watch const& watch) {
        S previous(-1);
        for (int round = 0; round < most_iterations<S>; ++round) {
            if (round > 0) evaluate(problem, x, derivatives::first_order);
            if (watch.saw_any()) {
                search(problem, x);
                return true;
            }
            put_residual(x);
            refuse_nan(x, previous);
            if (not K_.is_factorized() or not(factors_are_of_ == h_)) {
                put_constant_matrix();
                if (not K_.factorize()) {
                    if (constant_matrix_) refuse(x, true, S(0));
                    return false;
                }
                factors_are_of_ = h_;
            }
            correct(K_);
            tally<S>::add(work::newton_round);
            if (constant_matrix_) return true;
            S const size = magnitude(correction_), floor = epsilon<S>() * magnitude(moved_);
            // What is left is the rate times this correction, and the rate is the ratio of two corrections.
            if (size <= floor * S(8) or (round > 8 and size <= floor * S(64)) or
                (previous > S(0) and size * (size / previous) <= floor * S(Compensated ? 1 : 128) / S(256))) {
                correction_.setZero(); // of the size of the rounding in the gradients
                return true;
            }
            if (previous > S(0) and not(S(4) * size < previous) and S(1024) * floor < size) return false;
            previous = size;
        }
        return false;
    }
    void newton(Problem const& problem, state<S, V> const& x, branch_watch const& watch) {
        bool singular = false;
        S size(0);
        S const small = small_correction();
        for (int iteration = 0; iteration < most_iterations<S>; ++iteration) {
            evaluate(problem, x, derivatives::with_seconds);
            if (watch.saw_any()) return search(problem, x);
            put_residual(x);
            refuse_nan(x, size);
            put_matrix();
            singular = not J_.factorize();
            if (singular) break;
            correct(J_);
            tally<S>::add(work::newton_round);
            size = magnitude(correction_);
            bool const floor = iteration > 0 and magnitude(r_) <= S(8) * epsilon<S>() * (magnitude(x.p) + forces());
            if (size <= small * magnitude(moved_) or floor) return;
        }
        refuse(x, singular, size);
    }
    static S small_correction() { return square_root_of_epsilon<S>() / S(Compensated ? 1024 : 4); }
    void correct(matrix& K) {
        correction_ = r_;
        K.solve(correction_);
        for (int c = 0; c < d_; ++c) s::component(moved_, c) = s::component(moved_, c) - correction_(c);
    }
    void refuse_nan(state<S, V> const& x, S const& size) {
        if (is_finite(r_)) return;
        for (int k = 0; k < d_; ++k)
            if (not is_finite(r_(k))) give_up(name, false, x.q, value_of_nan(x.q, r_(k)), size);
    }
    [[noreturn]] void refuse(state<S, V> const& x, bool singular, S const& size) {
        V rest = s::zero(d_);
        for (int c = 0; c < d_; ++c) s::component(rest, c) = r_(c);
        give_up(name, singular, V(x.q + moved_), rest, size);
    }
    void put_residual(state<S, V> const& x) {
        for (int c = 0; c < d_; ++c) r_(c) = s::component(x.p, c);
        for (int k = 0; k < t_.nodes; ++k) {
            S const wa = t_.w(k) * t_.a(k, 0), wb = t_.w(k) * t_.b(k, 0);
            auto const& e = nodes_[at(k)];
            if (wa == S(0))
                for (int c = 0; c < d_; ++c) r_(c) = r_(c) + wb * e.by_v(c);
            else
                for (int c = 0; c < d_; ++c) r_(c) = r_(c) + wa * e.by_q(c) + wb * e.by_v(c);
        }
        if constexpr (has_step_force<Extra>) { // h/2 F
            S const half = h_ / S(2);
            for (int c = 0; c < d_; ++c) r_(c) = r_(c) + half * extra_.at(s::component(moved_, c), c);
        }
    }
    void put_constant_matrix() {
        K_.set_zero();
        for (int k = 0; k < t_.nodes; ++k)
            for (int b = 0; b < blocks; ++b) {
                S const c = factor(k, b);
                if (c == S(0) or not nodes_[at(k)].places().constant[at(b)]) continue;
                for (auto const& e : nodes_[at(k)].places().entries[at(b)]) {
                    S& entry = K_[K_.place(e.row, e.column)];
                    entry = entry + c * tally<S>::second(nodes_[at(k)].value(e.place));
                }
            }
        put_resistance(K_);
    }
    void put_resistance(matrix& K) {
        if constexpr (has_step_force<Extra>)
            for (int c = 0; c < d_; ++c) {
                S& entry = K[K.place(c, c)];
                entry = entry - h_ / S(2) * s::component(extra_.slope, c);
            }
    }
    /// The derivative of the residual.
    void put_matrix() {
        J_.set_zero();
        for (int k = 0; k < t_.nodes; ++k)
            for (int b = 0; b < blocks; ++b) {
                auto const& block = nodes_[at(k)].places().entries[at(b)];
                auto const& to = places_[at(k)][at(b)];
                if (to.empty()) continue;
                S const c = factor(k, b);
                for (std::size_t i = 0; i < to.size(); ++i) {
                    S& entry = J_[to[i]];
                    entry = entry + c * tally<S>::second(nodes_[at(k)].value(block[i].place));
                }
            }
        put_resistance(J_);
    }
    /// The same for an L with branches: moved_ and the derivatives there.
    void search(Problem const& problem, state<S, V> const& x) {
        auto const evaluate_at = [&](V const& y, V& r) {
            moved_ = y;
            evaluate(problem, x, derivatives::with_seconds);
            put_residual(x);
            put_matrix();
            for (int c = 0; c < d_; ++c) s::component(r, c) = r_(c);
            S const reach = magnitude(x.q) + magnitude(y);
            S bends(0);
            for (int k = 0; k < t_.nodes; ++k)
                for (auto const& e : nodes_[at(k)].places().entries[block_qq])
                    if (S const size = magnitude(S(t_.w(k) * nodes_[at(k)].value(e.place))); bends < size) bends = size;
            return S(magnitude(x.p) + forces() + S(d_) * (bends * reach + J_.largest() * magnitude(y)));
        };
        auto const correct = [&](V const& r, V& d) {
            tally<S>::add(work::newton_round);
            if (not J_.factorize()) return false;
            for (int c = 0; c < d_; ++c) correction_(c) = s::component(r, c);
            J_.solve(correction_);
            for (int c = 0; c < d_; ++c) s::component(d, c) = -correction_(c);
            return true;
        };
        V rest = moved_;
        V y = moved_;
        branch_search const how = search_branches(y, rest, evaluate_at, correct, small_correction());
        if (how != branch_search::found) give_up_on_branches(name, how, V(x.q + y), rest);
        correction_.setZero();
    }
    /// a_k0 + a_k1 = 1 and b_k0 + b_k1 = 0 at every node, to rounding.
    [[nodiscard]] bool reproduces_constants() const {
        S const rounding = S(64) * epsilon<S>();
        for (int k = 0; k < t_.nodes; ++k) {
            S const size_b = magnitude(t_.b(k, 0)) + magnitude(t_.b(k, 1));
            if (not(magnitude(S(t_.a(k, 0) + t_.a(k, 1) - S(1))) <= rounding) or
                not(magnitude(S(t_.b(k, 0) + t_.b(k, 1))) <= rounding * size_b))
                return false;
        }
        return true;
    }
    /// The size of what the residual is a sum of.
    [[nodiscard]] S forces() const {
        S sum(0);
        for (int k = 0; k < t_.nodes; ++k) {
            S f(0), m(0);
            for (int c = 0; c < d_; ++c) {
                f = std::max(f, S(magnitude(nodes_[at(k)].by_q(c))));
                m = std::max(m, S(magnitude(nodes_[at(k)].by_v(c))));
            }
            sum = sum + magnitude(t_.w(k)) * f + m;
        }
        if constexpr (has_step_force<Extra>) sum = sum + magnitude(h_) * magnitude(extra_.constant);
        return sum;
    }
    /// The last correction is applied to the gradients to first order, or they are evaluated again where that is not enough. As
    /// a_k0 + a_k1 = 1 and b_k0 + b_k1 = 0 the equations add up to p_{i+1} = p_i + sum_k w_k dL/dq, which rounds better than the
    /// definition; embeddings that do not reproduce constants use the latter.
    void finish(Problem const& problem, state<S, V>& x) {
        V increment = s::zero(d_), whole = s::zero(d_);
        for (int k = 0; k < t_.nodes; ++k) {
            auto& e = nodes_[at(k)];
            bool const again = constant_matrix_ and again_[at(k)];
            if (again) {
                int const which = constants_ ? derivatives::forces_only : derivatives::first_order;
                (void)e.compute(problem, t_.time(k, x.t, h_), position(x, k), velocity(x, k), which);
            }
            S const &w = t_.w(k), &a = t_.a(k, 1), &b = t_.b(k, 1);
            for (int c = 0; c < d_; ++c) s::component(increment, c) = s::component(increment, c) + w * e.by_q(c);
            if (not constants_)
                for (int c = 0; c < d_; ++c) s::component(whole, c) = s::component(whole, c) + w * (a * e.by_q(c) + b * e.by_v(c));
            if (again) continue;
            for (int block = 0; block < blocks; ++block) {
                S const& by = block == block_qq or block == block_vq ? a : b;
                if (by == S(0)) continue;
                bool const of_force = block == block_qq or block == block_qv;
                for (auto const& entry : e.places().entries[at(block)]) {
                    S const change = w * (e.value(entry.place) * (by * correction_(entry.column)));
                    if (of_force) s::component(increment, entry.row) = s::component(increment, entry.row) - change;
                    if (not constants_) s::component(whole, entry.row) = s::component(whole, entry.row) - (of_force ? a : b) * change;
                }
            }
        }
        if constexpr (has_step_force<Extra>)
            for (int c = 0; c < d_; ++c) {
                S const impulse = h_ * extra_.at(s::component(moved_, c), c);
                s::component(increment, c) = s::component(increment, c) + impulse;
                s::component(whole, c) = s::component(whole, c) + impulse / S(2);
            }
        V const q = x.q + moved_, p = constants_ ? V(x.p + increment) : whole;
        if (not all_finite(q) or not all_finite(p)) give_up(name, false, x.q, V((q - q) + (p - p)), S(0)); // infinity less itself is NaN
        for (int c = 0; c < d_; ++c) {
            sum_q_.add(s::component(x.q, c), s::component(moved_, c), c);
            if (constants_)
                sum_p_.add(s::component(x.p, c), s::component(increment, c), c);
            else
                s::component(x.p, c) = s::component(whole, c);
        }
        x.t = x.t + h_;
        newest_ = (newest_ + history - 1) % history;
        past_[at(newest_)] = moved_;
    }

    [[no_unique_address]] Extra extra_;
    int d_;
    tableau<S> t_;
    S h_{0};
    long long steps_ = 0; ///< of this length
    int guessed_ = 0, newest_ = 0;
    bool constants_ = true;
    V velocity_; ///< to start from where there are no steps of this length
    V moved_;    ///< y - q_i: of the last step, and of this one while it is made
    std::array<V, history> past_;
    std::vector<derivatives> nodes_;
    std::vector<std::array<std::vector<int>, blocks>> places_; ///< of the entries of each node's blocks in the matrix
    std::vector<bool> again_;                                  ///< where gradients are not affine in y
    bool prepared_ = false, constant_matrix_ = false, constant_mass_ = false, stiff_ = false;
    typename matrix::vector r_, correction_;
    matrix J_, K_;
    S factors_are_of_{0}; ///< the step
    [[no_unique_address]] summation<Compensated, S, s::size> sum_q_;
    [[no_unique_address]] summation<Compensated, S, s::size> sum_p_;
};

} // namespace hilger::detail
