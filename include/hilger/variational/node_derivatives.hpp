// SPDX-License-Identifier: BSL-1.0
// The derivatives of a Lagrangian, and of a force, at one node of a step: asked for where states are small or the callable has derivatives
// of its own, and traced elsewhere.
#pragma once

#include "hilger/variational/asked_node.hpp"
#include "hilger/variational/traced_node.hpp"

namespace hilger::detail {

template <class Problem, class V>
inline constexpr bool has_own_derivatives = requires(Problem const& what, scalar_of<V> const& t, V const& x) {
    at_time{what.lagrangian, t}.expand(x, x);
};
template <class Problem, class V>
using node_derivatives =
    std::conditional_t<is_traced_state<V> and not has_own_derivatives<Problem, V>, traced_node<Problem, V>, asked_node<Problem, V>>;

} // namespace hilger::detail
