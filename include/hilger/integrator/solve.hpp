// SPDX-License-Identifier: BSL-1.0
// A discrete Euler-Lagrange equation solved on its scale: from initial data to the function x in C(T).
#pragma once

#include "hilger/function/function.hpp"
#include "hilger/integrator/flow.hpp"

namespace hilger {

/// Initial position and velocity. The momentum is p0 = dL/dv(q0, v0).
template <class V>
struct initial_velocity {
    V q0;
    V v0;
};

/// The solution with q(a) = q0 and p(a) = dL/dv(q0, v0), one value per point of T.
/// @throws as flow::along does; a failed step says where the solution ends.
template <class F, linear_map A, linear_map B, class W, class Root, class V>
auto solve(euler_lagrange<action<F, A, B, W, Root>> const& equation, Root const& T, initial_velocity<V> const& from) {
    std::vector<V> positions;
    positions.reserve(static_cast<std::size_t>(T.size()));
    V const p0 = momentum_of(equation.action().function, from.q0, from.v0);
    for (auto const& at : flow_of(equation).along(T, from.q0, p0)) positions.push_back(at.q);
    return function(T, std::move(positions));
}
/// The same with braces: solve(EL, T, {.q0 = 1.0, .v0 = 0.0}), for scalar positions.
template <class F, linear_map A, linear_map B, class W, class Root>
auto solve(euler_lagrange<action<F, A, B, W, Root>> const& equation, Root const& T,
           initial_velocity<typename Root::scalar_type> const& from) {
    return solve<F, A, B, W, Root, typename Root::scalar_type>(equation, T, from);
}

} // namespace hilger
