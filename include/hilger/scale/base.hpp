// SPDX-License-Identifier: BSL-1.0
// The families of points that one time scale T = {t_0 < ... < t_N} generates, as types (Cresson-Safi, definitions 1, 3 and 7):
//   nodes            T
//   between<lambda>  T_lambda   = {(1 - lambda) t_i + lambda t_{i+1}},  T_half is between<1/2>
//   joined<lambda>   T_{o,lambda} = T u T_lambda,                       T_o is joined<1/2>
//   subdivided<d>    T/d, with the d - 1 points that divide each step of T into d equal parts; T/1 is T, and T/2 is T_o
// A domain is a family with points cut off at its ends: T^+ has lost its last point, T^- its first. All of them are computed
// from T when asked; none stores a point.
#pragma once

#include <algorithm>

#include "hilger/fixed_text.hpp"
#include "hilger/scalar.hpp"

namespace hilger {

/// T itself. A family has the number of its last point, its points and its steps, for T with a number of steps.
struct nodes {
    static constexpr auto name() { return fixed_text("T"); }
    static constexpr index_type last(index_type steps) { return steps; }
    template <class Root>
    static constexpr auto point(Root const& T, index_type i) {
        return T.point(i);
    }
    /// The distance from point i to point i + 1.
    template <class Root>
    static constexpr auto step(Root const& T, index_type i) {
        return T.step(i);
    }
    friend constexpr bool operator==(nodes, nodes) = default;
};

namespace detail {
template <class Lambda>
struct lambda_name {
    static constexpr auto name() { return fixed_text("lambda"); }
};
template <int P, int Q>
struct lambda_name<fraction<P, Q>> {
    static constexpr auto name() { return digits<P>() + "/" + digits<Q>(); }
};
template <>
struct lambda_name<fraction<1, 2>> {
    static constexpr auto name() { return fixed_text("half"); }
};
} // namespace detail

/// T_lambda: point i lies in the step from t_i to t_{i+1} (Cresson-Safi, definition 7).
template <class Lambda>
struct between {
    [[no_unique_address]] Lambda lambda{};

    static constexpr auto name() { return fixed_text("T_") + detail::lambda_name<Lambda>::name(); }
    static constexpr index_type last(index_type steps) { return steps - 1; }
    template <class Root>
    constexpr auto point(Root const& T, index_type i) const {
        return T.between(i, lambda);
    }
    template <class Root>
    constexpr auto step(Root const& T, index_type i) const {
        using S = typename Root::scalar_type;
        if constexpr (Root::is_uniform)
            return T.step(i);
        else {
            S const l = lambda.template as<S>();
            return (S(1) - l) * T.step(i) + l * T.step(i + 1);
        }
    }
    friend constexpr bool operator==(between const&, between const&) = default;
};
template <class Base>
inline constexpr bool is_between = false;
template <class Lambda>
inline constexpr bool is_between<between<Lambda>> = true;

/// T_{o,lambda}: point 2i is t_i, and point 2i + 1 is t_{i,lambda} (Cresson-Safi, definition 7).
template <class Lambda>
struct joined {
    [[no_unique_address]] Lambda lambda{};

    static constexpr auto name() {
        if constexpr (std::is_same_v<Lambda, fraction<1, 2>>)
            return fixed_text("T_o");
        else
            return fixed_text("T_{o,") + detail::lambda_name<Lambda>::name() + "}";
    }
    static constexpr index_type last(index_type steps) { return 2 * steps; }
    template <class Root>
    constexpr auto point(Root const& T, index_type j) const {
        return j % 2 == 0 ? T.point(j / 2) : T.between(j / 2, lambda);
    }
    template <class Root>
    constexpr auto step(Root const& T, index_type j) const {
        using S = typename Root::scalar_type;
        S const l = lambda.template as<S>();
        return j % 2 == 0 ? l * T.step(j / 2) : (S(1) - l) * T.step(j / 2);
    }
    friend constexpr bool operator==(joined const&, joined const&) = default;
};

namespace detail {
/// Number d i + m is t_i + m h_i / d.
template <int Parts>
struct parts_of_steps {
    static_assert(Parts >= 3);
    static constexpr int parts = Parts;
    static constexpr auto name() { return fixed_text("T/") + digits<Parts>(); }
    static constexpr auto foot() { return fixed_text("/") + digits<Parts>(); }
    static constexpr index_type last(index_type steps) { return Parts * steps; }
    template <class Root>
    constexpr auto point(Root const& T, index_type j) const {
        using S = typename Root::scalar_type;
        index_type const i = j / Parts, m = j % Parts;
        return m == 0 ? S(T.point(i)) : S(T.point(i) + S(static_cast<long long>(m)) * T.step(i) / S(Parts));
    }
    template <class Root>
    constexpr auto step(Root const& T, index_type j) const {
        using S = typename Root::scalar_type;
        return S(T.step(j / Parts) / S(Parts));
    }
    friend constexpr bool operator==(parts_of_steps, parts_of_steps) = default;
};
template <int Parts>
struct family_of_parts {
    using type = parts_of_steps<Parts>;
};
template <>
struct family_of_parts<1> {
    using type = nodes;
};
template <>
struct family_of_parts<2> {
    using type = joined<fraction<1, 2>>;
};
} // namespace detail

template <int Parts>
using subdivided = typename detail::family_of_parts<Parts>::type;

/// A family of points without its first Front and its last Back points.
template <class Base, int Front = 0, int Back = 0>
struct domain {
    using base_type = Base;
    static constexpr int front = Front;
    static constexpr int back = Back;
    [[no_unique_address]] Base base{};

    static constexpr auto name() {
        if constexpr (Front == 0 and Back == 0)
            return Base::name();
        else
            return Base::name() + "^{" + marks<Back, '+'>() + marks<Front, '-'>() + "}";
    }
    /// Numbers of the first and the last point, counted in the whole family. Empty when last < first.
    template <class Root>
    static constexpr index_type first(Root const&) {
        return Front;
    }
    template <class Root>
    static constexpr index_type last(Root const& T) {
        return Base::last(T.steps()) - Back;
    }
    template <class Root>
    static constexpr index_type size(Root const& T) {
        return std::max<index_type>(last(T) - first(T) + 1, 0);
    }
    friend constexpr bool operator==(domain const&, domain const&) = default;

private:
    template <int Count, char Mark>
    static constexpr auto marks() {
        if constexpr (Count == 0)
            return fixed_text("");
        else
            return fixed_text(Mark == '+' ? "+" : "-") + marks<Count - 1, Mark>();
    }
};

/// The common points of two domains of one family.
template <class Base, int F, int B, int G, int C>
constexpr auto intersect(domain<Base, F, B> const& a, domain<Base, G, C> const&) {
    return domain<Base, std::max(F, G), std::max(B, C)>{a.base};
}

} // namespace hilger
