// SPDX-License-Identifier: BSL-1.0
// Functions with branches in a formula that has no values to compare, because it is written out: each of them is one operation, and its
// derivative is a choice between derivatives, for a derivative that is not chosen may be infinite.
#pragma once

#include "hilger/differentiation/traced/arithmetic.hpp"

namespace hilger::detail {

/// y where x >= 0, else 0, or y where x < 0, else 0: a value that is not chosen may be infinite.
template <bool OfNegative>
struct choice_traced {
    static constexpr char const* name = OfNegative ? "elsewhere" : "where";
    static constexpr bool commutes = false;
    template <class S>
    static S value(S const& x, S const& y) {
        return x < S(0) ? (OfNegative ? y : S(0)) : S(0) <= x ? (OfNegative ? S(0) : y) : x;
    }
    template <class T>
    static T of(T const& x, T const& y) {
        if (y.is(0)) return y;
        if (x.is_constant()) return (x.value < typename T::scalar_type(0)) == OfNegative ? y : T(0);
        return make_traced<choice_traced>(x, y);
    }
};
/// Of a number and NaN it is NaN.
template <bool Largest>
struct extremum_traced {
    static constexpr char const* name = Largest ? "max" : "min";
    static constexpr bool commutes = false;
    template <class S>
    static S value(S const& x, S const& y) {
        return (Largest ? y < x : x < y) or not(x == x) ? x : y;
    }
};
/// The slope of abs: -1 or 1, and that of 0 is 1.
struct sign_traced {
    static constexpr char const* name = "sign";
    static constexpr bool commutes = false;
    template <class S>
    static S value(S const& x, S const&) {
        return x < S(0) ? S(-1) : S(0) <= x ? S(1) : x;
    }
    template <class T>
    static std::pair<T, T> pull_back(T const&, T const&, T const&, T const&) {
        return {T(0), T(0)};
    }
};
struct abs_traced {
    static constexpr char const* name = "abs";
    static constexpr bool commutes = false;
    template <class S>
    static S value(S const& x, S const&) {
        return x < S(0) ? S(-x) : x;
    }
    template <class T>
    static std::pair<T, T> pull_back(T const& x, T const&, T const&, T const& adjoint) {
        return {adjoint * make_traced<sign_traced>(x), T(0)};
    }
};
/// Calls use(x, is_of_negative, y) for the choices that operation `what` of two operands is the sum of. @returns whether it is one
template <class S, class Use>
bool for_each_choice(traced_operation<S> const* what, traced<S> const& a, traced<S> const& b, Use const& use) {
    bool const is_largest = what == &operation_object<extremum_traced<true>, S>;
    bool const is_second = what == &operation_object<choice_traced<true>, S>;
    if (is_largest or what == &operation_object<extremum_traced<false>, S>) {
        traced<S> const first = is_largest ? a - b : b - a;
        use(first, false, a);
        use(first, true, b);
        return true;
    }
    if (not is_second and what != &operation_object<choice_traced<false>, S>) return false;
    use(a, is_second, b);
    return true;
}

} // namespace hilger::detail
