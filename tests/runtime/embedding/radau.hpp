// SPDX-License-Identifier: BSL-1.0
// A quadrature of one's own: Radau's two nodes, of which one is the end of the step, exact up to degree 2. Rational, and not symmetric.
#pragma once

#include "hilger/embedding/galerkin.hpp"

namespace hilger::testing {

struct radau {
    static constexpr char const* name = "Radau";
    static constexpr bool is_symmetric = false;
    template <class S>
    static auto on_unit_interval(int) {
        using W = typename detail::wider<S>::type;
        return detail::quadrature<W>{{W(1) / W(3), W(1)}, {W(3) / W(4), W(1) / W(4)}};
    }
};
/// Quadratic polynomials, read at these.
inline constexpr auto radau_galerkin =
    make_embedding<step_weight>(polynomial_value<2, radau, 2>{}, polynomial_slope<2, radau, 2>{}, "Radau");

} // namespace hilger::testing
