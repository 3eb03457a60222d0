// SPDX-License-Identifier: BSL-1.0
// A solution to a wanted accuracy instead of a number of steps:
//   auto const x = solve(L, interval{0.0, 50.0}, {.q0 = q, .v0 = v}, accuracy{1e-10});      x.q, x.p, x.steps, x.method, x.error
//   auto const y = solve(with_force(L, f), interval{0.0, 50.0}, {.q0 = q, .v0 = v}, 1e-10);
// The order of the cheapest embedding depends on the accuracy: see the work-precision diagrams of `hilger trade`. Over kinks all methods
// lose their order, and the mid-point embedding, whose steps cost least, takes their place. A Lagrangian or force that switches in time has
// a member switching_times(a, b), as formulas in text have: the solution then has points there. L must have no jumps in the state: no
// derivative shows them.
#pragma once

#include "hilger/integrator/doubling.hpp"

namespace hilger {

/// The cheapest embedding for an accuracy, by the crossings that `hilger trade` measures. The last is for scalars with more digits than the
/// processor's.
enum class cheapest { gauss_1, gauss_4, gauss_8, gauss_16 };
/// The embedding for errors up to `wanted`.
constexpr cheapest cheapest_for(double wanted) {
    if (wanted > 1e-2) return cheapest::gauss_1;
    if (wanted > 1e-5) return cheapest::gauss_4;
    if (wanted > 1e-18) return cheapest::gauss_8;
    return cheapest::gauss_16;
}

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
    if (not(goal.wanted > 0) or not is_finite(goal.wanted) or not(S(64) * epsilon<S>() <= S(goal.wanted)))
        error::raise<error::invalid_parameter>("an accuracy in this scalar is a finite number of at least ", S(64) * epsilon<S>(),
                                               " (64 epsilon), not ", goal.wanted);
    using V = given_state_t<S, W>;
    initial_velocity<V> start{as_state<V>(from.q0), as_state<V>(from.v0)};
    require_same_dimension(start.q0, start.v0, "the initial position and velocity");
    return start;
}

} // namespace detail

/// The motion of L(q, v) or L(t, q, v), or of with_force(L, f), from (q0, v0) over [a, b]. @throws error::invalid_parameter where the
/// accuracy is not positive or below 64 epsilon; error::invalid_scale; error::no_convergence, with the accuracy reached; and what steps
/// throw.
template <class F, class S, class W>
auto solve(F const& L, interval<S> const& I, initial_velocity<W> const& from, detail::given_accuracy const& goal) {
    auto const start = detail::checked_start<S>(from, goal);
    using V = detail::given_state_t<S, W>;
    index_type walked = 0;
    auto const reached = [&](auto const& how, char const* method, int order) {
        auto const flow = embed(L, how);
        detail::solving_by_doubling<std::remove_const_t<decltype(flow)>, S, V> solving(flow, method, order, I, start);
        auto made = solving.reach(goal);
        walked += solving.walked();
        return made;
    };
    auto const run = [&](auto const& how, char const* method, int order) {
        auto made = reached(how, method, order);
        if constexpr (std::is_floating_point_v<S>)
            if (not made) made = reached(mid_point, "mid-point", 2);
        made->evaluated_steps = walked;
        return *std::move(made);
    };
    cheapest const best = cheapest_for(goal.wanted);
    // Wide scalars are for many digits: only the embeddings for these are instantiated.
    if constexpr (std::is_floating_point_v<S>) {
        if (best == cheapest::gauss_1) return run(mid_point, "mid-point", 2);
        if (best == cheapest::gauss_4) return run(detail::gauss_of<S, 4>, "Galerkin, 4 Gauss nodes", 8);
    } else {
        if (best == cheapest::gauss_16) return run(detail::gauss_of<S, 16>, "Galerkin, 16 Gauss nodes", 32);
    }
    return run(detail::gauss_of<S, 8>, "Galerkin, 8 Gauss nodes", 16);
}
#define HILGER_SOLVE_OF_SIZE(Size)                                                                                                         \
    template <class F, class S>                                                                                                            \
    auto solve(F const& L, interval<S> const& I, detail::velocity_in_braces<S, Size> const& from, detail::given_accuracy const& goal) {    \
        return solve(L, I, from.data(), goal);                                                                                             \
    }
HILGER_SOLVE_OF_SIZE(0)
HILGER_SOLVE_OF_SIZE(2)
HILGER_SOLVE_OF_SIZE(3)
HILGER_SOLVE_OF_SIZE(4)
HILGER_SOLVE_OF_SIZE(5)
HILGER_SOLVE_OF_SIZE(6)
HILGER_SOLVE_OF_SIZE(Eigen::Dynamic)
#undef HILGER_SOLVE_OF_SIZE

} // namespace hilger
