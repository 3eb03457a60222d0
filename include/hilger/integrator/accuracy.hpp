// SPDX-License-Identifier: BSL-1.0
// A solution to a wanted accuracy instead of a number of steps:
//   auto const x = solve(L, interval{0.0, 50.0}, {.q0 = q, .v0 = v}, accuracy{1e-10});      x.q, x.p, x.steps, x.method, x.error
//   auto const y = solve(with_force(L, f), interval{0.0, 50.0}, {.q0 = q, .v0 = v}, 1e-10);
// Which embedding reaches an accuracy at the least cost is a matter of its order: that is what the work-precision diagrams of
// `hilger trade` measure. Over kinks all methods lose their order, and the mid-point embedding, whose steps cost least, takes their place.
// Where a Lagrangian or force switches in time is said by a member switching_times(a, b), as formulas in text have it: the solution then
// has points there. L has no jumps in the state: no derivative sees them.
#pragma once

#include "hilger/integrator/doubling.hpp"

namespace hilger {

/// From which accuracy on an embedding is cheaper than the ones of lower order. `hilger trade` measures where they cross. The last is for
/// scalars of more digits than the processor has.
enum class cheapest { gauss_1, gauss_4, gauss_8, gauss_16 };
constexpr cheapest cheapest_for(double wanted) {
    if (wanted > 1e-2) return cheapest::gauss_1;
    if (wanted > 1e-5) return cheapest::gauss_4;
    if (wanted > 1e-18) return cheapest::gauss_8;
    return cheapest::gauss_16;
}

namespace detail {

/// Galerkin's embedding with so many Gauss nodes, as a name that depends on the scalar: what does not is made where this header is read,
/// by everybody who includes it.
template <class S, int Stages>
inline constexpr auto const& gauss_of = galerkin<Stages, gauss>;

} // namespace detail

/// The motion of L(q, v) or L(t, q, v), or of with_force(L, f), from (q0, v0) over [a, b]. @throws error::invalid_parameter where the
/// scalar cannot hold the accuracy or it is not positive; error::invalid_scale; error::no_convergence, which says how near it came; and
/// what steps throw.
template <class F, class S, class W>
auto solve(F const& L, interval<S> const& I, initial_velocity<W> const& from, detail::given_accuracy const& goal) {
    static_assert(std::numeric_limits<S>::digits > 0 and not std::numeric_limits<S>::is_exact, "an accuracy is for scalars that round");
    if constexpr (not detail::are_given_states<S, W, W>()) detail::refuse_states<S, W, W>();
    if (not(goal.wanted > 0) or not is_finite(goal.wanted) or not(S(64) * epsilon<S>() <= S(goal.wanted)))
        error::raise<error::invalid_parameter>("an accuracy in this scalar is a finite number of at least ", S(64) * epsilon<S>(),
                                               " (64 epsilon), not ", goal.wanted);
    using V = detail::given_state_t<S, W>;
    V const q0 = detail::as_state<V>(from.q0), v0 = detail::as_state<V>(from.v0);
    detail::require_same_dimension(q0, v0, "the initial position and velocity");
    index_type walked = 0;
    auto const reached = [&](auto const& how, char const* method, int order) {
        auto const flow = embed(L, how);
        detail::solving_by_doubling<std::remove_const_t<decltype(flow)>, S, V> solving(flow, method, order, I, {q0, v0});
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
    // Who takes a wide scalar wants many digits: what is compiled there is what is for them.
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
