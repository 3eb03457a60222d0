// SPDX-License-Identifier: BSL-1.0
// Forward derivatives: a dual number x + sum_k x_k e_k with e_j e_k = 0 carries N partial derivatives through any generic formula,
// exactly. Nested duals carry second derivatives; dual<dual<S, d>, d> gives a d x d block of mixed ones in one evaluation.
#pragma once

#include <array>
#include <cmath>

#include <Eigen/Core>

#include "hilger/scalar.hpp"

namespace hilger {

template <class S, int N>
struct dual {
    S value{};
    std::array<S, N> partial{};

    constexpr dual() : value(S(0)) { partial.fill(S(0)); }
    template <class C>
        requires std::constructible_from<S, C>
    constexpr explicit(false) dual(C const& constant) : value(constant) { partial.fill(S(0)); }
    /// value + e_k
    static constexpr dual variable(S const& value, int k) {
        dual x(value);
        x.partial[static_cast<std::size_t>(k)] = S(1);
        return x;
    }
    /// g(x) given its value and its derivative there.
    constexpr dual chain(S const& image, S const& slope) const {
        dual y(image);
        for (std::size_t k = 0; k < N; ++k) y.partial[k] = slope * partial[k];
        return y;
    }

    constexpr dual& operator+=(dual const& y) { return *this = *this + y; }
    constexpr dual& operator-=(dual const& y) { return *this = *this - y; }
    constexpr dual& operator*=(dual const& y) { return *this = *this * y; }
    constexpr dual& operator/=(dual const& y) { return *this = *this / y; }
};

template <class T>
struct is_dual : std::false_type {};
template <class S, int N>
struct is_dual<dual<S, N>> : std::true_type {};

/// What may stand beside a dual number as a constant: its own S, and whatever S can be made from.
template <class C, class S>
concept constant_for = std::constructible_from<S, C> and(not is_dual<C>::value or std::same_as<C, S>);

namespace detail {
/// Whole numbers and doubles meet wide scalars exactly as the user wrote them.
template <class S, class C>
constexpr decltype(auto) constant(C const& c) {
    if constexpr (std::is_arithmetic_v<C> and not is_dual<S>::value)
        return S(c);
    else
        return c;
}
} // namespace detail

template <class S, int N>
constexpr dual<S, N> operator+(dual<S, N> x, dual<S, N> const& y) {
    x.value = x.value + y.value;
    for (std::size_t k = 0; k < N; ++k) x.partial[k] = x.partial[k] + y.partial[k];
    return x;
}
template <class S, int N>
constexpr dual<S, N> operator-(dual<S, N> x, dual<S, N> const& y) {
    x.value = x.value - y.value;
    for (std::size_t k = 0; k < N; ++k) x.partial[k] = x.partial[k] - y.partial[k];
    return x;
}
template <class S, int N>
constexpr dual<S, N> operator-(dual<S, N> const& x) {
    return x.chain(-x.value, S(-1));
}
template <class S, int N>
constexpr dual<S, N> operator*(dual<S, N> const& x, dual<S, N> const& y) {
    dual<S, N> z(S(x.value * y.value));
    for (std::size_t k = 0; k < N; ++k) z.partial[k] = x.partial[k] * y.value + x.value * y.partial[k];
    return z;
}
template <class S, int N>
constexpr dual<S, N> operator/(dual<S, N> const& x, dual<S, N> const& y) {
    S const inverse = S(1) / y.value;
    dual<S, N> z(S(x.value * inverse));
    for (std::size_t k = 0; k < N; ++k) z.partial[k] = (x.partial[k] - z.value * y.partial[k]) * inverse;
    return z;
}

template <class S, int N, constant_for<S> C>
constexpr dual<S, N> operator+(dual<S, N> x, C const& c) {
    x.value = x.value + detail::constant<S>(c);
    return x;
}
template <class S, int N, constant_for<S> C>
constexpr dual<S, N> operator+(C const& c, dual<S, N> x) {
    x.value = detail::constant<S>(c) + x.value;
    return x;
}
template <class S, int N, constant_for<S> C>
constexpr dual<S, N> operator-(dual<S, N> x, C const& c) {
    x.value = x.value - detail::constant<S>(c);
    return x;
}
template <class S, int N, constant_for<S> C>
constexpr dual<S, N> operator-(C const& c, dual<S, N> const& x) {
    return -x + c;
}
template <class S, int N, constant_for<S> C>
constexpr dual<S, N> operator*(dual<S, N> x, C const& c) {
    decltype(auto) factor = detail::constant<S>(c);
    x.value = x.value * factor;
    for (auto& d : x.partial) d = d * factor;
    return x;
}
template <class S, int N, constant_for<S> C>
constexpr dual<S, N> operator*(C const& c, dual<S, N> x) {
    return std::move(x) * c;
}
template <class S, int N, constant_for<S> C>
constexpr dual<S, N> operator/(dual<S, N> x, C const& c) {
    decltype(auto) divisor = detail::constant<S>(c);
    x.value = x.value / divisor;
    for (auto& d : x.partial) d = d / divisor;
    return x;
}
template <class S, int N, constant_for<S> C>
constexpr dual<S, N> operator/(C const& c, dual<S, N> const& x) {
    S const inverse = S(1) / x.value;
    S const image = inverse * detail::constant<S>(c);
    return x.chain(image, -image * inverse);
}

/// Comparisons look at values, so that branches and pivots work.
template <class S, int N>
constexpr bool operator==(dual<S, N> const& x, dual<S, N> const& y) {
    return x.value == y.value;
}
template <class S, int N>
constexpr bool operator<(dual<S, N> const& x, dual<S, N> const& y) {
    return x.value < y.value;
}
template <class S, int N>
constexpr bool operator>(dual<S, N> const& x, dual<S, N> const& y) {
    return y < x;
}
template <class S, int N>
constexpr bool operator<=(dual<S, N> const& x, dual<S, N> const& y) {
    return not(y < x);
}
template <class S, int N>
constexpr bool operator>=(dual<S, N> const& x, dual<S, N> const& y) {
    return not(x < y);
}

template <class S, int N>
dual<S, N> sin(dual<S, N> const& x) {
    using std::cos, std::sin;
    return x.chain(sin(x.value), cos(x.value));
}
template <class S, int N>
dual<S, N> cos(dual<S, N> const& x) {
    using std::cos, std::sin;
    return x.chain(cos(x.value), -sin(x.value));
}
template <class S, int N>
dual<S, N> tan(dual<S, N> const& x) {
    using std::tan;
    S const t = tan(x.value);
    return x.chain(t, S(1) + t * t);
}
template <class S, int N>
dual<S, N> exp(dual<S, N> const& x) {
    using std::exp;
    S const e = exp(x.value);
    return x.chain(e, e);
}
template <class S, int N>
dual<S, N> log(dual<S, N> const& x) {
    using std::log;
    return x.chain(log(x.value), S(1) / x.value);
}
template <class S, int N>
dual<S, N> sqrt(dual<S, N> const& x) {
    using std::sqrt;
    S const root = sqrt(x.value);
    return x.chain(root, S(1) / (root + root));
}
template <class S, int N, constant_for<S> C>
dual<S, N> pow(dual<S, N> const& x, C const& exponent) {
    using std::pow;
    S const e(exponent);
    return x.chain(pow(x.value, e), e * pow(x.value, S(e - S(1))));
}
template <class S, int N>
dual<S, N> abs(dual<S, N> const& x) {
    return x.value < S(0) ? -x : x;
}

} // namespace hilger

namespace Eigen {

template <class S, int N>
struct NumTraits<hilger::dual<S, N>> : NumTraits<S> {
    using Real = hilger::dual<S, N>;
    using NonInteger = Real;
    using Nested = Real;
    using Literal = typename NumTraits<S>::Literal;
    enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1, ReadCost = N + 1, AddCost = N + 1, MulCost = 3 * N + 1 };
};
template <class S, int N, class C, class Operation>
    requires hilger::constant_for<C, S>
struct ScalarBinaryOpTraits<hilger::dual<S, N>, C, Operation> {
    using ReturnType = hilger::dual<S, N>;
};
template <class S, int N, class C, class Operation>
    requires hilger::constant_for<C, S>
struct ScalarBinaryOpTraits<C, hilger::dual<S, N>, Operation> {
    using ReturnType = hilger::dual<S, N>;
};

} // namespace Eigen
