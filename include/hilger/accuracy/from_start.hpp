// SPDX-License-Identifier: BSL-1.0
// A solution to a wanted accuracy instead of a number of steps:
//   auto const x = solve(L, interval{0.0, 50.0}, {.q0 = q, .v0 = v}, accuracy{1e-10});      x.q, x.p, x.steps, x.method, x.error
//   auto const y = solve(with_force(L, f), interval{0.0, 50.0}, {.q0 = q, .v0 = v}, accuracy{.relative = 1e-10});
// T follows the motion (accuracy/adapted_steps.hpp): its steps are short where the motion is fast, and over kinks and jumps of a force. A
// Lagrangian or force that switches in time has a member switching_times(a, b), as formulas in text have: the solution then has points
// there. A pulse much narrower than a thirty-second of the interval may be missed unless the longest step says so. L must have no jumps in
// the state: no derivative shows them.
#pragma once

#include "hilger/accuracy/adapted_solution.hpp"

namespace hilger {

namespace detail {

/// The Galerkin embedding with so many Gauss nodes, as a name that depends on the scalar, so that it is not instantiated by including this
/// header.
template <class S, int Stages>
inline constexpr auto const& gauss_of = galerkin<Stages, gauss>;

/// @throws error::invalid_parameter, error::mismatch
template <class S, class W>
auto checked_start(initial_velocity<W> const& from, accuracy const& goal) {
    static_assert(std::numeric_limits<S>::digits > 0 and not std::numeric_limits<S>::is_exact, "an accuracy is for scalars that round");
    if constexpr (not are_given_states<S, W, W>()) refuse_states<S, W, W>();
    using V = given_state_t<S, W>;
    initial_velocity<V> start{as_state<V>(from.q0), as_state<V>(from.v0)};
    require_same_dimension(start.q0, start.v0, "the initial position and velocity");
    S const size = magnitude(start.q0), least = S(64) * epsilon<S>() * size;
    if (not(goal.wanted >= 0) or not(goal.relative >= 0) or not is_finite(goal.wanted) or not is_finite(goal.relative) or
        not(goal.wanted + goal.relative > 0) or goal.of(size) < least)
        error::raise<error::invalid_parameter>("an accuracy in this scalar is a finite number above 0 and at least ", least,
                                               " (64 epsilon of the size of the position), and not ", goal);
    return start;
}
/// The accuracy over the size of the motion, as far as its start shows it.
template <class S, class V>
S relative_accuracy(accuracy const& goal, interval<S> const& I, initial_velocity<V> const& from) {
    S const size = std::max(S(magnitude(from.q0)), S(magnitude(from.v0) * (I.b - I.a)));
    return size > S(0) ? S(goal.of(size) / size) : S(0);
}
/// use(number of Gauss nodes, name), by the accuracy over the size of the motion. Wide scalars are for many digits: only the embeddings for
/// these are instantiated.
template <class S, class Use>
auto with_gauss_for(S const& ratio, Use const& use) {
    if constexpr (std::is_floating_point_v<S>) {
        if (ratio > S(1e-5)) return use(std::integral_constant<int, 6>{}, "Galerkin, 6 Gauss nodes");
    } else {
        if (ratio < S(1e-18)) return use(std::integral_constant<int, 16>{}, "Galerkin, 16 Gauss nodes");
    }
    return use(std::integral_constant<int, 8>{}, "Galerkin, 8 Gauss nodes");
}

} // namespace detail

/// The motion of L(q, v) or L(t, q, v), or of with_force(L, f), from (q0, v0) over [a, b], by a Galerkin embedding with 6 Gauss nodes down
/// to 1e-5 of the size of the motion, with 8 below, and with 16 below 1e-18 in scalars with more digits than the processor's. @throws
/// error::invalid_parameter where the accuracy is not positive or below 64 epsilon of the position; error::invalid_scale;
/// error::no_convergence, with the accuracy reached; and what steps throw, with the last state
template <class F, class S, class W>
auto solve(F const& L, interval<S> const& I, initial_velocity<W> const& from, detail::given_accuracy const& goal) {
    auto const start = detail::checked_start<S>(from, goal);
    return detail::with_gauss_for(detail::relative_accuracy(goal, I, start), [&]<int Nodes>(std::integral_constant<int, Nodes>,
                                                                                            char const* method) {
        auto const flow = embed(L, galerkin<Nodes, gauss>);
        return detail::solving_in_adapted_steps<Nodes, std::remove_const_t<decltype(flow)>, S, detail::given_state_t<S, W>>(flow, method, I,
                                                                                                                            start, goal)
            .solution();
    });
}
#define HILGER_SOLVE_OF_SIZE(Size)                                                                                                         \
    template <class F, class S>                                                                                                            \
    auto solve(F const& L, interval<S> const& I, detail::velocity_in_braces<S, Size> const& from, detail::given_accuracy const& goal) {    \
        return solve(L, I, from.data(), goal);                                                                                             \
    }
HILGER_FOR_EACH_SIZE(HILGER_SOLVE_OF_SIZE)
#undef HILGER_SOLVE_OF_SIZE

} // namespace hilger
