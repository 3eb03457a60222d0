// SPDX-License-Identifier: BSL-1.0
// The requirements on scalars and values. This file knows neither Eigen nor Boost: the scalar is a template parameter everywhere.
#pragma once

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error hilger does not support -ffast-math, -Ofast and -fassociative-math, which lose small terms and NaN; -O3 -march=native is supported
#endif

#include <concepts>
#include <cstddef>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>

#include "hilger/inlining.hpp"

namespace hilger {

/// Counts and numbers points; signed, so that "the point before the first" can be said.
using index_type = std::ptrdiff_t;

/// A number type closed under the four operations; the integers are not, their quotients are truncated. Expression templates
/// (Boost.Multiprecision's default) are refused: their results refer to temporaries, and a lambda that returns one dangles. Use et_off, as
/// hilger/multiprecision.hpp does.
template <class S>
concept scalar =
    std::copyable<S> and std::constructible_from<S, int> and not std::numeric_limits<S>::is_integer and requires(S const a, S const b) {
    { a + b } -> std::same_as<S>;
    { a - b } -> std::same_as<S>;
    { a* b } -> std::same_as<S>;
    { a / b } -> std::same_as<S>;
    { -a } -> std::same_as<S>;
    { a == b } -> std::convertible_to<bool>;
};

/// A scalar with an order, as the points of a time scale have.
template <class S>
concept ordered_scalar = scalar<S> and std::totally_ordered<S>;

/// The distance from 1 to the next number; zero for exact types.
template <class S>
constexpr S epsilon() {
    if constexpr (std::numeric_limits<S>::is_specialized and not std::numeric_limits<S>::is_exact)
        return std::numeric_limits<S>::epsilon();
    else
        return S(0);
}

/// The type a value has once evaluated: an Eigen expression becomes the matrix it describes.
template <class V>
struct plain {
    using type = V;
};
template <class V>
    requires requires { typename V::PlainObject; }
struct plain<V> {
    using type = typename V::PlainObject;
};
template <class V>
using plain_t = typename plain<std::remove_cvref_t<V>>::type;

/// The value of an expression, evaluated while its operands are alive.
template <class E>
constexpr plain_t<E> evaluated(E&& expression) {
    return plain_t<E>(std::forward<E>(expression));
}

/// The result of a callable, evaluated in the call: an Eigen expression refers to the arguments, or to copies that the callable took by
/// value, which end with the call.
template <class F, class... X>
HILGER_ALWAYS_INLINE constexpr auto value_from(F const& f, X const&... x) -> plain_t<decltype(f(x...))> {
    return f(x...);
}

/// The type of the values of a function on a scale with points of type S, for results V: integers become S, since the average of 0 and 1 is
/// not 0.
template <class V, class S>
using value_on = std::conditional_t<std::is_integral_v<plain_t<V>>, S, plain_t<V>>;

/// True when x is neither NaN nor infinite, for scalars and Eigen vectors.
template <class V>
constexpr bool is_finite(V const& x) {
    if constexpr (requires { x.allFinite(); }) { // it instantiates three more expressions for each type of vector
        for (index_type j = 0; j < x.cols(); ++j)
            for (index_type i = 0; i < x.rows(); ++i)
                if (not is_finite(x.coeff(i, j))) return false;
        return true;
    } else if constexpr (std::numeric_limits<V>::is_exact)
        return true;
    else
        return x - x == V(0);
}

/// The Euclidean product of two values: a product of scalars, x.dot(y) of vectors.
template <class V, class W>
constexpr auto dot_product(V const& x, W const& y) {
    if constexpr (requires { x.dot(y); })
        return x.dot(y);
    else
        return x * y;
}

/// The largest absolute component of a value.
template <class V>
constexpr auto magnitude(V const& x) {
    if constexpr (requires { x.cwiseAbs().maxCoeff(); })
        return x.size() == 0 ? typename V::Scalar(0) : typename V::Scalar(x.cwiseAbs().maxCoeff());
    else
        return x < V(0) ? V(-x) : V(x);
}

/// A zero of the same shape as x (dynamic vectors carry their length in the value).
template <class V>
constexpr plain_t<V> zero_like(V const& x) {
    return plain_t<V>(x - x);
}

/// A rational constant in the type: exact in every scalar.
template <int Numerator, int Denominator = 1>
struct fraction {
    static_assert(Denominator > 0, "a fraction has a positive denominator");
    static constexpr int numerator = Numerator;
    static constexpr int denominator = Denominator;

    template <class S>
    static constexpr S as() {
        if constexpr (Denominator == 1)
            return S(Numerator);
        else
            return S(Numerator) / S(Denominator);
    }
    friend constexpr bool operator==(fraction, fraction) = default;
};

/// P/Q in lowest terms: the scale at 2/4 is the scale at 1/2.
template <int P, int Q>
    requires(Q > 0)
using reduced = fraction<P / std::gcd(P, Q), Q / std::gcd(P, Q)>;

/// A constant known only at run time.
template <class C>
struct run_time {
    C value;

    template <class S>
    constexpr S as() const {
        return S(value);
    }
    friend constexpr bool operator==(run_time const& a, run_time const& b) { return a.value == b.value; }
};

} // namespace hilger
