// SPDX-License-Identifier: BSL-1.0
// Comparisons of traced numbers, and their counterparts in a formula that is written out and has no values to compare: there a function
// with branches is one operation, and its derivative is a choice between derivatives.
#pragma once

#include "hilger/differentiation/traced/arithmetic.hpp"
#include "hilger/error.hpp"

namespace hilger::detail {

/// y if x >= 0, else 0; or y if x < 0, else 0. No product: a value that is not chosen may be infinite.
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
/// max or min; for a number and NaN it is NaN.
template <bool Largest>
struct extremum_traced {
    static constexpr char const* name = Largest ? "max" : "min";
    static constexpr bool commutes = false;
    template <class S>
    static S value(S const& x, S const& y) {
        return (Largest ? y < x : x < y) or not(x == x) ? x : y;
    }
};
/// The slope of abs: -1 or 1, and 1 at 0.
HILGER_OPERATION(sign, "sign", false, x < S(0) ? S(-1) : S(0) <= x ? S(1) : x, 0, 0)
HILGER_OPERATION(abs, "abs", false, x < S(0) ? S(-x) : x, a* make_traced<sign_traced>(x), 0)
/// Calls use(x, is_of_negative, y) for the choices whose sum is the operation `what` of a and b. @returns whether there are any
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

template <class S>
struct pair_of_<traced<S>, traced<S>> {
    using type = traced<S>;
};
/// A comparison, recorded in the graph and for observers (differentiation/branches.hpp).
/// @throws error::no_formula in a formula without values
template <class X, class Y>
    requires is_traced<pair_of<X, Y>>
bool watched(relation how, X const& of, Y const& with) {
    using T = pair_of<X, Y>;
    using S = typename T::scalar_type;
    T const x(of), y(with);
    bool const outcome = holds(how, x.value, y.value);
    if (x.is_constant() and y.is_constant()) return outcome;
    auto& g = *formula_graph<S>::of_this_thread();
    if (not g.has_values)
        error::raise<error::no_formula>(
            "what compares its arguments, by if or otherwise, is not one formula, nor is what iterates, as the "
            "Legendre transform of a Hamiltonian does: constants can be compared, and min, max and abs are formulas");
    int const a = x.place(), b = y.place();
    g.watch(how, a, b, outcome);
    return compared(outcome, ((g[a].on | g[b].on) & on_velocity) != 0);
}
template <bool Largest, class S>
traced<S> written_extremum(std::bool_constant<Largest>, traced<S> const& x, traced<S> const& y) {
    return not x.is_constant() and x.node == y.node ? x : make_traced<extremum_traced<Largest>>(x, y);
}
template <class S>
traced<S> written_abs(traced<S> const& x) {
    return make_traced<abs_traced>(x);
}
template <class S>
traced<S> written_sign(traced<S> const& x) {
    return make_traced<sign_traced>(x);
}

} // namespace hilger::detail
