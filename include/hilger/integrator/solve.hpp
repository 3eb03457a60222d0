// SPDX-License-Identifier: BSL-1.0
// A discrete Euler-Lagrange equation solved on its scale: from initial data to the function x in C(T).
#pragma once

#include "hilger/function/function.hpp"
#include "hilger/integrator/flow.hpp"

namespace hilger {

/// The solution with q(a) = q0 and p(a) = dL/dv(q0, v0), one value per point of T. In braces, solve(EL, T, {.q0 = 1.0, .v0 = 0.0}), the
/// data are scalars.
/// @throws as flow::along does; a failed step says where the solution ends.
template <class F, linear_map A, linear_map B, class W, class Root, class V = typename Root::scalar_type>
auto solve(euler_lagrange<action<F, A, B, W, Root>> const& equation, Root const& T, initial_velocity<V> const& from) {
    std::vector<V> positions;
    positions.reserve(static_cast<std::size_t>(T.size()));
    for (auto const& at : flow_of(equation).along(T, from)) positions.push_back(at.q);
    return function_on(T, std::move(positions));
}

} // namespace hilger
