// SPDX-License-Identifier: BSL-1.0
// Fractional variational integrators (Jimenez, Ober-Bloebaum, section 3): the embedding of a Lagrangian L with a damping -rho D^beta q,
// beta = 2 alpha, from the restricted variation of a pair of curves. With (Delta q)_k the difference of order beta at t_k,
//   damping_at::start   p_k = -d_1 L_h(q_k, q_{k+1}) + h rho (Delta q)_k,   p_{k+1} = d_2 L_h(q_k, q_{k+1})              (21)
//   damping_at::end     p_k = -d_1 L_h(q_k, q_{k+1}),   p_{k+1} = d_2 L_h(q_k, q_{k+1}) - h rho (Delta q)_{k+1}          (remark 2)
//   damping_at::both    half of it at each end
// All have the positions of (20), once the first two are the same: each is a step of the flow without damping, before and after which the
// momentum is changed. So they are explicit where that flow is, whatever the embedding. Against the continuous equation the first two have
// order one, and the third has order two with mid-point and the weights of bdf<2>. With Riemann and Liouville's history and x_0 != 0 the
// impulse of the jump at t_0 belongs to the start: at the end it is in no step, and the order is 1 - beta.
//   auto const flow = embed(with_fractional_damping(L, rho, fraction<1, 2>{}), mid_point);
//   for (auto const& x : flow.along(uniform(0.0, h, N), q0, p0)) ...
#pragma once

#include "hilger/integrator/flow.hpp"
#include "hilger/integrator/fractional_memory.hpp"

namespace hilger {

/// Which end of a step a damping belongs to.
enum class damping_at { start, end, both };

/// How a fractional damping is read where the order does not say it.
struct damping_options {
    damping_at at = damping_at::start;
    initial_history history = initial_history::caputo;
};

template <generating_function G, class Rho, class Order, class Policy>
struct fractional_damping {
    using generating = G;
    Rho coefficient;
    [[no_unique_address]] Order order;
    [[no_unique_address]] Policy policy;
    damping_options options;
};

/// A Lagrangian (with forces, perhaps) and a damping.
template <class L, class Damping>
struct damped_problem {
    [[no_unique_address]] L mechanics;
    Damping damping;
};

/// The damping -rho D^beta q beside dL/dq. rho is a number, or for vectors a vector of them: components whose rho is zero keep no history.
/// beta in ]0, 2[ is fraction<P, Q>{} or a number; its unit of time is that of T, so rho has the unit force / (length / time^beta).
/// Forces come first: with_fractional_damping(with_force(L, f), ...). @throws error::invalid_parameter when beta or rho is out of range
template <generating_function G = grunwald_letnikov, class L, class Rho, class Order, class Policy = direct>
auto with_fractional_damping(L const& l, Rho rho, Order beta, Policy policy = {}, damping_options options = {}) {
    if (not detail::all_finite(rho)) error::raise<error::invalid_parameter>("the coefficient of a fractional damping is a finite number");
    if constexpr (detail::is_fraction<Order>) {
        static_assert(0 < Order::numerator and Order::numerator < 2 * Order::denominator,
                      "the order of a fractional damping lies in ]0, 2[");
        using damping = fractional_damping<G, Rho, reduced<Order::numerator, Order::denominator>, Policy>;
        return damped_problem<L, damping>{l, {std::move(rho), {}, std::move(policy), options}};
    } else {
        detail::require_order(beta);
        using damping = fractional_damping<G, Rho, run_time<Order>, Policy>;
        return damped_problem<L, damping>{l, {std::move(rho), {std::move(beta)}, std::move(policy), options}};
    }
}

namespace detail {

/// h rho (Delta q)_k along one trajectory, for the components that have a rho.
template <class Damping, class S, class V>
class damping_impulse {
    using s = shape<V>;
    using kept = std::conditional_t<s::is_scalar, V, Eigen::Matrix<S, Eigen::Dynamic, 1>>;
    using memory = fractional_memory<typename Damping::generating, decltype(Damping::order), decltype(Damping::policy), S, kept>;
    static constexpr bool same_for_all = shape<decltype(Damping::coefficient)>::is_scalar;

public:
    damping_impulse(Damping const& d, S const& h, V const& like)
        : damped_(components(d, like)), memory_(d.order, d.policy, d.options.history, h, shape<kept>::zero(count())),
          weight_(shape<kept>::zero(count())), impulse_(weight_), x_(weight_) {
        S const impulse = d.options.at == damping_at::both ? S(h / S(2)) : h;
        for (int k = 0; k < count(); ++k)
            shape<kept>::component(weight_, k) = impulse * coefficient(d, damped_[static_cast<std::size_t>(k)]);
    }
    [[nodiscard]] int count() const { return static_cast<int>(damped_.size()); }
    [[nodiscard]] index_type values_kept() const { return count() == 0 ? 0 : memory_.kept(); }
    [[nodiscard]] auto const& history() const { return memory_; }
    [[nodiscard]] bool needs_velocity() const { return count() > 0 and memory_.needs_velocity(); }
    void begin(V const& q0, V const& v0) {
        if (count() == 0) return;
        memory_.begin(taken(q0), taken(v0));
        arrive(q0);
    }
    void arrive(V const& q) {
        if (count() == 0) return;
        take(q);
        kept const& derivative = memory_.arrive(x_);
        for (int k = 0; k < count(); ++k)
            shape<kept>::component(impulse_, k) = shape<kept>::component(weight_, k) * shape<kept>::component(derivative, k);
    }
    /// p less the impulse at the point that was arrived at last.
    void damp(V& p) const {
        for (int k = 0; k < count(); ++k) {
            S& to = s::component(p, damped_[static_cast<std::size_t>(k)]);
            to = to - shape<kept>::component(impulse_, k);
        }
    }
    static S coefficient(Damping const& d, int j) {
        if constexpr (same_for_all)
            return S(d.coefficient);
        else
            return S(d.coefficient(j));
    }

private:
    static std::vector<int> components(Damping const& d, V const& like) {
        std::vector<int> all;
        for (int j = 0; j < s::dimension(like); ++j)
            if (not(coefficient(d, j) == S(0))) all.push_back(j);
        return all;
    }
    void take(V const& q) {
        for (int k = 0; k < count(); ++k) shape<kept>::component(x_, k) = s::component(q, damped_[static_cast<std::size_t>(k)]);
    }
    kept taken(V const& q) {
        take(q);
        return x_;
    }
    std::vector<int> damped_;
    memory memory_;
    kept weight_, impulse_, x_;
};

} // namespace detail

template <class Flow, class Damping>
class damped_flow : public stepping<damped_flow<Flow, Damping>> {
public:
    damped_flow(Flow undamped, Damping damping) : undamped_(std::move(undamped)), damping_(std::move(damping)) {}

    /// What the undamped flow remembers, and the history.
    template <class S, class V>
    class memory {
        using undamped = typename Flow::template memory<S, V>;

    public:
        memory(damped_flow const& f, S const& h, V const& like) : step_(f.undamped_, h, like), impulse_(f.damping_, h, like), h_(h) {}

        /// x one step h further. @throws error::mismatch when h is not the length that the history has; error::no_convergence,
        /// error::singular, error::not_finite; x is then as it was.
        void advance(damped_flow const& f, state<S, V>& x, S const& h) {
            begin(f, x, h);
            move(f, x);
        }
        void begin(damped_flow const& f, state<S, V> const& x, S const& h) {
            if (not(h == h_))
                error::raise<error::mismatch>("fractional damping remembers steps of one length, ", h_, ", and this step has ", h);
            if (begun_) return;
            V v0 = zero_like(x.q);
            if constexpr (not detail::is_below_one<decltype(Damping::order)>)
                if (impulse_.needs_velocity()) v0 = velocity_of(detail::at_time{f.undamped_.mechanics().lagrangian, x.t}, x.q, x.p);
            impulse_.begin(x.q, v0);
            begun_ = true;
        }
        /// @throws the same as a step_failure
        void advance_equally(damped_flow const& f, state<S, V>& x) {
            saying_where(x, h_, [&] { move(f, x); });
        }
        /// The number of values that each damped component keeps, and of such components.
        [[nodiscard]] index_type values_kept() const { return impulse_.values_kept(); }
        [[nodiscard]] index_type damped_components() const { return impulse_.count(); }
        /// Those of them that have a history - none where the order is whole - and the bytes that it takes.
        [[nodiscard]] index_type histories() const { return impulse_.history().histories(); }
        [[nodiscard]] std::size_t history_bytes() const { return impulse_.history().bytes(); }

    private:
        /// What fails leaves x as it was.
        struct undo {
            state<S, V>& x;
            state<S, V> const& before;
            bool done = false;
            ~undo() {
                if (not done) x = before;
            }
        };
        /// In place: a copy that is stepped would have to wait until what was just written can be read as a whole.
        void move(damped_flow const& f, state<S, V>& x) {
            before_ = x;
            undo guard{x, before_};
            damping_at const where = f.damping_.options.at;
            if (where != damping_at::end) impulse_.damp(x.p);
            step_.advance(f.undamped_, x, h_);
            impulse_.arrive(x.q);
            if (where != damping_at::start) { // at the start the step itself looks at what comes out
                impulse_.damp(x.p);
                if (not detail::all_finite(x.p)) error::raise<error::not_finite>("a fractional damping meets NaN or infinity");
            }
            guard.done = true;
        }
        undamped step_;
        detail::damping_impulse<Damping, S, V> impulse_;
        S h_;
        state<S, V> before_{};
        bool begun_ = false;
    };

    template <class S, class V>
    static constexpr auto refusal() {
        return Flow::template refusal<S, V>();
    }
    /// Only on scales with equal steps: differences of fractional order are defined there.
    /// @throws error::not_finite, error::mismatch when rho is a vector of another dimension than q0; while walking, a step_failure.
    template <time_scale_like Scale, class V>
    auto along(Scale const& T, V q0, V p0) const {
        if constexpr (not(Scale::root_type::is_uniform and detail::has_equal_steps<typename Scale::domain_type::base_type>))
            return does_not_compile<detail::uneven_steps<Scale>>{};
        else {
            if constexpr (not detail::shape<decltype(damping_.coefficient)>::is_scalar)
                if (detail::shape<V>::dimension(q0) != damping_.coefficient.size())
                    error::raise<error::mismatch>("a fractional damping has one coefficient for each component, and here are ",
                                                  damping_.coefficient.size(), " for ", detail::shape<V>::dimension(q0));
            return stepping<damped_flow>::along(T, std::move(q0), std::move(p0));
        }
    }
    template <time_scale_like Scale, class V>
    auto along(Scale const& T, initial_velocity<V> const& from) const {
        return along(T, from.q0, momentum(T.min(), from.q0, from.v0));
    }
    /// One step has no history.
    template <class S, class V>
    auto step(state<S, V> const&, S const&) const {
        return does_not_compile<detail::no_single_step<S>>{};
    }
    template <class S, class V>
    [[nodiscard]] V momentum(S const& t, V const& q, V const& v) const {
        return undamped_.momentum(t, q, v);
    }
    [[nodiscard]] auto const& mechanics() const { return undamped_.mechanics(); }
    [[nodiscard]] auto const& embedding() const { return undamped_.embedding(); }
    [[nodiscard]] Damping const& damping() const { return damping_; }

private:
    Flow undamped_;
    Damping damping_;
};

template <class L, class Damping, class E>
auto embed(damped_problem<L, Damping> const& damped, E const& how) {
    auto flow = embed(damped.mechanics, how);
    return damped_flow<decltype(flow), Damping>(std::move(flow), damped.damping);
}
template <class L, class Damping, class E>
auto embed(damped_problem<L, Damping> const& damped, E const& how, std::integral_constant<sums, sums::compensated> compensation) {
    auto flow = embed(damped.mechanics, how, compensation);
    return damped_flow<decltype(flow), Damping>(std::move(flow), damped.damping);
}

} // namespace hilger
