// SPDX-License-Identifier: BSL-1.0
// The step of any embedding in any dimension: its equation (step/equation.hpp) solved for U_m - q_i. These differences are small in a short
// step; velocities computed from the U_m would carry their rounding divided by h.
//
// The formula of L selects the solver. A constant matrix is factorized once, one correction solves the equation, and terms outside of it
// are evaluated at its solution only: explicit schemes are that case. Constant masses alone serve as the matrix while that converges fast.
// Otherwise Newton's method.
#pragma once

#include <limits>
#include <optional>
#include <utility>

#include "hilger/newton/newton.hpp"
#include "hilger/newton/past_steps.hpp"
#include "hilger/newton/stop.hpp"
#include "hilger/step/equation.hpp"
#include "hilger/step/summation.hpp"
#include "hilger/step/tableau.hpp"

namespace hilger::detail {

template <bool Compensated, class S, class V, class Extra = no_step_force, int Controls = 2>
class many_nodes {
    using s = shape<V>;
    using equation = step_equation<S, V, Extra, Controls>;
    using unknown = typename equation::unknown;
    using u = shape<unknown>;
    using matrix = typename equation::matrix;
    using vector = typename equation::vector;

public:
    many_nodes(tableau<S> const& t, S const& h, V const& like, Extra extra = {})
        : e_(like, std::move(extra)), velocity_(zero_like(like)), past_(e_.moved), correction_(vector::Zero(e_.unknowns())),
          weighed_(correction_), sums_(s::dimension(like)) {
        prepare(t, h);
    }
    void prepare(tableau<S> const& t, S const& h) {
        if (steps_ > 0) velocity_ = e_.end() / e_.h();
        e_.prepare(t, h);
        steps_ = 0;
        stiff_ = not iterates_;
    }
    [[nodiscard]] S const& h() const { return e_.h(); }
    void guess(V const& v) {
        velocity_ = v;
        guessed_ = 1;
    }
    [[nodiscard]] bool needs_guess() const { return guessed_ == 0; }
    [[nodiscard]] Extra& extra() { return e_.extra; }
    /// Everything that later steps depend on and h does not determine, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        each("steps", steps_);
        each("guessed", guessed_);
        int stiff = stiff_ ? 1 : 0;
        each("stiff", stiff);
        stiff_ = stiff != 0;
        memory::visit_components("velocity", velocity_, each);
        memory::visit_components("increment", e_.moved, each);
        past_.visit("past", each);
        sums_.visit(each);
    }

    void advance(given_problem<V> const& problem, state<S, V>& x) {
        solve(problem, x);
        if (not e_.adds_up)
            for (int c = 0; c < dimension(); ++c) e_.increment(c) = e_.whole(c) - s::component(x.p, c);
        sums_.add(x, e_.h(), e_.displacement(), e_.increment, name);
        if (not e_.adds_up)
            for (int c = 0; c < dimension(); ++c) s::component(x.p, c) = e_.whole(c);
    }
    /// Solves the equation: moved() is q_{i+1} - q_i, and gained() is p_{i+1} - p_i for embeddings that reproduce constants. Leaves the
    /// state unchanged; advance makes the step.
    void solve(given_problem<V> const& problem, state<S, V> const& x) {
        branch_watch const watch;
        if (not e_.is_prepared) {
            unknown const last = e_.moved;
            e_.move_with(velocity_);
            (void)e_.evaluate(problem, x, wanted::first_order);
            e_.moved = last;
            watch.forget(); // it is no part of the step
        }
        first_guess(steps_);
        // The result of a failed step is no guess for another one; increments with a constant matrix are not kept.
        long long const steps = std::exchange(steps_, 0), made = e_.is_constant ? 0 : steps;
        if (not whole_corrections(problem, x, watch, made)) {
            if (not searches_ and not watch.saw_any()) refuse(x, newton_outcome::lost, e_.residual);
            search(problem, x, watch.saw_any(), made);
        }
        e_.gather(problem, x, correction_, corrected_);
        if (not e_.is_constant) past_.keep(e_.moved);
        steps_ = made + 1;
    }
    [[nodiscard]] decltype(auto) moved() const { return e_.end(); }
    [[nodiscard]] auto const& gained() const { return e_.increment; }
    /// U_m - q_i of the last step, 0 < m < n.
    [[nodiscard]] V inside(int m) const { return e_.moved_to(m); }
    /// Steps by Newton's method alone.
    void do_not_iterate() {
        iterates_ = false;
        stiff_ = true;
    }
    /// Refuses a step in which full corrections do not converge, unless L has branches: for who takes a shorter one then.
    void do_not_search() { searches_ = false; }
    /// Forgets earlier steps, except for v as a guess.
    void restart(V const& v) {
        steps_ = 0;
        guess(v);
    }

    static constexpr char const* name = "the step p = -d_1 L_h(q, y)";

private:
    [[nodiscard]] int dimension() const { return e_.dimension(); }
    /// Extrapolates the last `known` increments, all of this step length.
    void first_guess(long long known) {
        if (known == 0)
            e_.move_with(velocity_);
        else if (not e_.is_constant) // otherwise any guess serves
            past_.guess(e_.moved, known);
    }
    /// @returns false if full corrections do not converge, or L has branches: then a search follows
    bool whole_corrections(given_problem<V> const& problem, state<S, V> const& x, branch_watch const& watch, long long made) {
        if (e_.is_constant or (not stiff_ and e_.has_constant_mass)) {
            if (iterate(problem, x, watch)) return true;
            if (watch.saw_any() or not is_finite(e_.residual)) return false;
            stiff_ = e_.has_constant_mass;
            first_guess(made);
        }
        return whole_newton(problem, x, watch, made);
    }
    /// Iterates with the constant part of the matrix: one correction if that is the whole matrix, else a gradient and a correction a round,
    /// with a rate of order h^2 |M^-1 U''|. @returns false if the rate is not well below one
    bool iterate(given_problem<V> const& problem, state<S, V> const& x, branch_watch const& watch) {
        S previous(-1);
        for (int round = 0; round < most_iterations<S>; ++round) {
            (void)e_.evaluate(problem, x, wanted::first_order);
            if (watch.saw_any()) return false;
            e_.put_residual(x);
            if (not is_finite(e_.residual)) {
                if (e_.is_constant) refuse_nan(x);
                return false;
            }
            if (not e_.factorize_constant_part()) {
                if (e_.is_constant) refuse(x, newton_outcome::singular, e_.residual);
                return false;
            }
            correct(e_.constant_part);
            if (e_.is_constant) {
                // The rounding of the factors leaves a biased part of the correction in every step.
                if (Compensated and round == 0) continue;
                return true;
            }
            if (round == 0) weigh(x, e_.constant_part);
            S const size = weighed_.size_of(correction_), floor = epsilon<S>();
            // The remainder is the rate times this correction; the rate is the ratio of two corrections.
            if (size <= floor * S(8) or (round > 8 and size <= floor * S(64)) or
                (previous > S(0) and size * (size / previous) <= small() * e_.share_of_force()) or is_rounding_of(x, size, previous)) {
                corrected_ = corrected::in_constants; // the rate does not cover these
                return true;
            }
            if (previous > S(0) and not(S(4) * size < previous) and S(1024) * floor < size) return false;
            previous = size;
        }
        return false;
    }
    /// Largest admissible remainder of the equation when no correction follows.
    static S small() { return epsilon<S>() * S(Compensated ? 1 : 128) / S(256); }
    bool whole_newton(given_problem<V> const& problem, state<S, V> const& x, branch_watch const& watch, long long made) {
        constexpr bool exact = std::numeric_limits<S>::is_exact;
        bool singular = false;
        S size(0), previous(-1), farthest(0);
        S const small = small_correction(), guessed = magnitude(e_.moved);
        for (int iteration = 0; iteration < most_iterations<S>; ++iteration) {
            (void)e_.evaluate(problem, x, wanted::with_seconds);
            if (watch.saw_any()) return false;
            e_.put_residual(x);
            if (not is_finite(e_.residual)) return false;
            e_.put_matrix();
            singular = not e_.full_matrix.factorize();
            if (singular) break;
            correct(e_.full_matrix);
            if (iteration == 0 or exact) weigh(x, e_.full_matrix);
            size = weighed_.size_of(correction_);
            S const largest = magnitude(correction_);
            if ((weighed_.is_last(correction_, e_.moved, small) or (iteration > 0 and e_.is_rounding(x)) or
                 is_rounding_of(x, size, previous)) and
                not is_elsewhere(x))
                return exact or is_near_the_last(iteration, made);
            if (not searches_ and largest <= epsilon<S>() * guessed) return true; // what is left of the guess: nothing moves
            if (not searches_ and iteration > 2 and not(S(2) * largest < farthest)) return false;
            farthest = largest;
            previous = size;
        }
        if (exact) refuse(x, singular ? newton_outcome::singular : newton_outcome::lost, e_.residual);
        return false;
    }
    [[nodiscard]] bool is_near_the_last(int iteration, long long made) const {
        if (iteration < 2 or made < 2) return is_near(iteration, made, S(0), S(0), S(0));
        auto const change = [](unknown const& y, unknown const& before) {
            S most(0);
            for (int c = 0; c < u::dimension(y); ++c)
                if (S const size = magnitude(S(u::component(y, c) - u::component(before, c))); most < size) most = size;
            return most;
        };
        return is_near(iteration, made, change(e_.moved, past_[0]), change(past_[0], past_[1]), change(past_[1], past_[2]));
    }
    void weigh(state<S, V> const& x, matrix& factorized) {
        weighed_.weigh(
            e_.moved, [&](vector& sizes) { e_.put_sizes(x, sizes); }, factorized);
    }
    /// Whether corrections have stopped shrinking at the rounding of a position.
    [[nodiscard]] bool is_rounding_of(state<S, V> const& x, S const& size, S const& previous) const {
        return previous > S(0) and not(size < previous) and magnitude(correction_) <= S(16) * epsilon<S>() * magnitude(x.q);
    }
    /// If masses grow without bound, as near the speed of light, corrections are small: they prove nothing beside a large residual.
    [[nodiscard]] bool is_elsewhere(state<S, V> const& x) const {
        return not e_.has_constant_mass and not std::numeric_limits<S>::is_exact and
               magnitude(x.p) + e_.impulses() < S(e_.residual.cwiseAbs().maxCoeff());
    }
    static S small_correction() { return square_root_of_epsilon<S>() / S(Compensated ? 1024 : 4); }
    void correct(matrix& K) {
        K.solve(e_.residual, correction_);
        corrected_ = corrected::in_all;
        for (int c = 0; c < e_.unknowns(); ++c) u::component(e_.moved, c) = u::component(e_.moved, c) - correction_(c);
    }
    void refuse_nan(state<S, V> const& x) {
        for (int k = 0; k < e_.unknowns(); ++k)
            if (not is_finite(e_.residual(k))) throw_newton_failure(name, newton_outcome::not_finite, x.q, with_first(x.q, e_.residual(k)));
    }
    template <class Residual>
    [[noreturn]] void refuse(state<S, V> const& x, newton_outcome how, Residual const& residual) {
        V rest = s::zero(dimension());
        for (int c = 0; c < dimension(); ++c) s::component(rest, c) = component_of(residual, c * (Controls - 1));
        throw_newton_failure(name, how, V(x.q + e_.end()), rest);
    }
    /// For an L with branches, or if full corrections do not contract: sets e_.moved and the derivatives there.
    [[gnu::noinline, gnu::cold]] void search(given_problem<V> const& problem, state<S, V> const& x, bool has_branches, long long made) {
        shortened_step<equation> step(e_);
        std::optional<matrix> K;
        S largest(0);
        auto const evaluate_at = [&](unknown const& y, unknown& r) {
            e_.moved = y * step.share();
            (void)e_.evaluate(problem, x, wanted::with_seconds);
            e_.put_residual(x);
            for (int c = 0; c < e_.unknowns(); ++c) u::component(r, c) = e_.residual(c);
            S const reach = magnitude(x.q) + magnitude(e_.moved);
            return S(magnitude(x.p) + e_.forces() + S(e_.unknowns()) * (e_.bends() * reach + largest * magnitude(e_.moved)));
        };
        auto const linearize = [&] {
            e_.put_matrix(true);
            largest = e_.full_matrix.largest();
            K.emplace(e_.full_matrix); // other branches may have another pattern
            return K->factorize();
        };
        auto const correct = [&](unknown const& r, unknown& d) {
            for (int c = 0; c < e_.unknowns(); ++c) correction_(c) = u::component(r, c);
            K->solve(correction_);
            for (int c = 0; c < e_.unknowns(); ++c) u::component(d, c) = -correction_(c) / step.share();
        };
        first_guess(made);
        unknown y = e_.moved, rest = y;
        first_guess(made > 0 ? 1 : 0);
        unknown const last = e_.moved;
        newton_outcome const how = root_of_step<unknown>(has_branches, {evaluate_at, linearize, correct}, y, last, rest,
                                                         [&](S const& share) { step.shorten_to(share); });
        if (how != newton_outcome::found) {
            e_.moved = y;
            refuse(x, how, rest);
        }
        correction_.setZero();
        corrected_ = corrected::in_nothing;
    }

    equation e_;
    long long steps_ = 0; ///< with this step length
    int guessed_ = 0;
    bool iterates_ = true, searches_ = true, stiff_ = false;
    corrected corrected_ = corrected::in_nothing;
    V velocity_; ///< guess without steps of this length
    past_steps<unknown, S, 8> past_;
    vector correction_;
    weighed_corrections<unknown, S, vector> weighed_;
    [[no_unique_address]] state_sums<Compensated, S, V> sums_;
};

} // namespace hilger::detail
