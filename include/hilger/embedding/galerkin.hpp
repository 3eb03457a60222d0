// SPDX-License-Identifier: BSL-1.0
// Galerkin embeddings (Marsden-West; Cresson-Safi, section 5): on each step a position is the polynomial through s + 1 control values, read
// together with its derivative at the nodes of a quadrature, which is the integral. They are three operators as every embedding:
//   galerkin<s, gauss>     degree s, s Gauss nodes: order 2s; s = 1 is mid-point, and s is the Gauss collocation method
//   galerkin<s, lobatto>   degree s - 1, s Lobatto nodes: order 2s - 2; s = 2 is Stoermer-Verlet for a separable Lagrangian
//   galerkin<s, radau>     degree s, s Radau nodes, the last one at the end of the step: order 2s - 1
#pragma once

#include "hilger/embedding/embedding.hpp"
#include "hilger/embedding/polynomial.hpp"

namespace hilger {

namespace detail {
/// A polynomial through two points and more is 1 where they are all 1 and t where they are t, and the weights of these quadratures add up
/// to 1; checking that over the finite field would take half a second for sixteen nodes (tests/static/galerkin_is_consistent.cpp). A slope
/// of lower degree than the number of nodes is zero when it is zero at all of them.
template <int Degree, known_quadrature Quadrature, int Count>
inline constexpr bool
    is_consistent_by_construction<polynomial_value<Degree, Quadrature, Count>, polynomial_slope<Degree, Quadrature, Count>, step_weight> =
        Count >= Degree;

template <int Stages, class Quadrature>
constexpr auto make_galerkin() {
    static_assert(Stages >= (std::is_same_v<Quadrature, lobatto> ? 2 : 1),
                  "a Galerkin embedding has one Gauss or Radau node or more, or two Lobatto nodes or more");
    constexpr int degree = Quadrature::degree(Stages);
    return make_embedding<step_weight>(polynomial_value<degree, Quadrature, Stages>{}, polynomial_slope<degree, Quadrature, Stages>{},
                                       Quadrature::name);
}
} // namespace detail

/// Position and velocity are value and derivative of the polynomial, at the nodes, and the integral is the quadrature.
template <int Stages, class Quadrature>
inline constexpr auto galerkin = detail::make_galerkin<Stages, Quadrature>();

} // namespace hilger
