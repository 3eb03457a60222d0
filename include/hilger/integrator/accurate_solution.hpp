// SPDX-License-Identifier: BSL-1.0
// What is asked of a solution to an accuracy, and what it is: functions on a scale that was found, and an estimate of their error.
#pragma once

#include <functional>
#include <stop_token>
#include <type_traits>
#include <utility>

#include "hilger/function/function.hpp"
#include "hilger/step/state.hpp"

namespace hilger {

/// The largest error of a position at any point, in the unit of the position. At least 64 epsilon of the scalar; larger than zero.
struct accuracy {
    double wanted;
    /// No run has longer steps than this: a pulse that is shorter than all of them would be missed by all. Zero: eight steps to begin with.
    double longest_step = 0;
    /// Who asks it to stop gets an error::no_convergence.
    std::stop_token stop = {};
};

namespace detail {
/// The same as it is given, or its number alone.
struct given_accuracy : accuracy {
    given_accuracy(accuracy goal) : accuracy(std::move(goal)) {}
    template <class Number>
        requires std::is_arithmetic_v<Number> given_accuracy(Number number) : accuracy{static_cast<double>(number)} {}
};
} // namespace detail

/// A solution on the scale of its last run, and how good it is.
template <class S, class V, class Function>
struct accurate_solution {
    Function q;                 ///< positions, a function on T
    Function p;                 ///< momenta there; their error is another one
    state<S, V> end;            ///< at the end of the interval
    index_type steps;           ///< of T
    char const* method;         ///< the embedding that was chosen
    S error;                    ///< its distance from the run with half as many steps, more than its own error where L is smooth, and no
                                ///< less than the rounding of its largest position, which both runs share - the accuracy where all of them
                                ///< are 0; elsewhere four times the largest distance from five other runs, or more
    index_type evaluated_steps; ///< of all runs together
    std::function<state<S, V>(state<S, V> const&, S const&)> onward; ///< a state on T led to a time within the step that it begins

    /// The state at t, as good as those at the points, or with a history within h^4 of them. @throws error::outside_domain, and what steps
    /// throw
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
