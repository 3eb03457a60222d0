// SPDX-License-Identifier: BSL-1.0
// Common parts of numbers that carry derivatives, jets and traced ones: their constant operands, and Eigen's traits for vectors of them.
#pragma once

#include <concepts>
#include <type_traits>

#include <Eigen/Core>

namespace hilger {

namespace detail {

/// std::cos and its siblings take plain numbers, which a number with derivatives must not become: they find this conversion, which says so.
/// It is to one type other than S, so that c ? x * x : 0.0 has one type only. Wide scalars have none: Boost asks what converts to them.
template <class S>
struct keeps_its_derivatives {};
template <std::floating_point S>
struct keeps_its_derivatives<S> {
    using Plain = std::conditional_t<std::same_as<S, long double>, float, long double>;
    template <std::same_as<Plain> T>
    constexpr explicit(false) operator T() const {
        static_assert(not std::same_as<T, Plain>,
                      "write sin(q), pow(q, 2), max(q, 0.0) without std:: in a Lagrangian, Hamiltonian or force, and "
                      "auto const& instead of double: derivatives pass through its numbers");
        return T();
    }
#define HILGER_NO_SUCH_FUNCTION(name, instead)                                                                                             \
    friend S name(keeps_its_derivatives const&, auto const&...) {                                                                          \
        static_assert(not std::same_as<S, S>, #name " is none of the functions of numbers with derivatives: write " instead);              \
        return S();                                                                                                                        \
    }
    HILGER_NO_SUCH_FUNCTION(log2, "log(q) / std::log(2.0)")
    HILGER_NO_SUCH_FUNCTION(log10, "log(q) / std::log(10.0)")
    HILGER_NO_SUCH_FUNCTION(exp2, "pow(2.0, q)")
    HILGER_NO_SUCH_FUNCTION(erfc, "1 - erf(q)")
    HILGER_NO_SUCH_FUNCTION(fma, "x * y + z")
    HILGER_NO_SUCH_FUNCTION(fmod, "sin(q) or cos(q) of an angle as it is, from which whole turns need not be taken off")
#undef HILGER_NO_SUCH_FUNCTION
};
template <class X>
concept carries_derivatives = requires {
    typename X::scalar_type;
    requires std::derived_from<X, keeps_its_derivatives<typename X::scalar_type>>;
};

} // namespace detail

/// A constant operand beside a number with derivatives.
template <class C, class S>
concept constant_for = std::constructible_from<S, C> and not detail::carries_derivatives<C>;

namespace detail {

/// Of two operands, one of which may be a constant, the type of both; such pairs have watched(how, x, y).
template <class X, class Y>
struct pair_of_ {};
template <carries_derivatives X, constant_for<typename X::scalar_type> K>
struct pair_of_<X, K> {
    using type = X;
};
template <carries_derivatives X, constant_for<typename X::scalar_type> K>
struct pair_of_<K, X> {
    using type = X;
};
template <class X, class Y>
using pair_of = typename pair_of_<X, Y>::type;
template <class X, class Y>
concept watched_pair = requires {
    typename pair_of<X, Y>;
};

} // namespace detail
} // namespace hilger

// A vector in q beside a vector in v makes a vector in both; beside constants it stays what it is.
template <class X, class Y, class Operation>
    requires(hilger::detail::watched_pair<X, Y> and not std::same_as<X, Y>)
struct Eigen::ScalarBinaryOpTraits<X, Y, Operation> {
    using ReturnType = hilger::detail::pair_of<X, Y>;
};
