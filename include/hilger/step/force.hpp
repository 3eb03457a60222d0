// SPDX-License-Identifier: BSL-1.0
// A force that is constant in time over a step and affine in the displacement,
//   F = constant - slope (q_{i+1} - q_i),   component by component:
// the part of a memory, read as a mean over the step, that enters the equation of the step. Its virtual work is that of the mean position:
//   no control values inside the step    p_i + h F / 2 = -d_1 L_h,   p_{i+1} = d_2 L_h + h F / 2,   whatever the embedding
//   control values inside                F is added to dL/dq at every node
// Both change the momentum by h F. They coincide for mid-point.
// And forces at the nodes of a step, affine in the displacements A_m - q_i of all nodes: those of a memory with stages
// (fractional/stages.hpp). They are added to dL/dq there, as any force is.
#pragma once

#include <vector>

#include <Eigen/Core>

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

/// F_k = constant_k - factor sum_m slope_km (A_m - q_i) at node k, summed over the terms, component by component.
template <class V>
struct node_force {
    struct term {
        V factor;
        Eigen::Matrix<scalar_of<V>, Eigen::Dynamic, Eigen::Dynamic> slope;
    };
    std::vector<V> constant;
    std::vector<term> terms;
    std::vector<V> moved; ///< A_m - q_i at the end of the last step
};

template <class Extra>
inline constexpr bool is_node_force = false;
template <class V>
inline constexpr bool is_node_force<node_force<V>> = true;
template <class Extra>
inline constexpr bool has_step_force = not std::is_same_v<Extra, no_step_force>;

} // namespace hilger::detail
