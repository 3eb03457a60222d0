// SPDX-License-Identifier: BSL-1.0
// Exact first and second derivatives of a generic formula, by forward evaluation. A jet is a number with its derivatives by the variables
// number First ... First + Count - 1, up to Order 1 or 2. The range is in the type: functions of q alone never touch the variables of v,
// and a product of both lives on both.
//
// Everything is inlined and built in one expression, without loops or lambdas: an optimiser then sees every derivative as a variable of its
// own and drops those that are zero.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "hilger/differentiation/jet/known_numbers.hpp"
#include "hilger/differentiation/numbers.hpp"
#include "hilger/inlining.hpp"

namespace hilger {

/// How a formula depends on q and v: the degree of a polynomial, or `no_polynomial`. Upper bounds that decide what is iterated.
struct dependence {
    static constexpr int no_polynomial = 1000;
    int q = 0, v = 0;
    bool coupled = false; ///< a term has both

    friend constexpr bool operator==(dependence, dependence) = default;
    HILGER_ALWAYS_INLINE constexpr bool on_both() const { return q > 0 and v > 0; }
    HILGER_ALWAYS_INLINE friend constexpr dependence operator+(dependence x, dependence y) {
        return {std::max(x.q, y.q), std::max(x.v, y.v), x.coupled or y.coupled};
    }
    HILGER_ALWAYS_INLINE friend constexpr dependence operator*(dependence x, dependence y) {
        dependence const z{std::min(x.q + y.q, no_polynomial), std::min(x.v + y.v, no_polynomial), false};
        bool const trivial = x == dependence{} or y == dependence{};
        return {z.q, z.v, trivial ? x.coupled or y.coupled : z.on_both()};
    }
    HILGER_ALWAYS_INLINE constexpr dependence of_function() const {
        return {q > 0 ? no_polynomial : 0, v > 0 ? no_polynomial : 0, on_both()};
    }
};

/// A number with its derivatives by the variables First ... First + Count - 1.
template <class S, int First, int Count, int Order>
struct jet : detail::keeps_its_derivatives<S> {
    static_assert(Order == 1 or Order == 2);
    static constexpr int first = First, count = Count, order = Order, last = First + Count - 1;
    static constexpr int packed = Order == 2 ? Count * (Count + 1) / 2 : 0;
    using scalar_type = S;
    using gradient = std::array<S, static_cast<std::size_t>(Count)>;
    using triangle = std::array<S, static_cast<std::size_t>(packed)>;

    // The jet of c g(u): its value, the constant c = factor * power, outer * slope = g'(u), bend = g''(u) and the derivatives of u.
    // Functions of one argument and constant factors change these numbers only; products and sums work the derivatives out. `outer`, the
    // derivative of the last function, is kept apart: the derivatives of u need not wait for it.
    S value{};
    S factor{1};
    S outer{1};
    S slope{1};
    S bend{};
    int power = 1;
    int which = -1; ///< number of the variable u if c g(u) is factor * u^power
    gradient d1{};
    triangle d2{}; ///< rows of the lower triangle
    dependence on{};

    HILGER_ALWAYS_INLINE constexpr jet() = default;
    HILGER_ALWAYS_INLINE constexpr jet(S const& x, gradient const& g, triangle const& t, dependence n) : value(x), d1(g), d2(t), on(n) {}
    template <class C>
    requires std::constructible_from<S, C> HILGER_ALWAYS_INLINE constexpr explicit(false) jet(C const& constant) : value(constant) {}
    /// A jet in fewer variables.
    template <int F, int C>
        requires(F >= First and F + C <= First + Count and C < Count)
    HILGER_ALWAYS_INLINE constexpr explicit(false) jet(jet<S, F, C, Order> const& x);
    /// The variable number `which`, at `value`; one of q or of v.
    HILGER_ALWAYS_INLINE static constexpr jet variable(S const& value, int which, dependence on) {
        jet x(value);
        x.d1[static_cast<std::size_t>(which - First)] = S(1);
        x.on = on;
        x.which = which;
        return x;
    }

    HILGER_ALWAYS_INLINE constexpr S constant() const { return detail::times(factor, S(power)); }

    /// Derivatives of u, then of g(u), then of c g(u), by the variables' numbers, J >= K; zero for variables out of the range.
    template <int J>
    HILGER_ALWAYS_INLINE constexpr S inner() const {
        if constexpr (J < First or J > last)
            return S(0);
        else
            return std::get<static_cast<std::size_t>(J - First)>(d1);
    }
    template <int J, int K>
    HILGER_ALWAYS_INLINE constexpr S inner() const {
        if constexpr (K < First or J > last)
            return S(0);
        else
            return std::get<static_cast<std::size_t>((J - First) * (J - First + 1) / 2 + K - First)>(d2);
    }
    template <int J>
    HILGER_ALWAYS_INLINE constexpr S unscaled() const {
        return detail::times(outer, detail::times(slope, inner<J>()));
    }
    // In this order a bend of zero stays zero even if the square of a large derivative is infinite.
    template <int J, int K>
    HILGER_ALWAYS_INLINE constexpr S unscaled() const {
        if constexpr (K < First or J > last)
            return S(0); // also where others are infinite
        else
            return detail::plus(detail::times(detail::times(outer, slope), inner<J, K>()),
                                detail::times(detail::times(bend, inner<J>()), inner<K>()));
    }
    template <int... JK>
    HILGER_ALWAYS_INLINE constexpr S by() const {
        if constexpr (Order == 1)
            return detail::times(detail::times(detail::times(constant(), slope), outer), inner<JK...>()); // one factor serves all J
        else
            return detail::times(constant(), unscaled<JK...>());
    }

    /// The same for numbers j >= k >= First known at run time only.
    [[nodiscard]] constexpr S derivative(int j) const { return S(constant() * outer) * S(slope * d1[static_cast<std::size_t>(j - First)]); }
    [[nodiscard]] constexpr S derivative(int j, int k) const {
        std::size_t const row = static_cast<std::size_t>(j - First), column = static_cast<std::size_t>(k - First);
        return constant() * S(S(S(outer * slope) * d2[row * (row + 1) / 2 + column]) + S(S(bend * d1[row]) * d1[column]));
    }

    template <class Z>
    HILGER_ALWAYS_INLINE constexpr jet& assigned(Z const& z) {
        constexpr bool is_of_this_type = std::is_same_v<Z, jet>;
        static_assert(is_of_this_type, "L and forces are called with q and v as jets of two types, and what q and v make is of a third: "
                                       "instead of v += q or v = v + q, give the sum a name of its own, auto const w = v + q");
        if constexpr (is_of_this_type) *this = z;
        return *this;
    }
    template <int F, int C>
        requires(not(F >= First and F + C <= First + Count))
    constexpr jet& operator=(jet<S, F, C, Order> const& x) { return assigned(x); }
    template <class Y>
    HILGER_ALWAYS_INLINE constexpr jet& operator+=(Y const& y) {
        return assigned(*this + y);
    }
    template <class Y>
    HILGER_ALWAYS_INLINE constexpr jet& operator-=(Y const& y) {
        return assigned(*this - y);
    }
    template <class Y>
    HILGER_ALWAYS_INLINE constexpr jet& operator*=(Y const& y) {
        return assigned(*this * y);
    }
    template <class Y>
    HILGER_ALWAYS_INLINE constexpr jet& operator/=(Y const& y) {
        return assigned(*this / y);
    }
};

/// Whether T is a jet.
template <class T>
inline constexpr bool is_jet = false;
template <class S, int F, int C, int O>
inline constexpr bool is_jet<jet<S, F, C, O>> = true;

} // namespace hilger
