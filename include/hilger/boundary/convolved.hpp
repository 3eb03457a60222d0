// SPDX-License-Identifier: BSL-1.0
// The fractional embedding of a Lagrangian (Bourdin, Cresson, Greff, Inizan 2013, section 3): on a uniform T the functional (12)
//   h sum_{k=1..N} L(Q_k, (Delta_-^alpha Q)_k, t_k),   (Delta_-^alpha Q)_k = h^-alpha sum_{r=0..k} alpha_r Q_{k-r},
// is nabla_integral(L(q, Delta_minus(alpha)[q]), T). Its critical points for variations that vanish at both ends solve (EL_h^alpha),
//   dL/dx_k + (Delta_+^alpha dL/dv)_k = 0,  k = 1..N-1.
// Velocities and momenta are needed for k = 1..N only: the sums of Delta_+^alpha end at N, and none reads k = 0. alpha = 1 is the order-one
// embedding with Delta_-. The residual of the equation is here two convolutions, at all points at once; euler_lagrange::residual has it
// point by point, in O(N^2).
#pragma once

#include "hilger/history/convolution.hpp"
#include "hilger/operator/fractional.hpp"
#include "hilger/scale/uniform.hpp"
#include "hilger/variational/lagrangian.hpp"
#include "hilger/variational/variation.hpp"

namespace hilger {

/// The functional (12), with the weights of any generating function.
template <class F, generating_function G, class Order, class Root>
using fractional_action = action<F, identity_on<nodes, delta_weight>, fractional_difference<G, Order, side::minus>, nabla_weight, Root>;

namespace detail {

/// Refuses an uneven T, where the weights of each point are others.
template <linear_map A, class Root>
constexpr void require_two_sided_weights() {
    if constexpr (not Root::is_uniform)
        does_not_compile<A::name() + " has the weights of one step h, and this integral is over " + Root::kind()>{};
}
/// @throws error::invalid_parameter outside ]0, 1]
template <class S>
void require_two_sided_order(S const& alpha) {
    if (not(S(0) < alpha and alpha <= S(1)))
        error::raise<error::invalid_parameter>("the order of the difference of a two-sided problem lies in ]0, 1], and this one is ",
                                               alpha);
}

enum class direction { forward, backward };

/// A triangular Toeplitz matrix on values of type V, component by component; backward: its transpose.
template <class V>
std::vector<V> apply_triangle(toeplitz_triangle<scalar_of<V>> const& triangle, std::vector<V> const& x, scalar_of<V> const& factor,
                              direction to) {
    using s = shape<V>;
    std::vector<V> y = x;
    std::size_t const n = x.size();
    for (int c = 0; c < s::dimension(x.front()); ++c) {
        std::vector<scalar_of<V>> row(n, scalar_of<V>(0));
        for (std::size_t k = 0; k < n; ++k) row[to == direction::forward ? k : n - 1 - k] = s::component(x[k], c);
        row = triangle(row);
        for (std::size_t k = 0; k < n; ++k) s::component(y[k], c) = factor * row[to == direction::forward ? k : n - 1 - k];
    }
    return y;
}

/// The left-hand side of (EL_h^alpha) for t_1, ..., t_{N-1}, of one value for each point of T, N > 0. Its rounding error is of the size of
/// epsilon h^(-2 alpha) |x|, as that of a second difference is.
template <class V, class F, generating_function G, class Order, class Root>
std::vector<V> convolved_residual(fractional_action<F, G, Order, Root> const& action, std::vector<V> const& x) {
    using S = scalar_of<V>;
    Root const& T = action.T;
    toeplitz_triangle<S> const difference(first_weights<G>(action.velocity.order.template as<S>(), T.size()));
    S const factor = leading_factor<G>(T, action.velocity.order);
    auto const v = apply_triangle(difference, x, factor, direction::forward);
    std::vector<V> rest(x.size(), zero_like(x.front())), force = rest;
    for (std::size_t k = 1; k < x.size(); ++k) {
        at_time const L{action.function, T.element(static_cast<index_type>(k))};
        rest[k] = gradient_second(L, x[k], v[k]);
        force[k] = gradient_first(L, x[k], v[k]);
    }
    rest = apply_triangle(difference, rest, factor, direction::backward);
    for (std::size_t k = 1; k < x.size(); ++k) rest[k] = rest[k] + force[k];
    return {rest.begin() + 1, rest.end() - 1};
}

} // namespace detail

} // namespace hilger
