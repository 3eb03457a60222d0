// SPDX-License-Identifier: BSL-1.0
// A quadrature of one's own: Radau's two nodes, of which one is the end of the step, exact up to degree 2. Rational, and not symmetric.
#pragma once

#include "hilger/embedding/galerkin.hpp"

namespace hilger::testing {

struct own_radau {
    static constexpr char const* name = "Radau";
    static constexpr bool is_symmetric = false;
    template <class S>
    static quadrature<S> on_unit_interval(int) {
        return {{S(1) / S(3), S(1)}, {S(3) / S(4), S(1) / S(4)}};
    }
};
/// Quadratic polynomials, read at these.
inline constexpr auto radau_galerkin =
    make_embedding<step_weight>(polynomial_value<2, own_radau, 2>{}, polynomial_slope<2, own_radau, 2>{}, "Radau");

} // namespace hilger::testing
