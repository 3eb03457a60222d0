// SPDX-License-Identifier: BSL-1.0
// The discrete action  S(q) = int L(A q, B q)  of an embedding (A, B, int) on a scale T (Cresson-Safi (10), (43), definition 8).
#pragma once

#include "hilger/function/function.hpp"
#include "hilger/variational/lagrangian.hpp"
#include "hilger/variational/problem.hpp"

namespace hilger {

/// A and B map from T to the scale of the integral, Weight is its measure: delta or nabla on T, steps on T_lambda.
template <class F, linear_map A, linear_map B, class Weight, class Root>
struct action {
    using function_type = F;
    using weight = Weight;
    using root_type = Root;
    using position_type = A;
    using velocity_type = B;
    static constexpr bool is_sum = false; ///< of actions
    F function;
    [[no_unique_address]] A position;
    [[no_unique_address]] B velocity;
    Root T;
    [[nodiscard]] constexpr Root const& scale() const { return T; }

    /// S(x) of a function on T, or on T with points inside the steps if A reads these.
    template <discrete_function X>
    constexpr auto operator()(X const& x) const {
        return weighted_sum<Weight>(at_nodes(x, [L = function](auto const& t, auto const& q, auto const& v) {
            return detail::at_time{L, t}(q, v);
        }));
    }
    /// what(t, q, v) at the nodes of x; t is the position operator applied to time (t_{i+1/2} for mid-point).
    template <discrete_function X, class What>
    constexpr auto at_nodes(X const& x, What what) const {
        auto const time =
            hilger::function_on(derived_scale(x.root(), domain<typename A::from>{}), [](typename Root::scalar_type const& t) { return t; });
        return apply_pointwise(std::move(what), position[time], position[x], velocity[x]);
    }
};

namespace detail {
/// An operator into T_{o,lambda}, restricted to T_lambda, the points of the integral.
template <class Lambda, linear_map A>
constexpr auto seen_on(between<Lambda> const& base, A a) {
    if constexpr (std::same_as<typename A::to, joined<Lambda>>)
        return restriction_to<Lambda, false>{{}, base.lambda} * std::move(a);
    else
        return a;
}
template <class Base>
constexpr auto seen_on(Base const&, linear_map auto a) {
    return a;
}
template <class Lives, class Domain>
constexpr auto integrated_elsewhere() {
    return does_not_compile<"this Lagrangian lives on " + Lives::name() + ", and the integral is over " + Domain::name()>{};
}
} // namespace detail

/// int L(A[q], B[q]) over T (weights mu, Cresson-Safi (7)), half(T) or at_lambda(T) ((32)), or over the nodes of a quadrature.
template <class F, linear_map A, linear_map B, time_scale_like Scale>
constexpr auto integral(lagrangian_density<F, A, B> const& density, Scale const& scale) {
    using D = typename Scale::domain_type;
    using Base = typename D::base_type;
    static_assert(D::front == 0 and D::back == 0, "integrate a Lagrangian over a whole scale: T, half(T) or at_lambda(T)");
    auto const a = detail::seen_on(scale.domain().base, density.position);
    auto const b = detail::seen_on(scale.domain().base, density.velocity);
    using SeenA = decltype(detail::seen_on(scale.domain().base, density.position));
    using SeenB = decltype(detail::seen_on(scale.domain().base, density.velocity));
    using Root = typename Scale::root_type;
    if constexpr (not std::same_as<typename SeenA::to, Base>)
        return detail::integrated_elsewhere<typename SeenA::to, D>();
    else {
        constexpr bool on_steps = requires(Root const& T, Base const& base) { step_weight::at(T, base, index_type(0)); };
        using W = std::conditional_t<on_steps, step_weight, delta_weight>;
        return action<F, SeenA, SeenB, W, Root>{density.function, a, b, scale.root()};
    }
}

/// The same from the left, over T^- (weights nu): the fractional functional h sum_{k=1..N} L(Q_k, (Delta_-^alpha Q)_k) of Bourdin et al.
/// (12) is nabla_integral(L(q, Delta_minus_alpha<P, Q>[q]), T).
template <class F, linear_map A, linear_map B, time_scale_like Scale>
constexpr auto nabla_integral(lagrangian_density<F, A, B> const& density, Scale const& scale) {
    using D = typename Scale::domain_type;
    using Root = typename Scale::root_type;
    static_assert(std::same_as<D, domain<nodes>>, "the nabla integral of a Lagrangian is over T");
    if constexpr (not std::same_as<typename A::to, nodes>)
        return detail::integrated_elsewhere<typename A::to, D>();
    else if constexpr ((A::needs_uniform or B::needs_uniform) and not Root::is_uniform)
        return does_not_compile<B::name() + " has the weights of one step h, and this integral is over " + Root::kind()>{};
    else
        return action<F, A, B, nabla_weight, Root>{density.function, density.position, density.velocity, scale.root()};
}

} // namespace hilger
