// SPDX-License-Identifier: BSL-1.0
// A solution to a wanted accuracy (accuracy/from_start.hpp) with fractional damping:
//   auto const x = solve(with_fractional_damping(L, rho, fraction<1, 2>{}), interval{0.0, 50.0}, {.q0 = q, .v0 = v}, accuracy{1e-12});
// by the damping at Radau's nodes (fractional/stages.hpp) on a T that is graded at its start, and behind the times where a callable
// switches: there the solution begins like a broken power. It is the motion of the differential equation, with whatever generating function
// and history the damping is given.
#pragma once

#include <vector>

#include "hilger/accuracy/doubling.hpp"
#include "hilger/accuracy/from_start.hpp"
#include "hilger/fractional/flow.hpp"

namespace hilger {

namespace detail {

/// With the dampings as powers of Delta; a tolerance of 0 means histories to rounding.
template <class L, generating_function G, class Rho, class Order, class Policy>
auto with_powers(damped_problem<L, mean_over_step<fractional_damping<G, Rho, Order, Policy>>> const& given, double tolerance) {
    std::vector<fractional_damping<grunwald_letnikov, Rho, Order, exponentials>> dampings;
    for (auto const& d : given.damping.dampings) dampings.push_back({d.coefficient, d.order, {tolerance}, d.history});
    return damped_by_mean(given.mechanics, std::move(dampings));
}
template <class S, int Stages>
inline constexpr auto const& radau_of = galerkin<Stages, radau>;

} // namespace detail

/// The motion of L with fractional damping from (q0, v0) over [a, b]. @throws as without damping
template <class L, class Damping, class S, class W>
auto solve(damped_problem<L, mean_over_step<Damping>> const& damped, interval<S> const& I, initial_velocity<W> const& from,
           detail::given_accuracy const& goal) {
    auto const start = detail::checked_start<S>(from, goal);
    S const ratio = detail::relative_accuracy(goal, I, start);
    auto const run = [&](auto const& how, char const* method, int order) {
        // Many digits are not had for nothing.
        double const tolerance = std::is_floating_point_v<S> or ratio < S(1 << 20) * epsilon<S>() ? 0 : static_cast<double>(ratio) / 1024;
        auto const flow = embed(detail::with_powers(damped, tolerance), how);
        return detail::solving_by_doubling<std::remove_const_t<decltype(flow)>, S, detail::given_state_t<S, W>>(flow, method, order, I,
                                                                                                                start)
            .reach(goal);
    };
    if constexpr (std::is_floating_point_v<S>) // as fast at 1e-8, where more stages take fewer steps and a longer start
        return ratio > S(1e-8) ? run(detail::radau_of<S, 3>, "Galerkin, 3 Radau nodes", 5)
                               : run(detail::radau_of<S, 5>, "Galerkin, 5 Radau nodes", 9);
    else
        return run(detail::radau_of<S, 8>, "Galerkin, 8 Radau nodes", 15);
}

/// Refused: impulses at the points have no other order than one.
template <class L, class Reading, class S, class W>
auto solve(damped_problem<L, Reading> const&, interval<S> const&, initial_velocity<W> const&, detail::given_accuracy const&) {
    return does_not_compile<"with a memory an accuracy is for with_fractional_damping, and not for impulses", L>{};
}

} // namespace hilger
