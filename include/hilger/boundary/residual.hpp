// SPDX-License-Identifier: BSL-1.0
// The residual of two-sided problems (boundary/solve.hpp) in roundings of its own terms: each row reads all points, and the sizes of its
// terms are sums with the absolute values of the weights of Delta_-^alpha and of its adjoint.
#pragma once

#include "hilger/boundary/convolved.hpp"
#include "hilger/variational/relative_residual.hpp"

namespace hilger {

/// As for local equations; N steps cost N^2 products.
template <class F, generating_function G, class Order, class Root, discrete_function X>
auto relative_residual(euler_lagrange<fractional_action<F, G, Order, Root>> const& equation, X const& x) {
    detail::require_two_sided_weights<fractional_difference<G, Order, side::minus>, Root>();
    using V = value_of<X>;
    using S = scalar_of<V>;
    auto const& action = equation.action();
    Root const& T = x.root();
    auto const N = static_cast<std::size_t>(T.steps());
    auto weights = first_weights<G>(action.velocity.order.template as<S>(), T.steps() + 1);
    S const factor = detail::leading_factor<G>(T, action.velocity.order);
    for (S& w : weights) w = S(magnitude(S(w * factor)));
    auto const v = tabulate(action.velocity[x]);
    auto const derivatives = equation.derivatives();
    std::vector<V> own(N + 1, zero_like(V(x.get(0)))), momenta = own;
    for (std::size_t k = 1; k <= N; ++k) {
        auto const i = static_cast<index_type>(k);
        V size_of_v = zero_like(own[0]);
        for (std::size_t j = 0; j <= k; ++j) size_of_v = size_of_v + detail::sizes(V(x.get(i - static_cast<index_type>(j)))) * weights[j];
        auto const at = derivatives.expand(S(T.element(i)), V(x.get(i)), V(v.get(i)));
        own[k] = detail::sizes(V(at.e.by_q));
        momenta[k] = detail::sizes(V(at.e.by_v));
        V const position = x.get(i);
        detail::add_sizes(own[k], at.e.qq, position);
        detail::add_sizes(own[k], at.e.qv, size_of_v);
        detail::add_sizes(momenta[k], at.vq_, position);
        detail::add_sizes(momenta[k], at.e.vv, size_of_v);
    }
    auto const residual = equation.residual(x);
    S worst(0);
    for (std::size_t k = 1; k < N; ++k) {
        for (std::size_t j = k; j <= N; ++j) own[k] = own[k] + momenta[j] * weights[j - k];
        worst = detail::larger(worst, detail::largest_in_roundings(V(residual.get(static_cast<index_type>(k))), own[k]));
    }
    return worst;
}

} // namespace hilger
