// SPDX-License-Identifier: BSL-1.0
// The goal of a solution to an accuracy, and its result: functions on a scale that was found, and an estimate of their error.
#pragma once

#include <algorithm>
#include <functional>
#include <stop_token>
#include <type_traits>
#include <utility>
#include <vector>

#include "hilger/error.hpp"
#include "hilger/function/function.hpp"
#include "hilger/step/state.hpp"

namespace hilger {

/// The largest error of a position at any point: `wanted`, in the unit of the position, and `relative` times the largest position; one of
/// them may be 0. In all it is at least 64 epsilon of the largest position.
struct accuracy {
    double wanted = 0;
    /// The longest step of all runs, to resolve short pulses, in the unit of time; 0 for a part of the interval.
    double longest_step = 0;
    /// Throws error::no_convergence when a stop is requested.
    std::stop_token stop = {};
    double relative = 0;

    /// For positions of this size.
    template <class S>
    [[nodiscard]] S of(S const& size) const {
        return S(wanted) + S(relative) * size;
    }
};
inline std::ostream& operator<<(std::ostream& out, accuracy const& goal) {
    if (goal.wanted > 0 or not(goal.relative > 0)) out << round_trip(goal.wanted);
    if (goal.wanted > 0 and goal.relative > 0) out << " + ";
    if (goal.relative > 0) out << round_trip(goal.relative) << " of the largest position";
    return out;
}

namespace detail {
/// An accuracy, given as such or as a number.
struct given_accuracy : accuracy {
    given_accuracy(accuracy goal) : accuracy(std::move(goal)) {}
    template <class Number>
        requires std::is_arithmetic_v<Number> given_accuracy(Number number) : accuracy{static_cast<double>(number)} {}
};
} // namespace detail

namespace detail {
template <class V>
scalar_of<V> largest_position(std::vector<V> const& q) {
    scalar_of<V> found(0);
    for (V const& x : q) found = std::max(found, scalar_of<V>(magnitude(x)));
    return found;
}
/// The largest distance between every j-th position of x and every k-th of y.
template <class V>
scalar_of<V> distance_of_positions(std::vector<V> const& x, std::size_t j, std::vector<V> const& y, std::size_t k) {
    scalar_of<V> found(0);
    for (std::size_t i = 0; i * j < x.size(); ++i) found = std::max(found, scalar_of<V>(magnitude(V(x[i * j] - y[i * k]))));
    return found;
}
} // namespace detail

/// A solution on the scale of its last run, with an estimate of its error.
template <class S, class V, class Function>
struct accurate_solution {
    Function q;         ///< positions, a function on T
    Function p;         ///< momenta there, with an error of their own
    state<S, V> end;    ///< at the end of the interval
    index_type steps;   ///< of T
    char const* method; ///< the embedding that was chosen
    S error;            ///< its distance from a run in longer steps, more than its own error where L is smooth, and no less than the
                        ///< rounding of its largest position, which both runs share - the accuracy where all of them are 0; four
                        ///< times that distance, an estimate, where L has branches or a force jumps
    index_type evaluated_steps;                                      ///< of all runs together
    std::function<state<S, V>(state<S, V> const&, S const&)> onward; ///< from a state on T to a time within the step that begins there

    /// The state at t, as accurate as those at the points; with a history it costs all steps before it. @throws error::outside_domain, and
    /// what steps throw
    [[nodiscard]] state<S, V> operator()(S const& t) const {
        auto const& T = q.root();
        if (not(T.min() <= t) or not(t <= T.max()))
            error::raise<error::outside_domain>(t, " is outside the interval [", T.min(), ", ", T.max(), "]");
        index_type before = 0, after = steps; // in the order of time
        while (after - before > 1) {
            index_type const middle = before + (after - before) / 2;
            (t < T.element(middle) ? after : before) = middle;
        }
        index_type const i = t == T.element(after) ? after : before;
        state<S, V> const at{T.element(i), q[i], p[i]};
        return t == at.t ? at : onward(at, t);
    }
};

} // namespace hilger
