// SPDX-License-Identifier: BSL-1.0
// Fractional damping as a mean over each step,
//   F_{i+1/2} = - rho (theta D_{i+1} + (1 - theta) D_i),   D_i the difference of order beta at t_i,   theta = 1/2 + a,
// where the difference is centred a h before t_i: D_i = D^beta q(t_i - a h) + O(h^2), a = beta (1 - omega''(1)) / 2 for the generating
// function omega; beta / 2 for Gruenwald-Letnikov, 0 for bdf<2> and trapezoid. So F is of order two in the middle of the step. In D_{i+1}
// the newest weight times q_{i+1} is unknown: with it F is the force of step/force.hpp,
//   p_i + h F_{i+1/2} / 2 = -d_1 L_h(q_i, q_{i+1}),   p_{i+1} = d_2 L_h(q_i, q_{i+1}) + h F_{i+1/2} / 2.
// On M q'' + K q = -rho D^beta q the roots z of mid-point solve, with u = (1 - z) / (1 + z),
//   4 M u^2 + h^2 K + rho h^{2 - beta} Phi(u) = 0,   Phi = (1 + beta u) (2u / (1 + u))^beta for Gruenwald-Letnikov,
// (2u (1 + 2u) / (1 + u)^2)^beta for bdf<2>, (2u)^beta for trapezoid. On the imaginary axis the argument of Phi is between 0 and pi in
// absolute value, so that Phi / u has a real part >= 0 for Re u > 0, and no root is inside the unit circle, whatever h, rho >= 0 and
// 0 < beta < 2 are. For beta = 1 and Gruenwald-Letnikov the step is that of mid-point with the friction -rho v.
//   with_fractional_damping(L, rho, fraction<1, 2>{})                one term
//   with_fractional_damping(L, {{rho_1, beta_1}, {rho_2, beta_2}})   several, of orders known at run time
#pragma once

#include "hilger/fractional/damping.hpp"
#include "hilger/step/force.hpp"

namespace hilger {

/// One of several terms -rho D^beta q, of an order known at run time.
template <class S>
struct fractional_term {
    S coefficient, order;
};

namespace detail {

/// a for the power one of omega, (1 - omega''(1)) / 2: omega = p / q has p(1) = 0 and p'(1) = -q(1).
template <generating_function G, class S>
S lag_of() {
    auto const p = G::template numerator<S>();
    auto const q = G::template denominator<S>();
    S curvature(0), slope(0), size(0);
    for (std::size_t j = 0; j < p.size(); ++j) curvature = curvature + S(static_cast<int>(j * j)) * p[j] - S(static_cast<int>(j)) * p[j];
    for (std::size_t j = 0; j < q.size(); ++j) {
        slope = slope + S(static_cast<int>(j)) * q[j];
        size = size + q[j];
    }
    return (S(1) - (curvature + S(2) * slope) / size) / S(2);
}

/// The force of one damping along one trajectory, as a mean over each step.
template <class Damping, class S, class V>
class mean_damping {
    using on = damped_components<Damping, S, V>;
    using kept = typename on::kept;
    using s = shape<kept>;

public:
    mean_damping(Damping const& d, S const& h, V const& like)
        : on_(d, h, like), rho_(on_.coefficients(d)), now_(zero_like(rho_)), before_(now_), earlier_(now_), force_(now_),
          lag_(lag_of<typename Damping::generating, S>() * d.order.template as<S>()), theta_(S(1) / S(2) + lag_) {}
    [[nodiscard]] bool needs_velocity() const { return on_.needs_velocity(); }
    void begin(V const& q0, V const& v0) {
        if (on_.count() == 0) return;
        kept const velocity = on_.of(v0);
        kept const position = on_.of(q0);
        on_.history().begin(position, velocity);
        now_ = before_ = earlier_ = on_.history().arrive(position);
    }
    /// -dF/dq_{i+1}
    void add_slope(V& slope) const { on_.add(slope, S(theta_ * on_.history().present_weight()), rho_); }
    /// F for a step that ends where it begins, at q.
    void add_constant(V const& q, V& constant) {
        if (on_.count() == 0) return;
        kept const& ahead = on_.history().at_next(on_.of(q));
        for (int k = 0; k < on_.count(); ++k)
            s::component(force_, k) = s::component(rho_, k) * (theta_ * s::component(ahead, k) + (S(1) - theta_) * s::component(now_, k));
        on_.add(constant, S(-1), force_);
    }
    void arrive(V const& q) {
        if (on_.count() == 0) return;
        earlier_ = before_;
        before_ = now_;
        now_ = on_.history().arrive(on_.of(q));
    }
    /// Everything that later forces depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        on_.visit(each);
        for (kept* x : {&now_, &before_, &earlier_}) memory::visit_components("derivative", *x, each);
    }
    /// -rho D^beta q to order two at the point reached last, or with `back` at the one before.
    void add_force(V& f, bool back) const {
        kept const &here = back ? before_ : now_, &there = back ? earlier_ : before_;
        for (int k = 0; k < on_.count(); ++k) {
            S const &x = s::component(here, k), &y = s::component(there, k);
            S& to = shape<V>::component(f, on_.at(k));
            to = to - s::component(rho_, k) * (x + lag_ * (x - y));
        }
    }

private:
    on on_;
    kept rho_, now_, before_, earlier_, force_;
    S lag_, theta_;
};

} // namespace detail

/// The sum of the dampings as a mean over each step.
template <class Damping>
struct mean_over_step {
    std::vector<Damping> dampings;
    static constexpr bool needs_compensation = detail::may_exceed_one<Damping>;

    /// Along one trajectory of states V with steps h.
    template <class S, class V>
    class history : public detail::sum_of_dampings<detail::mean_damping<Damping, S, V>> {
        using detail::sum_of_dampings<detail::mean_damping<Damping, S, V>>::terms_;

    public:
        using extra = detail::step_force<V>;
        history(mean_over_step const& of, S const& h, V const& like) {
            for (Damping const& d : of.dampings) terms_.emplace_back(d, h, like);
        }
        /// The force on the undamped flow, before its constant is known.
        [[nodiscard]] extra extra_force(V const& like) const {
            extra force{zero_like(like), zero_like(like)};
            for (auto const& m : terms_) m.add_slope(force.slope);
            return force;
        }
        void begin(state<S, V> const& x, V const& v0) {
            for (auto& m : terms_) m.begin(x.q, v0);
        }
        void before_step(state<S, V>& x, extra& force, S const&) {
            for (int j = 0; j < detail::shape<V>::dimension(x.q); ++j) detail::shape<V>::component(force.constant, j) = S(0);
            for (auto& m : terms_) m.add_constant(x.q, force.constant);
        }
        void after_step(state<S, V>& x, extra const&) {
            for (auto& m : terms_) m.arrive(x.q);
        }
    };
    /// @throws error::mismatch
    template <class V>
    void require_dimension(V const& q) const {
        for (Damping const& d : dampings) detail::damped_components<Damping, scalar_of<V>, V>::require_dimension(d, q);
    }
};

namespace detail {
template <class L, class Damping>
auto damped_by_mean(L const& l, std::vector<Damping> dampings) {
    static_assert(not is_damped<L>, "several terms are given together, with_fractional_damping(L, {{rho_1, beta_1}, {rho_2, beta_2}})");
    return damped_problem<L, mean_over_step<Damping>>{l, {std::move(dampings)}};
}
} // namespace detail

/// The Lagrangian L with the damping -rho D^beta q, of this factor and order, read as a mean over each step. rho is a number, or for
/// vectors a vector of them: components whose rho is zero keep no history. beta in ]0, 2[ is fraction<P, Q>{} or a number; its unit of time
/// is that of T, so rho has the unit force / (length / time^beta). Forces come first, with_fractional_damping(with_force(L, f), ...).
///
/// Embedded by mid-point it is of order two, also for q0 != 0 and v0 != 0; in the first steps, where the solution is like t^{3 - beta},
/// momenta are of order 2 - beta only. It adds no limit to the length of steps.
/// @throws error::invalid_parameter when beta or rho is out of range
template <generating_function G = grunwald_letnikov, class L, class Rho, class Order, class Policy = direct>
auto with_fractional_damping(L const& l, Rho factor, Order order, Policy policy = {}) {
    auto damping = detail::checked_damping<G>(std::move(factor), std::move(order), std::move(policy), initial_history::caputo);
    return detail::damped_by_mean(l, std::vector{std::move(damping)});
}
/// The same with the sum of several terms, {{rho_1, beta_1}, {rho_2, beta_2}, ...}, each with a history of its own.
template <generating_function G = grunwald_letnikov, class S = double, class L, class Policy = direct>
auto with_fractional_damping(L const& l, std::vector<fractional_term<S>> const& terms, Policy policy = {}) {
    std::vector<fractional_damping<G, S, run_time<S>, Policy>> all;
    for (auto const& [factor, order] : terms) all.push_back(detail::checked_damping<G>(factor, order, policy, initial_history::caputo));
    return detail::damped_by_mean(l, std::move(all));
}

} // namespace hilger
