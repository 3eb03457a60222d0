// SPDX-License-Identifier: BSL-1.0
// The flow of a Lagrangian with fractional damping under an embedding. Each step is one of the undamped flow; the reading of the damping
// defines what the history adds before and after it, and to its equation: a mean over the step (with_fractional_damping,
// fractional/mean.hpp) or impulses at the points (with_fractional_impulses, fractional/impulses.hpp).
// At the nodes of galerkin<s, radau> it is the force there (fractional/stages.hpp), on any T; the others take steps of one length.
//   auto const flow = embed(with_fractional_damping(L, rho, fraction<1, 2>{}), mid_point);
//   for (auto const& x : flow.along(uniform(0.0, h, N), q0, p0)) ...
// A step depends on all steps before it: there is no single step, no adjoint, and no composition.
#pragma once

#include "hilger/fractional/impulses.hpp"
#include "hilger/fractional/mean.hpp"
#include "hilger/fractional/stages.hpp"
#include "hilger/integrator/flow.hpp"

namespace hilger {

namespace detail {
template <class Reading>
inline constexpr bool takes_any_steps = requires {
    requires Reading::any_steps;
};
} // namespace detail

/// A flow with a reading of fractional damping; see embed().
template <class Flow, class Reading>
class damped_flow : public stepping<damped_flow<Flow, Reading>> {
public:
    using problem_type = typename Flow::problem_type;

    damped_flow(Flow undamped, Reading damping) : undamped_(std::move(undamped)), damping_(std::move(damping)) {}

    /// Each step depends on all steps before it.
    static constexpr bool has_history = true;

    /// The memory of the undamped flow, and the history.
    template <class S, class V>
    class memory {
        using history = typename Reading::template history<S, V>;
        using undamped = typename Flow::template stepper<S, V, typename history::extra>;

    public:
        memory(damped_flow const& f, S const& h, V const& like)
            : history_(f.damping_, h, like), step_(f.undamped_, h, like, history_.extra_force(like)), h_(h), before_{S(0), like, like} {}

        /// The velocity that the first step begins with: Newton's method starts there, and a history may ask for it.
        void start_with(damped_flow const& f, state<S, V> const& x, V const& v) {
            start_ = v;
            step_.start_with(f.undamped_, x, v);
        }
        /// Advances x by one step h. @throws error::mismatch when h is not the step of the history; error::no_convergence, error::singular,
        /// error::not_finite; in the first step also the errors of the damping. x is unchanged then.
        void advance(damped_flow const& f, state<S, V>& x, S const& h) {
            begin(f, x, h);
            move(f, x);
        }
        void begin(damped_flow const& f, state<S, V> const& x, S const& h) {
            if constexpr (detail::takes_any_steps<Reading>)
                h_ = h;
            else if (not(h == h_))
                error::raise<error::mismatch>("fractional damping remembers steps of one length, ", h_, ", and this step has ", h);
            if (begun_) return;
            V v0 = zero_like(x.q);
            if (history_.needs_velocity())
                v0 = start_ ? *start_ : velocity_of(detail::at_time{f.undamped_.mechanics().lagrangian, x.t}, x.q, x.p);
            history_.begin(x, v0);
            begun_ = true;
        }
        /// @throws the same as a step_failure
        void advance_equally(damped_flow const& f, state<S, V>& x) {
            saying_where(x, h_, [&] { move(f, x); });
        }
        /// The control value m inside the last step, less q_i.
        [[nodiscard]] V inside(int m) const { return step_.inside(m); }
        /// Everything that later steps depend on, for checkpoints.
        template <class Visit>
        void visit(damped_flow const& f, Visit& each) {
            each("begun", begun_);
            history_.visit(each);
            step_.visit(f.undamped_, each);
        }
        /// The force of the damping, -rho D^beta q, at the point reached last, or with `back` at the one before.
        [[nodiscard]] V damping_force(bool back = false) const {
            V force = zero_like(before_.q);
            history_.add_force(force, back);
            return force;
        }

    private:
        /// Restores x after a failure.
        struct undo {
            state<S, V>& x;
            state<S, V> const& before;
            bool done = false;
            ~undo() {
                if (not done) x = before;
            }
        };
        /// In place: a copy would wait until its parts, just written, can be read as a whole.
        void move(damped_flow const& f, state<S, V>& x) {
            before_ = x;
            undo guard{x, before_};
            history_.before_step(x, step_.extra(), h_);
            step_.advance(f.undamped_, x, h_);
            history_.after_step(x, step_.extra());
            guard.done = true;
        }
        history history_;
        undamped step_;
        S h_;
        state<S, V> before_;
        std::optional<V> start_; ///< the first velocity, where it is given
        bool begun_ = false;
    };

    /// Only on scales with equal steps, unless the reading takes any.
    /// @throws error::not_finite, error::mismatch when rho is a vector of another dimension than q0; during iteration, a step_failure.
    template <time_scale_like Scale, class V>
    auto start(Scale const& T, V q0, V p0) const {
        damping_.require_dimension(q0);
        if constexpr (detail::takes_any_steps<Reading>)
            return damped_flow(undamped_, damping_.on(T)).stepping<damped_flow>::start(T, std::move(q0), std::move(p0));
        else {
            detail::require_equal_steps<Scale>();
            return stepping<damped_flow>::start(T, std::move(q0), std::move(p0));
        }
    }
    /// Refused: one step has no history.
    template <class S, class V>
    auto step(state<S, V> const&, S const&) const {
        return detail::no_single_step<S>();
    }
    /// p = dL/dv(t, q, v)
    template <class S, class V>
    [[nodiscard]] V momentum(S const& t, V const& q, V const& v) const {
        return undamped_.momentum(t, q, v);
    }
    /// The Lagrangian, its forces and the damping.
    [[nodiscard]] auto mechanics() const {
        return damped_problem<std::remove_cvref_t<decltype(undamped_.mechanics())>, Reading>{undamped_.mechanics(), damping_};
    }
    /// The flow without damping.
    [[nodiscard]] Flow const& undamped() const { return undamped_; }
    [[nodiscard]] auto const& embedding() const { return undamped_.embedding(); }
    [[nodiscard]] Reading const& damping() const { return damping_; }

private:
    Flow undamped_;
    Reading damping_;
};

namespace detail {
/// How an embedding reads a damping: as it is, or at the nodes of Radau's quadrature.
template <class E, class Reading>
Reading const& reading_for(E const&, Reading const& reading) {
    return reading;
}
template <int Degree, int Count, bool Checked, class Damping>
at_stages<Damping, Count>
reading_for(embedding<polynomial_value<Degree, radau, Count>, polynomial_slope<Degree, radau, Count>, step_weight, Checked> const&,
            mean_over_step<Damping> const& reading) {
    static_assert(std::same_as<typename Damping::generating, grunwald_letnikov> and std::same_as<decltype(Damping::policy), exponentials>,
                  "at Radau's nodes a fractional damping is a power of Delta, with a history exponentials{tolerance}");
    return {reading.dampings};
}
} // namespace detail

/// The flow of a Lagrangian with damping under an embedding, embed(damped, mid_point). Sums are compensated where the damping is a mean
/// over each step, unless by its type no order is above 1: near 2 the rounding of positions enters the force with h^-2.
template <class L, class Reading, class E>
auto embed(damped_problem<L, Reading> const& damped, E const& how, std::integral_constant<sums, sums::compensated> compensation) {
    return damped_flow(embed(damped.mechanics, how, compensation), detail::reading_for(how, damped.damping));
}
template <class L, class Reading, class E>
auto embed(damped_problem<L, Reading> const& damped, E const& how, std::integral_constant<sums, sums::plain>) {
    return damped_flow(embed(damped.mechanics, how), detail::reading_for(how, damped.damping));
}
template <class L, class Reading, class E>
auto embed(damped_problem<L, Reading> const& damped, E const& how) {
    constexpr bool needs_compensation = requires { requires Reading::needs_compensation; };
    constexpr sums which = needs_compensation ? sums::compensated : sums::plain;
    return embed(damped, how, std::integral_constant<sums, which>{});
}

/// Graded as the damping at the stages of this flow asks for: graded(0.0, 1.0, 24, flow). @throws error::invalid_scale
template <ordered_scalar S, class Flow, class Damping, int Stages>
time_scale<S> graded(S const& a, S const& b, index_type N, damped_flow<Flow, at_stages<Damping, Stages>> const& flow) {
    return graded(a, b, N, flow.damping().template grading<S>());
}
template <ordered_scalar S, class Flow, class Damping, int Stages>
time_scale<S> graded_start(S const& a, S const& b, std::type_identity_t<S> const& h,
                           damped_flow<Flow, at_stages<Damping, Stages>> const& flow) {
    return graded_start(a, b, h, flow.damping().template grading<S>());
}

} // namespace hilger
