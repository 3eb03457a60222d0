// SPDX-License-Identifier: BSL-1.0
// A solution to a wanted accuracy instead of a number of steps:
//   auto const x = solve(L, interval{0.0, 50.0}, {.q0 = q, .v0 = v}, accuracy{1e-10});      x.q, x.steps, x.method, x.error
//   auto const y = solve(with_force(L, f), interval{0.0, 50.0}, {.q0 = q, .v0 = v}, accuracy{1e-10});
// Which embedding reaches an accuracy at the least cost is a matter of its order: that is what the work-precision diagrams of
// `hilger trade` measure. The number of steps is doubled until two solutions agree.
#pragma once

#include "hilger/function/function.hpp"
#include "hilger/integrator/flow.hpp"

namespace hilger {

/// The largest error of a position at any point, in the unit of the position. At least 64 epsilon of the scalar; larger than zero.
struct accuracy {
    double wanted;
};

/// A solution on the scale of its last run, and how good it is.
template <class S, class V, class Function>
struct accurate_solution {
    Function q;                 ///< positions, a function on T
    state<S, V> end;            ///< at the end of the interval
    index_type steps;           ///< of T
    char const* method;         ///< the embedding that was chosen
    S error;                    ///< its distance from the run with half as many steps: more than its own error where L is smooth, and an
                                ///< accident where both runs miss what is narrow, or L has branches
    index_type evaluated_steps; ///< of all runs together
};

/// From which accuracy on an embedding is cheaper than the ones of lower order. `hilger trade` measures where they cross. The last is for
/// scalars of more digits than the processor has.
enum class cheapest { mid_point, gauss_4, gauss_8, gauss_16 };
constexpr cheapest cheapest_for(double wanted) {
    if (wanted > 1e-2) return cheapest::mid_point;
    if (wanted > 1e-5) return cheapest::gauss_4;
    if (wanted > 1e-18) return cheapest::gauss_8;
    return cheapest::gauss_16;
}

namespace detail {

/// Doubles the steps of one flow from `steps` on until two runs agree.
template <class Flow, class S, class V>
auto solve_by_doubling(Flow const& flow, char const* method, interval<S> const& I, V const& q0, V const& p0, accuracy const& goal) {
    using solution_function = decltype(function_on(uniform(I, index_type{1}), std::vector<V>{}));
    using result = accurate_solution<S, V, solution_function>;
    constexpr index_type most = index_type{1} << 24;
    S const wanted = S(goal.wanted);
    std::vector<V> coarse, fine;
    S error(-1);
    index_type walked = 0;
    for (index_type steps = 8; steps <= most; steps *= 2) {
        fine.clear();
        fine.reserve(static_cast<std::size_t>(steps) + 1);
        auto const T = uniform(I, steps);
        state<S, V> end{I.a, q0, p0};
        try {
            auto const path = flow.along(T, q0, p0);
            for (auto const& x : path) {
                fine.push_back(x.q);
                end = x;
            }
        } catch (error::no_convergence const&) { // the steps are too long
            walked += steps;
            coarse.clear();
            continue;
        }
        walked += steps;
        if (not coarse.empty()) {
            S const before = error;
            error = S(0);
            for (std::size_t i = 0; i < coarse.size(); ++i) error = std::max(error, S(magnitude(V(coarse[i] - fine[2 * i]))));
            if (error <= wanted) return result{function_on(T, std::move(fine)), end, steps, method, error, walked};
            // Rounding grows with the number of steps: from there on nothing gets better.
            S const floor = S(1024) * hilger::epsilon<S>() * S(magnitude(end.q));
            if (before > S(0) and not(error < before) and error < floor)
                error::raise<error::no_convergence>("an accuracy of ", goal.wanted, " is not reached in this scalar: with ", steps,
                                                    " steps of ", method, " the solution is within ", error,
                                                    ", and rounding keeps it there; a scalar with more digits gets further");
        }
        std::swap(coarse, fine);
    }
    error::raise<error::no_convergence>("an accuracy of ", goal.wanted, " is not reached with ", most, " steps of ", method,
                                        "; the solution is within ", error, " then");
}

} // namespace detail

/// The motion of L(q, v) or L(t, q, v), or of with_force(L, f), from (q0, v0) over [a, b]. @throws error::invalid_parameter where the
/// scalar cannot hold the accuracy or it is not positive; error::invalid_scale; error::no_convergence, which says how near it came; and
/// what steps throw.
template <class F, class S, class W>
auto solve(F const& L, interval<S> const& I, initial_velocity<W> const& from, accuracy const& goal) {
    static_assert(std::numeric_limits<S>::digits > 0 and not std::numeric_limits<S>::is_exact, "an accuracy is for scalars that round");
    if constexpr (not detail::are_given_states<S, W, W>()) detail::refuse_states<S, W, W>();
    if (not(goal.wanted > 0) or not(S(64) * epsilon<S>() <= S(goal.wanted)))
        error::raise<error::invalid_parameter>("an accuracy in this scalar is at least ", S(64) * epsilon<S>(), " (64 epsilon), not ",
                                               goal.wanted);
    using V = detail::given_state_t<S, W>;
    V const q0 = detail::as_state<V>(from.q0), v0 = detail::as_state<V>(from.v0);
    detail::require_same_dimension(q0, v0, "the initial position and velocity");
    V const p0 = embed(L, mid_point).momentum(I.a, q0, v0);
    auto const run = [&](auto const& how, char const* method) { return detail::solve_by_doubling(embed(L, how), method, I, q0, p0, goal); };
    cheapest const best = cheapest_for(goal.wanted);
    // Who takes a wide scalar wants many digits: what is compiled there is what is for them.
    if constexpr (std::is_floating_point_v<S>) {
        if (best == cheapest::mid_point) return run(mid_point, "mid-point");
        if (best == cheapest::gauss_4) return run(galerkin<4, gauss>, "Galerkin, 4 Gauss nodes");
    } else {
        if (best == cheapest::gauss_16) return run(galerkin<16, gauss>, "Galerkin, 16 Gauss nodes");
    }
    return run(galerkin<8, gauss>, "Galerkin, 8 Gauss nodes");
}
template <class F, class S>
auto solve(F const& L, interval<S> const& I, detail::velocity_in_braces<S, 0> const& from, accuracy const& goal) {
    return solve(L, I, from.data(), goal);
}
template <class F, class S>
auto solve(F const& L, interval<S> const& I, detail::velocity_in_braces<S, 2> const& from, accuracy const& goal) {
    return solve(L, I, from.data(), goal);
}
template <class F, class S>
auto solve(F const& L, interval<S> const& I, detail::velocity_in_braces<S, 3> const& from, accuracy const& goal) {
    return solve(L, I, from.data(), goal);
}
template <class F, class S>
auto solve(F const& L, interval<S> const& I, detail::velocity_in_braces<S, 4> const& from, accuracy const& goal) {
    return solve(L, I, from.data(), goal);
}
template <class F, class S>
auto solve(F const& L, interval<S> const& I, detail::velocity_in_braces<S, 5> const& from, accuracy const& goal) {
    return solve(L, I, from.data(), goal);
}
template <class F, class S>
auto solve(F const& L, interval<S> const& I, detail::velocity_in_braces<S, 6> const& from, accuracy const& goal) {
    return solve(L, I, from.data(), goal);
}
template <class F, class S>
auto solve(F const& L, interval<S> const& I, detail::velocity_in_braces<S, Eigen::Dynamic> const& from, accuracy const& goal) {
    return solve(L, I, from.data(), goal);
}

} // namespace hilger
