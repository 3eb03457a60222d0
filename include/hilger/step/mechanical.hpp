// SPDX-License-Identifier: BSL-1.0
// The step of a one-node embedding for L = v.Mv / 2 - U(q) of any size (models/mechanical.hpp) by forces alone: the velocity v at the node
// solves M v = p - a_0 h U'(q + a_1 h v). If the node is an end of the step, one force determines it. Otherwise it is iterated: each round
// costs one gradient and gains a factor h^2 |M^-1 U''| / 4. If that is too slow, the equation of the step is solved (step/many_nodes.hpp).
#pragma once

#include <optional>

#include "hilger/newton/past_steps.hpp"
#include "hilger/newton/stop.hpp"
#include "hilger/step/force.hpp"
#include "hilger/step/many_nodes.hpp"
#include "hilger/step/summation.hpp"

namespace hilger::detail {

/// State that one trajectory keeps from step to step.
template <class L, embedding_facts Facts, bool Compensated, class S, class V, class Extra = no_step_force>
class mechanical_step {
    using s = shape<V>;
    using problem_type = problem<L, no_force>;
    static constexpr bool resisted = has_step_force<Extra>, at_an_end = Facts.at_start or Facts.at_end;
    /// The mass, with the slope of the extra force added to its diagonal.
    static decltype(auto) inertia(L const& l, tableau<S> const& t, S const& h, Extra const& extra) {
        if constexpr (resisted) {
            V const more = extra.slope * S(h / S(2) * t.w(0));
            if constexpr (L::is_matrix) {
                block_of<V> m = l.mass().template cast<S>();
                if (m.rows() == more.size() and m.cols() == more.size()) m.diagonal() += more;
                return m;
            } else if constexpr (requires { l.mass().size(); })
                return l.mass().size() == more.size() ? V(l.mass().template cast<S>() + more) : V(l.mass().template cast<S>());
            else
                return V(more.array() + S(l.mass()));
        } else
            return l.mass();
    }
    using Mass = std::remove_cvref_t<decltype(inertia(std::declval<L const&>(), std::declval<tableau<S> const&>(), std::declval<S const&>(),
                                                      std::declval<Extra const&>()))>;
    static constexpr int history = at_an_end ? 1 : 8;

public:
    mechanical_step(tableau<S> const& t, S const& h, L const& l, V const& like, Extra extra = {})
        : extra_(std::move(extra)), mass_(inertia(l, t, h, extra_), like.size()), v_(like), g_(like), next_(like), room_(like.size() + 1),
          past_(like), sums_(s::dimension(like)) {
        l.potential().check(like.size());
        prepare(t, h);
    }
    void prepare(tableau<S> const& t, S const& h) {
        table_ = t;
        h_ = h;
        w_ = t.w(0);
        c_ = w_ * t.a(0, 1);
        f_ = w_ * t.a(0, 0);
        add_up_to(w_, c_, f_);
        if (known_ > 1) known_ = 0;
        if (equation_) equation_->prepare(t, h);
    }
    [[nodiscard]] S const& h() const { return h_; }
    [[nodiscard]] Extra& extra() { return extra_; }

    /// Everything that later steps depend on and h does not determine, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        int by_equation = by_equation_ ? 1 : 0, made = equation_ ? 1 : 0;
        each("known", known_);
        iteration_.visit(each);
        each("by_equation", by_equation);
        each("equation", made);
        by_equation_ = by_equation != 0;
        past_.visit("velocity", each);
        if (made != 0) equation(v_).visit(each);
        sums_.visit(each);
    }

    /// @throws error::no_convergence, error::no_branch, error::singular, error::not_finite; `x` is then as it was.
    void advance(problem_type const& what, state<S, V>& x) {
        auto const& U = what.lagrangian.potential();
        if constexpr (resisted) start_ = x.p + S(h_ / S(2)) * extra_.constant;
        if constexpr (Facts.at_start) {
            force(U, x.q);
            mass_.solve(start(x) - w_ * g_, v_);
        } else if constexpr (Facts.at_end) {
            mass_.solve(start(x), v_);
            next_ = x.q + c_ * v_;
            force(U, next_);
        } else {
            first_guess(x);
            if (not by_forces(U, x)) return advance_by_equation(what, x);
        }
        by_equation_ = false;
        if constexpr (resisted)
            sums_.add(x, h_, w_ * v_, S(-w_) * g_ - (S(w_ * h_) * extra_.slope.cwiseProduct(v_) - h_ * extra_.constant), name);
        else
            sums_.add(x, h_, w_ * v_, S(-w_) * g_, name);
        remember();
    }

private:
    static constexpr char const* name = "the step p = -d_1 L_h(q, y)";
    using equation_type = many_nodes<Compensated, S, V, Extra>;

    equation_type& equation(V const& like) {
        if (not equation_) {
            equation_.emplace(table_, h_, like, extra_);
            equation_->do_not_iterate(); // the iteration has just failed
        }
        return *equation_;
    }
    void advance_by_equation(problem_type const& what, state<S, V>& x) {
        auto& of_step = equation(x.q);
        of_step.extra() = extra_;
        if (not std::exchange(by_equation_, false)) of_step.restart(v_);
        of_step.solve(given<problem_type, V>(what), x);
        sums_.add(x, h_, of_step.moved(), of_step.gained(), name);
        by_equation_ = true;
        v_ = of_step.moved() / w_;
        remember();
    }
    void remember() {
        if constexpr (history > 1) {
            past_.keep(v_);
            if (known_ < history) ++known_;
        }
    }
    /// The momentum at the start plus the velocity-independent part of the extra force.
    [[nodiscard]] V const& start(state<S, V> const& x) const {
        if constexpr (resisted)
            return start_;
        else
            return x.p;
    }
    template <class U>
    void force(U const& potential, V const& q) {
        potential.gradient(q, g_, room_);
    }
    void first_guess(state<S, V> const& x) {
        if (known_ > 0)
            past_.guess(v_, known_);
        else
            mass_.solve(start(x), v_);
    }
    /// An iteration is never exact.
    template <class U>
    bool by_forces(U const& potential, state<S, V> const& x) {
        if (std::numeric_limits<S>::is_exact) return false;
        if (not iteration_.allows()) {
            iteration_.passes();
            return false;
        }
        bool const done = iterate(potential, x);
        if (done)
            iteration_.has_worked();
        else {
            iteration_.has_failed();
            first_guess(x);
        }
        return done;
    }
    /// @returns false if it converges too slowly, or U has branches
    template <class U>
    bool iterate(U const& potential, state<S, V> const& x) {
        contraction<S> convergence(epsilon<S>() * magnitude(v_), small());
        branch_watch const watch;
        for (int round = 0; round < most_iterations<S>; ++round) {
            next_ = x.q + c_ * v_;
            force(potential, next_);
            if (watch.saw_any()) return false; // the rate on one branch says nothing about another one
            mass_.solve(start(x) - f_ * g_, next_);
            S const size = (next_ - v_).cwiseAbs().maxCoeff();
            std::swap(next_, v_);
            progress const end = convergence.after(size);
            bool const is_rounding = magnitude(w_) * size <= S(64) * epsilon<S>() * magnitude(x.q);
            if (end == progress::done or (end == progress::lost and is_rounding)) return true;
            if (end == progress::lost) return false;
        }
        return false;
    }
    static S small() { return Compensated ? S(1) / S(256) : S(1) / S(2); }

    [[no_unique_address]] Extra extra_;
    [[no_unique_address]] std::conditional_t<resisted, V, no_step_force> start_;
    tableau<S> table_;
    S h_, w_, c_, f_;
    mass_solver<Mass, V> mass_;
    back_off iteration_;
    bool by_equation_ = false; ///< in the last step
    V v_, g_, next_;           ///< the velocity at the node, U' there, workspace
    Eigen::Matrix<S, Eigen::Dynamic, 1> room_;
    past_steps<V, S, history> past_;
    int known_ = 0;
    std::optional<equation_type> equation_; ///< made when first needed
    [[no_unique_address]] state_sums<Compensated, S, V> sums_;
};

} // namespace hilger::detail
