// SPDX-License-Identifier: BSL-1.0
// The operator that a symbolic expression applies to its unknown: operator_of(Delta_o_plus[extend[q]]) is Delta_o_plus * extend.
#pragma once

#include "hilger/function/unknown.hpp"
#include "hilger/operator/compose.hpp"

namespace hilger {

template <text_argument Name, class Base>
constexpr auto operator_of(unknown<Name, Base> const&) {
    if constexpr (std::same_as<Base, nodes>)
        return identity_T;
    else
        return identity_on<Base, natural_weight_t<fraction<1, 2>>>{};
}
/// The operator A in A[q], composed where q is an expression itself.
template <linear_map A, symbolic_function F>
constexpr auto operator_of(applied<A, F> const& expression) {
    if constexpr (requires { F::name(); }) // the unknown itself
        return expression.op;
    else
        return expression.op * operator_of(expression.f);
}

/// The unknown of a symbolic expression.
template <text_argument Name, class Base>
constexpr auto unknown_of(unknown<Name, Base> const& q) {
    return q;
}
template <linear_map A, symbolic_function F>
constexpr auto unknown_of(applied<A, F> const& expression) {
    return unknown_of(expression.f);
}

template <symbolic_function F, symbolic_function G>
constexpr auto operator+(F const& f, G const& g) {
    static_assert(std::same_as<decltype(unknown_of(f)), decltype(unknown_of(g))>, "a linear expression has one unknown");
    return applied(operator_of(f) + operator_of(g), unknown_of(f));
}
template <symbolic_function F, symbolic_function G>
constexpr auto operator-(F const& f, G const& g) {
    static_assert(std::same_as<decltype(unknown_of(f)), decltype(unknown_of(g))>, "a linear expression has one unknown");
    return applied(operator_of(f) - operator_of(g), unknown_of(f));
}
template <factor C, symbolic_function F>
constexpr auto operator*(C const& c, F const& f) {
    return applied(c * operator_of(f), unknown_of(f));
}
template <symbolic_function F, factor C>
constexpr auto operator*(F const& f, C const& c) {
    return applied(c * operator_of(f), unknown_of(f));
}
template <symbolic_function F, factor C>
constexpr auto operator/(F const& f, C const& c) {
    return applied(operator_of(f) / c, unknown_of(f));
}

} // namespace hilger
