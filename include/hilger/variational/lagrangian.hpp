// SPDX-License-Identifier: BSL-1.0
// L(q, v), any generic callable. With values it is evaluated; with operators applied to the unknown it is a Lagrangian density, whose
// integral is a discrete action (Cresson-Safi (10), (43)).
#pragma once

#include "hilger/differentiation/derivatives.hpp"
#include "hilger/operator/integral.hpp"
#include "hilger/operator/linear_expression.hpp"

namespace hilger {

/// L(A q, B q): position operator A, velocity operator B.
template <class F, linear_map A, linear_map B>
struct lagrangian_density {
    F function;
    [[no_unique_address]] A position;
    [[no_unique_address]] B velocity;
};

namespace detail {
template <class A, class B>
constexpr auto seen_on_two() {
    return does_not_compile<"a Lagrangian takes position and velocity on one scale, and these live on " + A::name() + " and on " +
                            B::name()>{};
}
} // namespace detail

/// L(q, v) or L(t, q, v), any callable for states of every number type: [](auto const& q, auto const& v) { ... }. Functions have no std::
/// before them, as cos(q). Branches have one type: c ? a : b, or a lambda with -> decltype(q + v). Data read from elsewhere, as through a
/// pointer, must not change during a walk: formulas are kept. The first two components of a vector are q.head(2), or q.template head<2>().
template <class F>
struct lagrangian {
    [[no_unique_address]] F function;

    /// From any callable: lagrangian L{[](auto const& q, auto const& v) { ... }}, or lagrangian L = ...
    constexpr explicit(false) lagrangian(F f) : function(std::move(f)) {}

    /// L(q, v), a number.
    template <class Q, class V>
        requires(not function_expression<Q> and not function_expression<V>)
    constexpr auto operator()(Q const& q, V const& v) const {
        using result = plain_t<decltype(function(q, v))>;
        static_assert(std::constructible_from<result, int>, "a Lagrangian L(q, v) returns a number, and this one returns a vector");
        return result(function(q, v));
    }
    /// L(A[q], B[q]), a density of the unknown q.
    template <symbolic_function Q, symbolic_function V>
    constexpr auto operator()(Q const& q, V const& v) const {
        static_assert(std::same_as<decltype(unknown_of(q)), decltype(unknown_of(v))>,
                      "position and velocity of a Lagrangian come from one unknown");
        auto const a = operator_of(q);
        auto const b = operator_of(v);
        using A = decltype(operator_of(q));
        using B = decltype(operator_of(v));
        if constexpr (not std::same_as<typename A::to, typename B::to>)
            return detail::seen_on_two<typename A::to, typename B::to>();
        else
            return lagrangian_density<F, A, B>{function, a, b};
    }
    /// t -> L(q(t), v(t)) for functions with values.
    template <discrete_function Q, discrete_function V>
    constexpr auto operator()(Q q, V v) const {
        return apply_pointwise(function, std::move(q), std::move(v));
    }
};

} // namespace hilger
