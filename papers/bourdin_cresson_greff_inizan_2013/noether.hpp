// SPDX-License-Identifier: BSL-1.0
// Noether's theorem for the fractional embedding (Bourdin, Cresson, Greff, Inizan 2013, section 4). Let phi(s, .) be a one-parameter group
// with generator xi = d phi / ds (0, .), and L invariant: L(phi(s, Q), Delta_-^alpha phi(s, Q), t) does not depend on s. Then along
// solutions of (EL_h^alpha), for k = 1..N-1,
//   (26)  (Delta_-^alpha xi(Q))_k . p_k - xi(Q_k) . (Delta_+^alpha p)_k = 0,   p = dL/dv(Q, Delta_-^alpha Q, t),
// and for alpha = 1, where Delta_- has a Leibniz formula,
//   (29)  xi(Q_k) . p_{k+1}  is the same for k = 0..N-1.
// A linear group commutes with Delta_-^alpha, and invariance is a matter of L(x, v) alone. A translation does not: for alpha < 1 the
// fractional difference of a constant is not zero, so that L must know it.
#pragma once

#include "hilger/boundary/convolved.hpp"
#include "hilger/variational/lagrangian.hpp"

namespace hilger::papers {

template <class Generator, discrete_function X>
auto generated(Generator const& xi, X const& x) {
    return tabulate(apply_pointwise([&xi](auto const& q) { return std::remove_cvref_t<decltype(q)>(xi(q)); }, x));
}
/// p on T^-: for k = 0 there is none.
template <class Action, discrete_function X>
auto momenta_of(Action const& action, X const& x) {
    using V = value_of<X>;
    auto const p = action.at_nodes(x, [&](auto const& t, auto const& q, auto const& v) {
        return V(gradient_second(detail::at_time{action.function, t}, V(q), V(v)));
    });
    return tabulate(detail::restrict_to(p, domain<nodes, 1, 0>{}));
}
/// The left-hand side of (26) on T^+-, scalars; the generator is a vector field xi(q). Zero where x solves the equation of a Lagrangian
/// with this symmetry, up to the residual's rounding times |xi|. In O(N^2).
template <class F, generating_function G, class Order, class Root, class Generator, discrete_function X>
auto fractional_noether_residual(euler_lagrange<fractional_action<F, G, Order, Root>> const& equation, Generator const& xi, X const& x) {
    using S = typename Root::scalar_type;
    auto const& velocity = equation.action().velocity;
    auto const moved = generated(xi, x);
    auto const p = momenta_of(equation.action(), x);
    auto const speed = velocity[moved];
    auto const change = velocity.adjoint()[p];
    std::vector<S> rest;
    for (index_type k = 1; k < x.last(); ++k)
        rest.push_back(S(dot_product(value_of<X>(speed.get(k)), p.get(k)) - dot_product(moved.get(k), value_of<X>(change.get(k)))));
    return function_on(interior(x.root()), std::move(rest));
}

/// xi(Q_k) . p_{k+1} on T^+, the constant of motion (29) of a symmetry.
/// @throws error::invalid_parameter when alpha is not 1: the fractional difference of a product is no sum of two products.
template <class F, generating_function G, class Order, class Root, class Generator, discrete_function X>
auto noether_constant(euler_lagrange<fractional_action<F, G, Order, Root>> const& equation, Generator const& xi, X const& x) {
    using S = typename Root::scalar_type;
    if (S const alpha = equation.action().velocity.order.template as<S>(); alpha != S(1))
        error::raise<error::invalid_parameter>(
            "Noether's theorem has an explicit constant for alpha = 1 only, and this equation has alpha = ", alpha,
            "; see fractional_noether_residual");
    auto const moved = generated(xi, x);
    auto const p = momenta_of(equation.action(), x);
    std::vector<S> constant;
    for (index_type k = 0; k < x.last(); ++k) constant.push_back(S(dot_product(moved.get(k), p.get(k + 1))));
    return function_on(without_last(x.root()), std::move(constant));
}

} // namespace hilger::papers
