// SPDX-License-Identifier: BSL-1.0
// Whether something is a Lagrangian, or a force, of states V: checked before a walk begins, so that an error is one sentence. L is called
// here first, with the numbers that carry derivatives: the compiler reports errors inside of L with few lines around them.
#pragma once

#include "hilger/variational/problem.hpp"

namespace hilger::detail {

template <class J, class F, class... X>
inline constexpr bool gives = requires(F const& f, X const&... x) {
    requires std::constructible_from<J, plain_t<decltype(f(x...))>>;
};
/// A callable that is no template takes one type of numbers; Eigen's vectors claim conversions that do not compile.
template <class F>
concept takes_one_type = requires {
    &F::operator();
};
/// Whether F is a Lagrangian of states V at times S.
template <class F, class S, class V>
consteval bool is_lagrangian() {
    using X = typename jets_for<V>::position;
    using Y = typename jets_for<V>::velocity;
    using J = typename jets_for<V>::whole;
    if constexpr (std::is_void_v<F>)
        return true;
    else if constexpr (
        requires(F const& f, V const& x) { f.expand(x, x); } or requires(F const& f, S const& t, V const& x) { f.expand(t, x, x); })
        return true;
    else if constexpr (takes_one_type<F>)
        return false;
    else if constexpr (requires(F const& f, S const& t, X const& x, Y const& y) { f(t, x, y); })
        return gives<J, F, S, X, Y>;
    else if constexpr (requires(F const& f, X const& x, Y const& y) { f(x, y); })
        return gives<J, F, X, Y>;
    else
        return false;
}
template <class Force, class S, class V>
consteval bool is_force() {
    if constexpr (std::same_as<Force, no_force>)
        return true;
    else if constexpr (takes_one_type<Force>)
        return false;
    else {
        using X = typename jets_for<V>::of_force;
        return requires(Force const& f, S const& t, X const& x) { f(t, x, x); }
        or requires(Force const& f, X const& x) { f(x, x); };
    }
}
/// Explains in one sentence why they are not.
template <class F, class Force, class S, class V>
constexpr void refuse_mechanics() {
    using X = typename jets_for<V>::position;
    using Y = typename jets_for<V>::velocity;
    if constexpr (not is_lagrangian<F, S, V>()) {
        constexpr bool takes_states =
            not takes_one_type<F> and (
                                          requires(F const& f, S const& t, X const& x, Y const& y) { f(t, x, y); } or
                                          requires(F const& f, X const& x, Y const& y) { f(x, y); });
        if constexpr (takes_states)
            static_assert(not takes_states, "a Lagrangian L(q, v) returns a number, and this one returns something else, a vector perhaps");
        else {
            constexpr bool time_first = takes_one_type<F> or not requires(F const& f, S const& t, X const& x, Y const& y) { f(x, y, t); };
            static_assert(time_first, "the time stands before the states, L(t, q, v), and this Lagrangian takes it behind them");
            static_assert(not time_first,
                          "a Lagrangian takes two states of any number type, as [](auto const& q, auto const& v) does, or the time before "
                          "them: derivatives pass through it, and through functions without std:: before them, as max(q, 0.0); it is "
                          "const, and so no lambda that is mutable");
        }
    } else {
        using Z = typename jets_for<V>::of_force;
        constexpr bool time_first = takes_one_type<Force> or not requires(Force const& f, S const& t, Z const& x) { f(x, x, t); };
        static_assert(time_first, "the time stands before the states, f(t, q, v), and this force takes it behind them");
        static_assert(not time_first, "a force takes two states of any number type, as [](auto const& q, auto const& v) does, or the time "
                                      "before them: derivatives pass through it");
    }
}
/// The Lagrangian and the force of a method, from its member problem_type; void without one.
template <class Method>
struct mechanics_of {
    using lagrangian = void;
    using force = no_force;
};
template <class Problem>
struct parts_of_problem;
template <class F, class Force>
struct parts_of_problem<problem<F, Force>> {
    using lagrangian = F;
    using force = Force;
};
template <class Method>
    requires requires { typename Method::problem_type; }
struct mechanics_of<Method> : parts_of_problem<typename Method::problem_type> {};

} // namespace hilger::detail
