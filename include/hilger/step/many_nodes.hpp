// SPDX-License-Identifier: BSL-1.0
// The step of any embedding in any dimension: its equation (step/equation.hpp) solved for U_m - q_i - of control values themselves, which
// differ little from q_i in a short step, velocities would have the rounding divided by h.
//
// What the formula of L is made of decides how. Where no entry of the equation's matrix ever changes, it is factorized once, one correction
// solves the equation, and what does not enter it is evaluated at its solution only: explicit schemes are that case. Where the masses are
// constant they are solved with alone, as long as that converges fast. What is left is Newton's method.
#pragma once

#include <functional>
#include <limits>
#include <utility>

#include "hilger/newton/on_branches.hpp"
#include "hilger/newton/stop.hpp"
#include "hilger/newton/weighed_corrections.hpp"
#include "hilger/step/equation.hpp"
#include "hilger/step/explicit_node.hpp"
#include "hilger/step/past_steps.hpp"
#include "hilger/step/summation.hpp"

namespace hilger::detail {

template <class Problem, bool Compensated, class S, class V, class Extra = no_step_force, int Controls = 2>
class many_nodes {
    using s = shape<V>;
    using equation = step_equation<Problem, S, V, Extra, Controls>;
    using unknown = typename equation::unknown;
    using u = shape<unknown>;
    using matrix = typename equation::matrix;
    using vector = typename equation::vector;
    using derivatives = typename equation::derivatives;
    static constexpr bool may_be_explicit =
        Controls == 2 and not has_step_force<Extra> and not has_force<Problem> and is_traced_at<Problem, V>;

public:
    many_nodes(tableau<S> const& t, S const& h, V const& like, Extra extra = {})
        : e_(like, std::move(extra)), velocity_(zero_like(like)), past_(e_.moved), correction_(vector::Zero(e_.unknowns())),
          weighed_(correction_), explicit_(like), sum_q_(s::dimension(like)), sum_p_(s::dimension(like)) {
        prepare(t, h);
    }
    void prepare(tableau<S> const& t, S const& h) {
        if (steps_ > 0) velocity_ = e_.end() / e_.h();
        e_.prepare(t, h);
        if constexpr (may_be_explicit) explicit_.prepare(t, e_.adds_up);
        steps_ = 0;
        stiff_ = false;
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
        sum_q_.visit(each);
        sum_p_.visit(each);
    }

    void advance(Problem const& problem, state<S, V>& x) {
        solve(problem, x);
        finish(x);
    }
    /// The equation solved: q_{i+1} - q_i is moved(), and p_{i+1} - p_i is gained() unless constants move (embeddings that do not reproduce
    /// them). The state is as it was; advance makes the step.
    void solve(Problem const& problem, state<S, V> const& x) {
        if constexpr (may_be_explicit)
            if (explicit_.steps(problem, x, e_.moved, e_.increment)) {
                ++steps_;
                return;
            }
        branch_watch const watch;
        if (not e_.is_prepared) {
            unknown const last = e_.moved;
            e_.move_with(velocity_);
            e_.evaluate(problem, x, wanted::first_order);
            e_.moved = last;
            watch.forget(); // it is no part of the step
        }
        first_guess();
        long long const made = std::exchange(steps_, 0); // what a step that fails was led to is no guess for another one
        bool const was_constant = e_.is_constant;
        bool const by_newton = not e_.is_constant and (stiff_ or not e_.has_constant_mass);
        try {
            if (not by_newton) e_.evaluate(problem, x, wanted::first_order);
            if (watch.saw_any())
                search(problem, x);
            else if (by_newton)
                newton(problem, x, watch);
            else if (not iterate(problem, x, watch)) {
                stiff_ = e_.has_constant_mass;
                steps_ = made;
                first_guess();
                steps_ = 0;
                newton(problem, x, watch);
            }
        } catch (error::not_finite const&) {
            if (made < 2 or was_constant) throw;
            e_.moved = past_[0]; // an extrapolated guess may lie where L is not defined
            search(problem, x);
        }
        e_.gather(problem, x, correction_, is_corrected_);
        if (not e_.is_constant) past_.keep(e_.moved);
        steps_ = was_constant and not e_.is_constant ? 1 : made + 1; // increments that may be anything were not kept
    }
    [[nodiscard]] decltype(auto) moved() const { return e_.end(); }
    [[nodiscard]] auto const& gained() const { return e_.increment; }
    /// What is known of steps before the next one is forgotten, but for a velocity to guess with.
    void restart(V const& v) {
        steps_ = 0;
        guess(v);
    }

    static constexpr char const* name = "the step p = -d_1 L_h(q, y)";

private:
    [[nodiscard]] int dimension() const { return e_.dimension(); }
    static V value_of_nan(V x, S const& bad) {
        s::component(x, 0) = bad;
        return x;
    }
    /// By the polynomial through the last increments, as far as there are some of this step's length.
    void first_guess() {
        if (steps_ == 0)
            e_.move_with(velocity_);
        else if (not e_.is_constant) // else any will do
            past_.guess(e_.moved, steps_);
    }
    /// With what of the matrix never changes: one correction where that is all of it, else a gradient and a correction a round, each
    /// smaller by a factor of the size h^2 |M^-1 U''|. False where that is not much less than one.
    bool iterate(Problem const& problem, state<S, V> const& x, branch_watch const& watch) {
        S previous(-1);
        for (int round = 0; round < most_iterations<S>; ++round) {
            if (round > 0) e_.evaluate(problem, x, wanted::first_order);
            if (watch.saw_any()) {
                search(problem, x);
                return true;
            }
            e_.put_residual(x);
            refuse_nan(x, previous);
            if (not e_.factorize_constant_part()) {
                if (e_.is_constant) refuse(x, true, S(0));
                return false;
            }
            correct(e_.constant_part);
            tally<S>::add(work::newton_round);
            if (e_.is_constant) return true;
            if (round == 0) weigh(x, e_.constant_part);
            S const size = weighed_.size_of(correction_), floor = epsilon<S>();
            // What is left is the rate times this correction, and the rate is the ratio of two corrections.
            if (size <= floor * S(8) or (round > 8 and size <= floor * S(64)) or
                (previous > S(0) and size * (size / previous) <= floor * S(Compensated ? 1 : 128) / S(256)) or
                is_rounding_of(x, size, previous)) {
                is_corrected_ = false; // it is of the size of the rounding in the gradients
                correction_.setZero();
                return true;
            }
            if (previous > S(0) and not(S(4) * size < previous) and S(1024) * floor < size) return false;
            previous = size;
        }
        return false;
    }
    void newton(Problem const& problem, state<S, V> const& x, branch_watch const& watch) {
        bool singular = false;
        S size(0), previous(-1);
        S const small = small_correction();
        for (int iteration = 0; iteration < most_iterations<S>; ++iteration) {
            e_.evaluate(problem, x, wanted::with_seconds);
            if (watch.saw_any()) return search(problem, x);
            e_.put_residual(x);
            refuse_nan(x, size);
            e_.put_matrix();
            singular = not e_.full_matrix.factorize();
            if (singular) break;
            correct(e_.full_matrix);
            tally<S>::add(work::newton_round);
            if (iteration == 0 or std::numeric_limits<S>::is_exact) weigh(x, e_.full_matrix);
            size = weighed_.size_of(correction_);
            if (weighed_.is_last(correction_, e_.moved, small) or (iteration > 0 and e_.is_rounding(x)) or
                is_rounding_of(x, size, previous))
                return;
            previous = size;
        }
        refuse(x, singular, magnitude(correction_));
    }
    void weigh(state<S, V> const& x, matrix& factorized) {
        weighed_.weigh(
            e_.moved, [&](vector& sizes) { e_.put_sizes(x, sizes); }, factorized);
    }
    /// Whether corrections do not shrink any more, and are what the rounding of a position does to the force.
    [[nodiscard]] bool is_rounding_of(state<S, V> const& x, S const& size, S const& previous) const {
        return previous > S(0) and not(size < previous) and magnitude(correction_) <= S(16) * epsilon<S>() * magnitude(x.q);
    }
    static S small_correction() { return square_root_of_epsilon<S>() / S(Compensated ? 1024 : 4); }
    void correct(matrix& K) {
        correction_ = e_.residual;
        K.solve(correction_);
        is_corrected_ = true;
        for (int c = 0; c < e_.unknowns(); ++c) u::component(e_.moved, c) = u::component(e_.moved, c) - correction_(c);
    }
    void refuse_nan(state<S, V> const& x, S const& size) {
        if (is_finite(e_.residual)) return;
        for (int k = 0; k < e_.unknowns(); ++k)
            if (not is_finite(e_.residual(k))) give_up(name, false, x.q, value_of_nan(x.q, e_.residual(k)), size);
    }
    [[noreturn]] void refuse(state<S, V> const& x, bool singular, S const& size) {
        V rest = s::zero(dimension());
        for (int c = 0; c < dimension(); ++c) s::component(rest, c) = e_.residual(c * (Controls - 1));
        give_up(name, singular, V(x.q + e_.end()), rest, size);
    }
    /// The same for an L with branches: e_.moved and the derivatives there.
    void search(Problem const& problem, state<S, V> const& x) {
        auto const evaluate_at = [&](unknown const& y, unknown& r) {
            e_.moved = y;
            e_.evaluate(problem, x, wanted::with_seconds);
            e_.put_residual(x);
            e_.put_matrix();
            for (int c = 0; c < e_.unknowns(); ++c) u::component(r, c) = e_.residual(c);
            S const reach = magnitude(x.q) + magnitude(y);
            return S(magnitude(x.p) + e_.forces() + S(e_.unknowns()) * (e_.bends() * reach + e_.full_matrix.largest() * magnitude(y)));
        };
        auto const correct = [&](unknown const& r, unknown& d) {
            tally<S>::add(work::newton_round);
            if (not e_.full_matrix.factorize()) return false;
            for (int c = 0; c < e_.unknowns(); ++c) correction_(c) = u::component(r, c);
            e_.full_matrix.solve(correction_);
            for (int c = 0; c < e_.unknowns(); ++c) u::component(d, c) = -correction_(c);
            return true;
        };
        unknown rest = e_.moved, y = e_.moved;
        branch_search const how = search_branches(y, rest, std::cref(evaluate_at), std::cref(correct), small_correction());
        if (how != branch_search::found) {
            e_.moved = y;
            V first = s::zero(dimension());
            for (int c = 0; c < dimension(); ++c) s::component(first, c) = u::component(rest, c * (Controls - 1));
            give_up_on_branches(name, how, V(x.q + e_.end()), first);
        }
        correction_.setZero();
        is_corrected_ = false;
    }
    /// The step, once its equation is solved. @throws error::not_finite, and x is as it was
    void finish(state<S, V>& x) {
        // infinity less itself is NaN, and so is the sum; where the sum alone overflows it is looked at again
        if (not is_finite(S(all_moved(x) + (e_.adds_up ? total(x.p, e_.increment) : total(e_.whole, e_.whole))))) [[unlikely]]
            refuse_overflow(x);
        if constexpr (not Compensated and not s::is_scalar and Controls == 2)
            x.q += e_.moved;
        else
            for (int c = 0; c < dimension(); ++c) sum_q_.add(s::component(x.q, c), e_.end(c), c);
        if (not e_.adds_up)
            for (int c = 0; c < dimension(); ++c) s::component(x.p, c) = e_.whole(c);
        else if constexpr (not Compensated and not s::is_scalar)
            x.p += e_.increment;
        else
            for (int c = 0; c < dimension(); ++c) sum_p_.add(s::component(x.p, c), e_.increment(c), c);
        x.t = x.t + e_.h();
    }

    /// The sum of all positions after the step.
    [[nodiscard]] S all_moved(state<S, V> const& x) const {
        if constexpr (Controls == 2)
            return total(x.q, e_.moved);
        else
            return total(x.q, x.q) + e_.moved.sum();
    }
    /// @throws error::not_finite, unless it was the sum alone that overflowed
    [[gnu::noinline, gnu::cold]] void refuse_overflow(state<S, V> const& x) {
        for (int c = 0; c < dimension(); ++c) {
            S const q = s::component(x.q, c) + e_.end(c), p = e_.adds_up ? S(s::component(x.p, c) + e_.increment(c)) : S(e_.whole(c));
            if (not is_finite(q) or not is_finite(p)) give_up(name, false, x.q, value_of_nan(x.q, S((q - q) + (p - p))), S(0));
        }
    }
    /// The sum of all components of x and y, of which one may be a number and the other a vector of one.
    template <class X, class Y>
    static S total(X const& x, Y const& y) {
        if constexpr (has_components<X> and has_components<Y>) {
            // numbers that were just written one by one are not read as vectors, which would wait for them
            S sum(0);
            if constexpr (s::size != Eigen::Dynamic)
                for (int c = 0; c < s::size; ++c) sum = sum + (x(c) + y(c));
            else
                sum = (x + y).sum();
            return sum;
        } else
            return S(component_of(x, 0) + component_of(y, 0));
    }

    equation e_;
    long long steps_ = 0; ///< of this length
    int guessed_ = 0;
    bool stiff_ = false, is_corrected_ = false;
    V velocity_; ///< to start from where there are no steps of this length
    past_steps<unknown, S, 8> past_;
    vector correction_;
    weighed_corrections<unknown, S, vector> weighed_;
    [[no_unique_address]] std::conditional_t<may_be_explicit, explicit_node<Problem, S, V>, no_explicit_node> explicit_;
    [[no_unique_address]] summation<Compensated, S, s::size> sum_q_;
    [[no_unique_address]] summation<Compensated, S, s::size> sum_p_;
};

} // namespace hilger::detail
