// SPDX-License-Identifier: BSL-1.0
// The adjoint of a flow, Phi_h^* = (Phi_{-h})^{-1}: the step that undoes a step of -h (Hairer-Lubich-Wanner, Geometric Numerical
// Integration, II.3). It is the flow of L_h^*(x, y) = -L_{-h}(y, x) (Marsden-West 2001, section 2.4), that is of the embedding read from
// the other end: control values in reversed order, velocities and weights as of a step -h. Forces are terms beside dL/dq in the same rows,
// so they are kept.
//   adjoint(embed(L, order_one)) steps as embed(L, order_one_left); mid-point and Galerkin are their own adjoints; adjoint(adjoint(f)) has
//   the type of f.
#pragma once

#include "hilger/integrator/flow.hpp"

namespace hilger {

/// The embedding E read from the end of each step.
template <class E>
struct reversed {
    [[no_unique_address]] E of;
};

template <class E>
inline constexpr int controls_of<reversed<E>> = controls_of<E>;

namespace detail {

template <class E>
inline constexpr embedding_facts facts_<reversed<E>> = {facts_of<E>.one_node, facts_of<E>.at_end, facts_of<E>.at_start};

template <class E>
constexpr reversed<E> turned(E const& e) {
    return {e};
}
/// A Galerkin step with symmetric nodes, as Gauss's and Lobatto's, is its own adjoint.
template <int Degree, class Quadrature, int Count>
    requires(Quadrature::is_symmetric)
constexpr auto
turned(embedding<polynomial_value<Degree, Quadrature, Count>, polynomial_slope<Degree, Quadrature, Count>, step_weight> const& e) {
    return e;
}
template <class E>
constexpr E turned(reversed<E> const& e) {
    return e.of;
}

} // namespace detail

/// -L_{-h}(y, x) as a table.
template <class S, class E>
tableau<S> tableau_of(reversed<E> const& e, S const& h) {
    tableau<S> const back = tableau_of(e.of, S(-h));
    tableau<S> t = back;
    for (int k = 0; k < t.nodes; ++k) {
        for (int j = 0; j < t.controls; ++j) {
            auto const at = static_cast<std::size_t>(t.controls * k + j);
            t.position[at] = back.a(k, t.controls - 1 - j);
            t.velocity[at] = back.b(k, t.controls - 1 - j);
        }
        t.weight[static_cast<std::size_t>(k)] = -back.w(k);
        if (not t.inside.empty()) t.inside[static_cast<std::size_t>(k)] = h + back.inside[static_cast<std::size_t>(k)];
    }
    return t;
}

/// The flow f^* with f^*_h = (f_{-h})^{-1}.
template <class F, class Force, class E, sums Sums>
auto adjoint(flow<F, Force, E, Sums> const& f) {
    auto const how = detail::turned(f.embedding());
    return flow<F, Force, std::remove_const_t<decltype(how)>, Sums>(f.mechanics().lagrangian, f.mechanics().force, how);
}

} // namespace hilger
