// SPDX-License-Identifier: BSL-1.0
// Fractional variational integrators (Jimenez, Ober-Bloebaum, section 3): the embedding of a Lagrangian L with a damping -rho D^beta q,
// beta = 2 alpha, from the restricted variation of a pair of curves. With (Delta q)_k the difference of order beta at t_k,
//   damping_at::start   p_k = -d_1 L_h(q_k, q_{k+1}) + h rho (Delta q)_k,   p_{k+1} = d_2 L_h(q_k, q_{k+1})              (21)
//   damping_at::end     p_k = -d_1 L_h(q_k, q_{k+1}),   p_{k+1} = d_2 L_h(q_k, q_{k+1}) - h rho (Delta q)_{k+1}          (remark 2)
//   damping_at::both    half of it at each end
// All have the positions of (20), once the first two are the same: each is a step of the flow without damping, before and after which the
// momentum is changed. So they are explicit where that flow is, whatever the embedding. Against the continuous equation the first two have
// order one, and the third has order two with mid-point and the weights of bdf<2>. With Riemann and Liouville's history and x_0 != 0 the
// impulse of the jump at t_0 belongs to the start: damping at the end of steps loses it, and damping at both ends half of it. The order of
// these two is then 1 - beta, and from beta = 1 on they solve their equations and tend to no solution of the continuous one.
//
// Being explicit they have a limit of stability. On the oscillator M q'' + K q = -rho D^beta q with mid-point it is
//   rho h^{2 - beta} omega(-1)^beta / M < 4,   omega(-1) = 2 for Gruenwald-Letnikov and 4 for bdf<2>, beyond all limits for trapezoid:
// beyond it the root z = -1 of both parts is passed, and positions alternate and grow. Other embeddings have a smaller limit. Impulses that
// alternate from step to step and have grown by the factor 2^16 meanwhile are an error. fractional/mean.hpp has no such limit.
//   auto const flow = embed(with_fractional_impulses(L, rho, fraction<1, 2>{}), mid_point);
//   for (auto const& x : flow.along(uniform(0.0, h, N), q0, p0)) ...
#pragma once

#include "hilger/fractional/damping.hpp"
#include "hilger/step/force.hpp"

namespace hilger {

/// The end of a step to which the impulse of a damping belongs.
enum class damping_at { start, end, both };

/// Options of with_fractional_impulses.
struct impulse_options {
    damping_at at = damping_at::start;
    initial_history history = initial_history::caputo;
};

namespace detail {

/// h rho (Delta q)_k along one trajectory of states V with steps h, for the components that have a rho, and whether it stays within bounds.
template <class Damping, class S, class V>
class damping_impulses {
    using on = damped_components<Damping, S, V>;
    using kept = typename on::kept;
    using s = shape<kept>;

public:
    using extra = no_step_force;
    template <class Reading>
    damping_impulses(Reading const& of, S const& h, V const& like)
        : on_(of.damping, h, like), rho_(on_.coefficients(of.damping)), now_(zero_like(rho_)), before_(now_), impulse_(now_), began_(now_),
          at_(of.at), h_(h) {}
    [[nodiscard]] extra extra_force(V const&) const { return {}; }
    [[nodiscard]] bool needs_velocity() const { return on_.needs_velocity(); }
    void begin(state<S, V> const& x, V const& v0) {
        if (on_.count() == 0) return;
        kept const velocity = on_.of(v0);
        on_.history().begin(on_.of(x.q), velocity);
        take(x.q);
        before_ = now_;
    }
    void before_step(state<S, V>& x, extra const&, S const&) {
        if (at_ != damping_at::end) damp(x.p);
    }
    /// @throws error::not_finite, also where impulses alternate and grow
    void after_step(state<S, V>& x, extra const&) {
        if (on_.count() > 0) {
            std::swap(before_, now_);
            take(x.q);
            watch();
        }
        if (at_ == damping_at::start) return; // the next step checks the result
        damp(x.p);
        if (not all_finite(x.p)) error::raise<error::not_finite>("a fractional damping meets NaN or infinity");
    }
    /// Everything that later steps depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        on_.visit(each);
        for (kept* x : {&now_, &before_, &impulse_, &began_}) memory::visit_components("impulse", *x, each);
    }
    void add_force(V& f, bool back) const {
        for (int k = 0; k < on_.count(); ++k) {
            S& to = shape<V>::component(f, on_.at(k));
            to = to - s::component(rho_, k) * s::component(back ? before_ : now_, k);
        }
    }

private:
    /// Subtracts the impulse at the current point from p.
    void damp(V& p) const { on_.add(p, S(-1), impulse_); }
    void take(V const& q) {
        now_ = on_.history().arrive(on_.of(q));
        S const length = at_ == damping_at::both ? S(h_ / S(2)) : h_;
        for (int k = 0; k < on_.count(); ++k) s::component(impulse_, k) = length * s::component(rho_, k) * s::component(now_, k);
    }
    /// Beyond the limit of stability the root of the equation with the largest modulus is negative. A resolved solution does not alternate;
    /// an unresolved one may for long, but does not grow so much.
    void watch() {
        for (int k = 0; k < on_.count(); ++k) {
            S const &x = s::component(before_, k), &y = s::component(now_, k);
            bool const alternates = (x < S(0) and -x < y) or (S(0) < x and y < -x);
            if (not alternates) [[likely]]
                s::component(began_, k) = S(0);
            else if (s::component(began_, k) == S(0))
                s::component(began_, k) = magnitude(x);
            else if (S(65536) * s::component(began_, k) < magnitude(y))
                error::raise<error::not_finite>("the impulses of a fractional damping alternate and grow: steps of ", h_,
                                                " are beyond the limit of stability, rho h^(2 - beta) omega(-1)^beta / M < 4; take shorter "
                                                "ones, or with_fractional_damping, which has no limit");
        }
    }
    on on_;
    kept rho_, now_, before_, impulse_, began_;
    damping_at at_;
    S h_;
};

} // namespace detail

/// A damping as impulses at the points of T.
template <class Damping>
struct impulses_at_points {
    Damping damping;
    damping_at at;

    template <class S, class V>
    using history = detail::damping_impulses<Damping, S, V>;
    /// @throws error::mismatch
    template <class V>
    void require_dimension(V const& q) const {
        detail::damped_components<Damping, scalar_of<V>, V>::require_dimension(damping, q);
    }
};

/// The Lagrangian L with the damping -rho D^beta q, of this factor and order, as impulses at the points of T, by the restricted variational
/// principle: explicit, of order one, and with a limit of stability, rho h^{2 - beta} omega(-1)^beta / M < 4 for mid-point. rho, beta and
/// the policy are as for with_fractional_damping, which has no such limit. @throws error::invalid_parameter when beta or rho is out of
/// range
template <generating_function G = grunwald_letnikov, class L, class Rho, class Order, class Policy = direct>
auto with_fractional_impulses(L const& l, Rho factor, Order order, Policy policy = {}, impulse_options options = {}) {
    static_assert(not detail::is_damped<L>, "impulses of one damping: terms that are added up belong into with_fractional_damping");
    auto damping = detail::checked_damping<G>(std::move(factor), std::move(order), std::move(policy), options.history);
    return damped_problem<L, impulses_at_points<decltype(damping)>>{l, {std::move(damping), options.at}};
}

} // namespace hilger
