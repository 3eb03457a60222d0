// SPDX-License-Identifier: BSL-1.0
// A discrete Euler-Lagrange equation solved on its scale: from initial data to the function x in C(T).
#pragma once

#include "hilger/function/function.hpp"
#include "hilger/integrator/flow.hpp"
#include "hilger/integrator/inner_points.hpp"
#include "hilger/integrator/march.hpp"

namespace hilger {

namespace detail {

template <class Action, class Data>
auto solved(euler_lagrange<Action> const& equation, typename Action::root_type const& T, Data const& from) {
    auto const path = flow_of(equation).along(T, from);
    using V = decltype(std::begin(path)->q);
    std::vector<V> positions;
    positions.reserve(static_cast<std::size_t>(T.size()));
    for (auto const& at : path) positions.push_back(at.q);
    auto x = function_on(T, std::move(positions));
    if constexpr (std::same_as<typename Action::position_type::from, nodes>)
        return x;
    else
        return with_inner_points(equation, x);
}
template <class Action, int Size>
using velocity_on = velocity_in_braces<typename Action::root_type::scalar_type, Size>;
template <class Action, int Size>
using positions_on = positions_in_braces<typename Action::root_type::scalar_type, Size>;

} // namespace detail

/// The solution with q(a) = q0 and p(a) = dL/dv(q0, v0), or with the first two values q0 and q1: a function on T. The data are numbers or
/// vectors, named in braces or not: solve(EL, T, {.q0 = 1.0, .v0 = 0.0}), solve(EL, T, initial_velocity{x, v}). Where the equation has
/// points inside the steps the function lives there too.
/// @throws as flow::along does; a failed step says where the solution ends.
template <class Action, class V>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, initial_velocity<V> const& from) {
    return detail::solved(equation, T, from);
}
template <class Action, class V>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, initial_positions<V> const& from) {
    return detail::solved(equation, T, from);
}
template <class Action>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, detail::velocity_on<Action, 0> const& from) {
    return detail::solved(equation, T, from.data());
}
template <class Action>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, detail::positions_on<Action, 0> const& from) {
    return detail::solved(equation, T, from.data());
}
template <class Action>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, detail::velocity_on<Action, 2> const& from) {
    return detail::solved(equation, T, from.data());
}
template <class Action>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, detail::positions_on<Action, 2> const& from) {
    return detail::solved(equation, T, from.data());
}
template <class Action>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, detail::velocity_on<Action, 3> const& from) {
    return detail::solved(equation, T, from.data());
}
template <class Action>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, detail::positions_on<Action, 3> const& from) {
    return detail::solved(equation, T, from.data());
}
template <class Action>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, detail::velocity_on<Action, 4> const& from) {
    return detail::solved(equation, T, from.data());
}
template <class Action>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, detail::positions_on<Action, 4> const& from) {
    return detail::solved(equation, T, from.data());
}
template <class Action>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, detail::velocity_on<Action, 5> const& from) {
    return detail::solved(equation, T, from.data());
}
template <class Action>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, detail::positions_on<Action, 5> const& from) {
    return detail::solved(equation, T, from.data());
}
template <class Action>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, detail::velocity_on<Action, 6> const& from) {
    return detail::solved(equation, T, from.data());
}
template <class Action>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, detail::positions_on<Action, 6> const& from) {
    return detail::solved(equation, T, from.data());
}
template <class Action>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T,
           detail::velocity_on<Action, Eigen::Dynamic> const& from) {
    return detail::solved(equation, T, from.data());
}
template <class Action>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T,
           detail::positions_on<Action, Eigen::Dynamic> const& from) {
    return detail::solved(equation, T, from.data());
}
template <class Action, class Derived>
auto solve(euler_lagrange<Action> const&, scale_interface<Derived> const&, detail::anything_in_braces const&) {
    return detail::not_initial_data<Derived>();
}
template <class Action, class Derived>
auto solve(euler_lagrange<Action> const&, scale_interface<Derived> const&, detail::any_positions_in_braces const&) {
    return detail::not_initial_data<Derived>();
}

} // namespace hilger
