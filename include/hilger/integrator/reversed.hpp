// SPDX-License-Identifier: BSL-1.0
// The adjoint of a flow, Phi_h^* = (Phi_{-h})^{-1}: the step that undoes a step of -h (Hairer-Lubich-Wanner, Geometric Numerical
// Integration, II.3). It is the flow of L_h^*(x, y) = -L_{-h}(y, x) (Marsden-West 2001, section 2.4), that is of the embedding read from
// the other end: control values in reversed order, velocities and weights as of a step -h. Forces stand beside dL/dq on the same rows, so
// they are kept.
//   adjoint(embed(L, order_one)) steps as embed(L, order_one_left); mid-point is its own adjoint; adjoint(adjoint(f)) has the type of f.
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
template <class E>
constexpr E turned(reversed<E> const& e) {
    return e.of;
}

} // namespace detail

/// -L_{-h}(y, x) as a table. The control value j stands where s - j did, seen from the other end: at 1 - fraction.
template <class S, class E>
tableau<S> tableau_of(reversed<E> const& e, S const& h) {
    tableau<S> const back = tableau_of(e.of, S(-h));
    tableau<S> t = back;
    for (int j = 0; j < t.controls; ++j) {
        int const opposite = t.controls - 1 - j;
        t.fraction_of_step[static_cast<std::size_t>(j)] = S(1) - back.fraction_of_step[static_cast<std::size_t>(opposite)];
        for (int k = 0; k < t.nodes; ++k) {
            auto const entry = static_cast<std::size_t>(k * t.controls + j);
            t.position[entry] = back.a(k, opposite);
            t.velocity[entry] = back.b(k, opposite);
        }
    }
    for (int k = 0; k < t.nodes; ++k) t.weight[static_cast<std::size_t>(k)] = -back.w(k);
    return t;
}

/// The flow f^* with f^*_h = (f_{-h})^{-1}.
template <class F, class Force, class E, sums Sums>
auto adjoint(flow<F, Force, E, Sums> const& f) {
    auto const how = detail::turned(f.embedding());
    return flow<F, Force, std::remove_const_t<decltype(how)>, Sums>(f.mechanics().lagrangian, f.mechanics().force, how);
}

} // namespace hilger
