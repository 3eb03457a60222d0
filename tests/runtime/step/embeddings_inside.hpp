// SPDX-License-Identifier: BSL-1.0
// Embeddings of one's own that read points inside their steps, and Lagrangians for them.
#pragma once

#include <cmath>

#include "hilger/embedding/galerkin.hpp"

namespace hilger::testing {

/// Position-dependent masses, a gyroscopic term and a potential that is no polynomial.
inline constexpr auto general = [](auto const& q, auto const& v) {
    auto const d = q.size();
    return (2 + cos(q(0))) * v.squaredNorm() / 2 + q(0) * v(d - 1) - q.squaredNorm() / 2 - q(0) * q(0) * q(d - 1);
};
inline constexpr auto swing = [](auto const& q, auto const& v) { return v * v / 2 - (1 - cos(q)); };
inline constexpr auto friction = [](auto const& t, auto const& q, auto const& v) {
    using std::sin; // of the time, which is a number
    return -v * v * v / 5 + sin(t) - q / 7;
};

/// The same numbers in another type: no library knows it, so it is stepped by its tableau alone.
template <class E>
constexpr auto by_tableau(E const& e) {
    return make_embedding<step_weight>(fraction<1>{} * e.position, e.velocity, "the same");
}
/// Orders of one on the points of T/2: mean positions and differences there, two steps of half the length each.
inline constexpr auto two_mid_points = [] {
    constexpr identity_on<subdivided<2>, delta_weight> here{};
    return make_embedding<delta_weight>(fraction<1, 2>{} * (here + sigma_o), Delta_o_plus, "two mid-points");
}();

/// The trapezoid rule on both halves of a step, which is not exact for squares of the velocities of quadratic polynomials.
struct trapezoids {
    static constexpr char const* name = "trapezoids";
    static constexpr bool is_symmetric = true;
    template <class S>
    static quadrature<S> on_unit_interval(int) {
        return {{S(0), S(1) / S(2), S(1)}, {S(1) / S(4), S(1) / S(2), S(1) / S(4)}};
    }
};
inline constexpr auto trapezoid_galerkin =
    make_embedding<step_weight>(polynomial_value<2, trapezoids, 3>{}, polynomial_slope<2, trapezoids, 3>{}, "trapezoids");
/// Lobatto's nodes with one degree more than they are exact for.
inline constexpr auto too_steep =
    make_embedding<step_weight>(polynomial_value<2, lobatto, 2>{}, polynomial_slope<2, lobatto, 2>{}, "two Lobatto nodes, degree 2");

} // namespace hilger::testing
