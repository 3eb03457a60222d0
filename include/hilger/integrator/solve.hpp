// SPDX-License-Identifier: BSL-1.0
// A discrete Euler-Lagrange equation solved on its scale: from initial data, or from both ends, to the function x in C(T).
#pragma once

#include "hilger/function/function.hpp"
#include "hilger/integrator/flow.hpp"
#include "hilger/integrator/inner_points.hpp"
#include "hilger/integrator/march.hpp"
#include "hilger/integrator/solve_rows.hpp"
#include "hilger/integrator/two_ends.hpp"

namespace hilger {

namespace detail {

/// Boundary values as states over times S. @throws error::mismatch, error::not_finite
template <class S, class V>
auto given_ends(boundary_values<V> const& ends) {
    if constexpr (not are_given_states<S, V, V>()) refuse_states<S, V, V>();
    using State = given_state_t<S, V>;
    boundary_values<State> const given{as_state<State>(ends.q0), as_state<State>(ends.qN)};
    require_same_dimension(given.q0, given.qN, "the boundary values");
    if (not all_finite(given.q0) or not all_finite(given.qN)) error::raise<error::not_finite>("the boundary values are finite");
    return given;
}
/// The default first guess.
struct straight_line {};
/// Puts straight lines between the values at the points of T, with `parts` values a step.
template <class Root, class V>
void put_first_guess_inside(Root const& T, std::vector<V>& x, index_type parts) {
    for (index_type i = 0; parts > 1 and i < T.steps(); ++i) put_straight_line(x, parts * i + 1, parts * (i + 1));
}
/// Puts the first guess into the interior values of `x`. @throws error::mismatch where it lives on another T
template <class Root, class V>
void put_first_guess(Root const& T, std::vector<V>& x, index_type parts, straight_line) {
    using S = scalar_of<V>;
    V const first = x.front(), displacement = x.back() - first;
    S const start(T.point(0)), length(T.point(T.steps()) - T.point(0));
    for (index_type i = 1; i < T.steps(); ++i) {
        S const share = Root::is_uniform ? S(S(i) / S(T.steps())) : S(S(T.point(i) - start) / length);
        x[static_cast<std::size_t>(parts * i)] = first + displacement * share;
    }
    put_first_guess_inside(T, x, parts);
}
template <class Root, class V, discrete_function Guess>
void put_first_guess(Root const& T, std::vector<V>& x, index_type parts, Guess const& guess) {
    static_assert(std::same_as<typename Guess::domain_type, domain<nodes>> and std::same_as<typename Guess::root_type, Root>,
                  "a first guess is a function on the T of the equation: function_on(T, [](auto const& t) { return ...; })");
    if (not T.same_points(guess.root()))
        error::raise<error::mismatch>("a first guess is a function on ", T, ", and this one lives on ", guess.scale());
    auto const at = [&](index_type i) -> V& { return x[static_cast<std::size_t>(parts * i)]; };
    for (index_type i = 1; i < T.steps(); ++i) {
        at(i) = as_state<V>(guess.get(i));
        require_same_dimension(at(i), x[0], "a first guess and the boundary values");
    }
    put_first_guess_inside(T, x, parts);
}
/// From this number of steps on the solution on every eighth point is the first guess, and searches end there.
inline constexpr index_type many_steps = 256;
/// Solves the equation of a flow for the inner ones of x, its values at all points, near them. A search on few of `steps` points may take
/// as long as some iterations on all of them. @returns their response to the ends
template <class Flow, class Root, class V>
scalar_of<V> solve_near(Flow const& flow, Root const& T, std::vector<V>& x, bool is_straight, index_type steps,
                        std::stop_token const& stop) {
    constexpr index_type parts = controls_of<std::remove_cvref_t<decltype(flow.embedding())>> - 1;
    auto const rows = [&](search how, index_type work) {
        auto line = x;
        put_first_guess(T, line, parts, straight_line{});
        return solve_rows(flow, T, x, 0, T.steps(), "the equation between the ends of T", how, static_cast<int>(work), line, by_the_ends,
                          stop);
    };
    if (T.steps() < many_steps or std::numeric_limits<scalar_of<V>>::is_exact)
        return rows(search::everywhere, T.steps() == steps ? much_work : std::max<index_type>(2000, 40 * steps / T.steps()));
    auto const guess = x;
    Root const other = coarsened(coarsened(coarsened(T)));
    auto const from_guess = [&] {
        x = guess;
        return rows(search::nearby, little_work);
    };
    auto const from_every_eighth_point = [&] {
        auto y = on_straight_lines(T, guess, parts, other);
        put_first_guess_inside(other, y, parts);
        solve_near(flow, other, y, is_straight, steps, stop);
        x = on_straight_lines(other, y, parts, T);
        put_first_guess_inside(T, x, parts);
        return rows(search::nearby, little_work);
    };
    try {
        return is_straight ? from_every_eighth_point() : from_guess();
    } catch (error::exception const&) {
        stop_on_request(stop, "the equation between the ends of T");
        if (is_straight and many_steps <= other.steps()) throw; // it was sought on many points
    }
    return is_straight ? from_guess() : from_every_eighth_point();
}
/// The values at all points of the solution of a flow's equation between two ends. @throws as solve below
template <class Flow, class Root, class V, class Guess>
auto solve_between(Flow const& flow, Root const& T, boundary_values<V> const& ends, Guess const& guess, std::stop_token const& stop,
                   ends_report<typename Root::scalar_type>* report) {
    using S = typename Root::scalar_type;
    auto const [q0, qN] = given_ends<S>(ends);
    using State = std::remove_cvref_t<decltype(q0)>;
    constexpr index_type parts = controls_of<std::remove_cvref_t<decltype(flow.embedding())>> - 1;
    std::vector<State> x(static_cast<std::size_t>(parts * T.steps() + 1), q0);
    x.back() = qN;
    if (x.size() < 3) return x;
    put_first_guess(T, x, parts, guess);
    if constexpr (not std::numeric_limits<S>::is_exact) require_regular(derivatives_at_nodes(flow.mechanics()), T, x, parts);
    ends_report<S> seen;
    judge_response(solve_near(flow, T, x, std::same_as<Guess, straight_line>, T.steps(), stop), seen);
    if constexpr (not std::numeric_limits<S>::is_exact)
        if (report != nullptr)
            compare_with_coarser(
                T, x, parts,
                [&](auto const& scale, std::vector<State>& values) {
                    put_first_guess_inside(scale, values, parts);
                    solve_rows(flow, scale, values, 0, scale.steps(), "the equation between the ends of T", search::nearby, little_work,
                               values, by_the_ends, stop);
                },
                seen);
    if (report != nullptr) *report = seen;
    return x;
}

} // namespace detail

/// The solution with q(a) = q0 and p(a) = dL/dv(q0, v0) or p0, or with the first two values q0 and q1: a function on T. Data are numbers or
/// vectors, in braces with names or typed: solve(EL, T, {.q0 = 1.0, .v0 = 0.0}), solve(EL, T, initial_velocity{x, v}). With a force f(q, v)
/// or f(t, q, v) beside dL/dq: solve(EL, T, {.q0 = 1.0, .v0 = 0.0}, f). Where the equation has points inside the steps, the function has
/// values there too.
/// @throws as flow::along does; a failed step says where the solution ends.
template <class Action, initial_data Data, class Force = no_force>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, Data const& from, Force const& force = {}) {
    return detail::positions_along(equation, T, flow_of(equation, force).along(T, from));
}
/// The solution with q(a) = q0 and q(b) = qN, of an equation that reaches over one step, by Newton's method for all points at once: a
/// function on T, and inside its steps where the equation has points there. solve(EL, T, {.q0 = 0.0, .qN = 1.0}), or boundary_values{x, y},
/// in O(N). Forces as above. The first guess is the straight line, or a function on T, whose values at the ends are ignored: solve(EL, T,
/// ends, no_force{}, guess). From 256 steps on the solution on every eighth point comes first, and a search that finds nothing ends there;
/// only a given guess is tried on T at once. Of several solutions one near the guess is sought (hilger/newton/newton.hpp), and mostly
/// found; to find a certain one, start from the solution of a slightly different problem. Throws no_convergence when `stop` is requested. A
/// `report` receives the response of the solution to its ends and its distance from the solutions on every second and fourth point, at half
/// the cost again, and a warning where either suggests that it may be near no motion (integrator/two_ends.hpp).
/// @throws newton_failure, an error::no_convergence, where nothing solves the equation to the rounding of its terms; error::singular and
///         error::ill_conditioned where the ends do not determine the solution, as half a period of an oscillator; error::not_finite where
///         L is singular at an end or on the first guess; error::mismatch
template <class Action, class V, class Force, class Guess>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, boundary_values<V> const& ends, Force const& force,
           Guess const& guess, std::stop_token const& stop = {}, ends_report<typename Action::root_type::scalar_type>* report = nullptr) {
    using EL = euler_lagrange<Action>;
    using Base = typename Action::position_type::from;
    constexpr bool one_step = -EL::reads.on_T.first == 2 and EL::reads.on_T.last == 2;
    static_assert(EL::reads.is_local(), "of the equations that look to both ends of T those are solved, without a force and a first guess, "
                                        "whose action is the nabla integral of "
                                        "L(q, Delta_minus(alpha)[q]) on a uniform T (hilger/boundary/solve.hpp)");
    static_assert(
        one_step,
        "the first and the last value determine the solution of an equation that reaches over one step, and this one reaches over "
        "more, or over none");
    if constexpr (EL::reads.is_local() and one_step) // a refused equation need not be instantiated
        return function_on(derived_scale(T, domain<Base>{}), detail::solve_between(flow_of(equation, force), T, ends, guess, stop, report));
}
template <class Action, class V, class Force = no_force>
auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T, boundary_values<V> const& ends,
           Force const& force = {}) {
    return solve(equation, T, ends, force, detail::straight_line{});
}
/// For each kind of data in braces. `more` is a force, and between two ends a first guess.
#define HILGER_SOLVE_OF_SIZE(Size)                                                                                                         \
    template <class Action, class... More>                                                                                                 \
    auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T,                                                \
               detail::velocity_in_braces<typename Action::root_type::scalar_type, Size> const& from, More const&... more) {               \
        return solve(equation, T, from.data(), more...);                                                                                   \
    }                                                                                                                                      \
    template <class Action, class... More>                                                                                                 \
    auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T,                                                \
               detail::momentum_in_braces<typename Action::root_type::scalar_type, Size> const& from, More const&... more) {               \
        return solve(equation, T, from.data(), more...);                                                                                   \
    }                                                                                                                                      \
    template <class Action, class... More>                                                                                                 \
    auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T,                                                \
               detail::positions_in_braces<typename Action::root_type::scalar_type, Size> const& from, More const&... more) {              \
        return solve(equation, T, from.data(), more...);                                                                                   \
    }                                                                                                                                      \
    template <class Action, class... More>                                                                                                 \
    auto solve(euler_lagrange<Action> const& equation, typename Action::root_type const& T,                                                \
               detail::ends_in_braces<typename Action::root_type::scalar_type, Size> const& from, More const&... more) {                   \
        return solve(equation, T, from.data(), more...);                                                                                   \
    }
HILGER_FOR_EACH_SIZE(HILGER_SOLVE_OF_SIZE)
#undef HILGER_SOLVE_OF_SIZE

template <class Action, class Derived>
auto solve(euler_lagrange<Action> const&, scale_interface<Derived> const&, detail::anything_in_braces const&, auto const&...) {
    return detail::not_initial_data<Derived>();
}
template <class Action, class Derived>
auto solve(euler_lagrange<Action> const&, scale_interface<Derived> const&, detail::any_ends_in_braces const&, auto const&...) {
    return detail::not_initial_data<Derived>();
}

/// Refused: a method has no equation to solve here.
template <class Method, class Derived>
    requires std::derived_from<Method, stepping<Method>>
auto solve(Method const&, scale_interface<Derived> const&, detail::anything_in_braces const&) {
    static_assert(not std::same_as<Method, Method>,
                  "solve takes an equation, variation(S), and this is a method: method.along(T, {.q0 = ..., .v0 = ...}) steps it");
    return 0;
}
template <class L, class Derived>
    requires(not std::derived_from<L, stepping<L>> and not requires(L const& l) { l.action(); })
auto solve(L const&, scale_interface<Derived> const&, detail::anything_in_braces const&) {
    static_assert(not std::same_as<L, L>,
                  "solve takes an equation, variation(S), or a Lagrangian with an interval and an accuracy: embed(L, mid_point).along(T, "
                  "{.q0 = ..., .v0 = ...}) steps a Lagrangian along T");
    return 0;
}

} // namespace hilger
