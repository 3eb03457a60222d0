// SPDX-License-Identifier: BSL-1.0
// The step of any embedding without control values inside the step, given by its tableau: q_{i+1} = y with
//   p_i + sum_k w_k (a_k0 dL/dq + b_k0 dL/dv)(A_k, B_k) = 0,   A_k = a_k0 q_i + a_k1 y,   B_k = b_k0 q_i + b_k1 y,
// which is p_i = -d_1 L_h, and then p_{i+1} = d_2 L_h = sum_k w_k (a_k1 dL/dq + b_k1 dL/dv). Solved by Newton with dense factorizations,
// for y - q_i: of y itself, which differs little from q_i in a short step, a velocity would have the rounding divided by h.
#pragma once

#include <optional>
#include <utility>

#include <Eigen/LU>

#include "hilger/integrator/state.hpp"
#include "hilger/integrator/step_force.hpp"
#include "hilger/integrator/summation.hpp"
#include "hilger/integrator/tableau.hpp"
#include "hilger/mechanics/branch_newton.hpp"
#include "hilger/mechanics/newton_stop.hpp"
#include "hilger/mechanics/problem.hpp"

namespace hilger::detail {

template <class Problem, bool Compensated, class S, class V, class Extra = no_step_force>
class many_nodes {
    using s = shape<V>;
    using vector = Eigen::Matrix<S, s::size, 1>;
    using matrix = Eigen::Matrix<S, s::size, s::size>;

public:
    many_nodes(tableau<S> const& t, S const& h, V const& like, Extra extra = {})
        : extra_(std::move(extra)), d_(s::dimension(like)), moved_(s::zero(d_)), r_(vector::Zero(d_)), correction_(r_),
          J_(matrix::Zero(d_, d_)), lu_(d_), sum_q_(d_), sum_p_(d_) {
        prepare(t, h);
    }
    void prepare(tableau<S> const& t, S const& h) {
        t_ = t;
        h_ = h;
        steps_ = 0;
        constants_ = reproduces_constants();
        nodes_.assign(
            static_cast<std::size_t>(t.nodes),
            node_table<V>{{s::zero(d_), s::zero(d_), s::zero_block(d_), s::zero_block(d_), s::zero_block(d_), {}}, s::zero_block(d_)});
    }
    [[nodiscard]] S const& h() const { return h_; }
    void guess(V const& v) { velocity_ = v; }
    [[nodiscard]] bool needs_guess() const { return not velocity_; }
    [[nodiscard]] Extra& extra() { return extra_; }
    /// Everything that later steps depend on and h does not determine, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        each("steps", steps_);
        int known = velocity_ ? 1 : 0;
        each("known", known);
        if (known == 0) velocity_.reset();
        if (known != 0 and not velocity_) velocity_ = s::zero(d_);
        for (int c = 0; velocity_ and c < d_; ++c) each("velocity", s::component(*velocity_, c));
        for (int c = 0; c < d_; ++c) each("increment", s::component(moved_, c));
        sum_q_.visit(each);
        sum_p_.visit(each);
    }

    void advance(Problem const& problem, state<S, V>& x) {
        // As far as the last step went, or along the velocity where there is none.
        if (steps_ == 0) moved_ = *velocity_ * h_;
        long long const made = std::exchange(steps_, 0); // what a step that fails was led to is no guess for another one
        bool singular = false;
        S size(0);
        S const small = square_root_of_epsilon<S>() / S(Compensated ? 1024 : 4);
        branch_watch const watch;
        for (int iteration = 0; iteration < most_iterations<S>; ++iteration) {
            assemble(problem, x);
            if (watch.saw_any()) {
                search(problem, x, small);
                finish(x);
                steps_ = made + 1;
                return;
            }
            for (work const each : {work::newton_round, work::factorization, work::solve}) tally<S>::add(each);
            for (int k = 0; k < d_; ++k)
                if (not is_finite(r_(k))) give_up(name, false, x.q, value_of_nan(x.q, r_(k)), size);
            lu_.compute(J_);
            singular = not is_regular(lu_);
            if (singular) break;
            correction_ = lu_.solve(r_);
            for (int c = 0; c < d_; ++c) s::component(moved_, c) = s::component(moved_, c) - correction_(c);
            size = magnitude(correction_);
            bool const floor = iteration > 0 and magnitude(r_) <= S(8) * epsilon<S>() * (magnitude(x.p) + forces());
            if (not(size <= small * magnitude(moved_)) and not floor) continue;
            finish(x);
            steps_ = made + 1;
            return;
        }
        V rest = s::zero(d_);
        for (int c = 0; c < d_; ++c) s::component(rest, c) = r_(c);
        give_up(name, singular, V(x.q + moved_), rest, size);
    }

private:
    static constexpr char const* name = "the step p = -d_1 L_h(q, y)";
    static constexpr std::size_t at(int j) { return static_cast<std::size_t>(j); }
    static V value_of_nan(V x, S const& bad) {
        s::component(x, 0) = bad;
        return x;
    }
    void assemble(Problem const& problem, state<S, V> const& x) {
        for (int c = 0; c < d_; ++c) r_(c) = s::component(x.p, c);
        J_.setZero();
        for (int k = 0; k < t_.nodes; ++k) {
            S const whole_a = constants_ ? S(1) : S(t_.a(k, 0) + t_.a(k, 1)), whole_b = constants_ ? S(0) : S(t_.b(k, 0) + t_.b(k, 1));
            V const A = x.q * whole_a + moved_ * t_.a(k, 1), B = x.q * whole_b + moved_ * t_.b(k, 1);
            auto& e = nodes_[at(k)];
            e = expand_at(problem, t_.time(k, x.t, h_), A, B);
            S const wa = t_.w(k) * t_.a(k, 0), wb = t_.w(k) * t_.b(k, 0);
            S const &a = t_.a(k, 1), &b = t_.b(k, 1);
            for (int c = 0; c < d_; ++c) {
                r_(c) = r_(c) + wa * s::component(e.e.by_q, c) + wb * s::component(e.e.by_v, c);
                for (int f = 0; f < d_; ++f)
                    J_(c, f) = J_(c, f) + wa * (s::entry(e.e.qq, c, f) * a + s::entry(e.e.qv, c, f) * b) +
                               wb * (s::entry(e.vq_, c, f) * a + s::entry(e.e.vv, c, f) * b);
            }
        }
        if constexpr (has_step_force<Extra>) add_half_of_extra();
    }
    /// h/2 F and its derivative into the equation.
    void add_half_of_extra() requires(has_step_force<Extra>) {
        S const half = h_ / S(2);
        for (int c = 0; c < d_; ++c) {
            r_(c) = r_(c) + half * extra_.at(s::component(moved_, c), c);
            J_(c, c) = J_(c, c) - half * s::component(extra_.slope, c);
        }
    }
    /// The same for an L with branches: moved_ and the derivatives there.
    void search(Problem const& problem, state<S, V> const& x, S const& small) {
        auto const evaluate_at = [&](V const& y, V& r) {
            moved_ = y;
            assemble(problem, x);
            for (int c = 0; c < d_; ++c) s::component(r, c) = r_(c);
            S const reach = magnitude(x.q) + magnitude(y);
            S bends(0);
            for (int k = 0; k < t_.nodes; ++k) bends = bends + magnitude(t_.w(k)) * magnitude(nodes_[at(k)].e.qq);
            return S(magnitude(x.p) + forces() + S(d_) * (bends * reach + magnitude(J_) * magnitude(y)));
        };
        auto const correct = [&](V const& r, V& d) {
            for (work const each : {work::newton_round, work::factorization, work::solve}) tally<S>::add(each);
            lu_.compute(J_);
            if (not is_regular(lu_)) return false;
            for (int c = 0; c < d_; ++c) r_(c) = s::component(r, c);
            correction_ = lu_.solve(r_);
            for (int c = 0; c < d_; ++c) s::component(d, c) = -correction_(c);
            return true;
        };
        V rest = moved_;
        V y = moved_;
        branch_search const how = search_branches(y, rest, evaluate_at, correct, small);
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
    [[nodiscard]] S forces() const {
        S sum(0);
        for (int k = 0; k < t_.nodes; ++k)
            sum = sum + magnitude(t_.w(k)) * magnitude(nodes_[at(k)].e.by_q) + magnitude(nodes_[at(k)].e.by_v);
        if constexpr (has_step_force<Extra>) sum = sum + magnitude(h_) * magnitude(extra_.constant);
        return sum;
    }
    /// The last correction is applied to the gradients to first order. As a_k0 + a_k1 = 1 and b_k0 + b_k1 = 0 the equations add up to
    /// p_{i+1} = p_i + sum_k w_k dL/dq, which rounds better than the definition; embeddings that do not reproduce constants use the latter.
    void finish(state<S, V>& x) {
        V increment = s::zero(d_), whole = s::zero(d_);
        for (int k = 0; k < t_.nodes; ++k) {
            auto const& e = nodes_[at(k)];
            for (int c = 0; c < d_; ++c) {
                S g = s::component(e.e.by_q, c), m = s::component(e.e.by_v, c);
                for (int f = 0; f < d_; ++f) {
                    S const da = t_.a(k, 1) * correction_(f), db = t_.b(k, 1) * correction_(f);
                    g = g - (s::entry(e.e.qq, c, f) * da + s::entry(e.e.qv, c, f) * db);
                    m = m - (s::entry(e.vq_, c, f) * da + s::entry(e.e.vv, c, f) * db);
                }
                s::component(increment, c) = s::component(increment, c) + t_.w(k) * g;
                s::component(whole, c) = s::component(whole, c) + t_.w(k) * (t_.a(k, 1) * g + t_.b(k, 1) * m);
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
    }

    [[no_unique_address]] Extra extra_;
    int d_;
    tableau<S> t_;
    S h_{0};
    long long steps_ = 0;
    bool constants_ = true;
    std::optional<V> velocity_;
    V moved_; ///< y - q_i: of the last step, and of this one while it is made
    std::vector<node_table<V>> nodes_;
    vector r_, correction_;
    matrix J_;
    Eigen::PartialPivLU<matrix> lu_;
    [[no_unique_address]] summation<Compensated, S, s::size> sum_q_;
    [[no_unique_address]] summation<Compensated, S, s::size> sum_p_;
};

} // namespace hilger::detail
