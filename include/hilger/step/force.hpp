// SPDX-License-Identifier: BSL-1.0
// A force that is constant in time over a step and affine in the displacement,
//   F = constant - slope (q_{i+1} - q_i),   component by component:
// the part of a memory, read as a mean over the step, that enters the equation of the step. Its virtual work is that of the mean position:
//   no control values inside the step    p_i + h F / 2 = -d_1 L_h,   p_{i+1} = d_2 L_h + h F / 2,   whatever the embedding
//   control values inside                F is added to dL/dq at every node
// Both change the momentum by h F. They coincide for mid-point.
#pragma once

#include "hilger/shape.hpp"

namespace hilger::detail {

/// Steps without such a force.
struct no_step_force {};

/// `slope` belongs to steps of one length; `constant` is set before each of them.
template <class V>
struct step_force {
    V constant, slope;

    template <class X>
    [[nodiscard]] auto at(X const& moved, int k) const {
        using s = shape<V>;
        return scalar_of<V>(s::component(constant, k) - s::component(slope, k) * moved);
    }
};

template <class Extra>
inline constexpr bool has_step_force = not std::is_same_v<Extra, no_step_force>;

} // namespace hilger::detail
