// SPDX-License-Identifier: BSL-1.0
// When a Newton iteration for a step is done, and what is said when it is not. Convergence is quadratic: a correction of relative size
// sqrt(epsilon) leaves an error of size epsilon, so the last correction is applied and not evaluated again.
#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <utility>

#include "hilger/inlining.hpp"
#include "hilger/linear/regular.hpp"
#include "hilger/shape.hpp"

namespace hilger {

/// A Newton iteration that failed: how far it came.
template <class V, class Cause = error::no_convergence>
class newton_failure : public Cause {
    // Exceptions are aligned to 16 bytes at least, and registers of AVX want 32: the values lie elsewhere.
    std::shared_ptr<std::pair<V, V> const> kept_;

public:
    newton_failure(std::string const& what, V last, V rest)
        : Cause(what), kept_(std::make_shared<std::pair<V, V> const>(std::move(last), std::move(rest))), iterate(kept_->first),
          residual(kept_->second) {}
    V const& iterate;
    V const& residual;
};

namespace detail {

/// An exact scalar reaches the root of a linear equation at once; of another one its digits would double each time.
template <class S>
inline constexpr int most_iterations = std::numeric_limits<S>::is_exact ? 4 : 30;

/// Whether the root that Newton's method came to is the one near what the step before was solved for: after more than two rounds, if it is
/// no further from that than twice what one of the last two steps has changed; of a first step, if there were less than five rounds. Any
/// other is looked for again from the last velocity (newton/newton.hpp), which may lead to the same one: an extrapolated guess may lie in
/// the reach of a root far away.
template <class S>
HILGER_ALWAYS_INLINE inline bool is_near(int iteration, long long known, S const& change, S const& last_change, S const& change_before) {
    if (iteration < 2) return true;
    if (known < 2) return iteration < 4;
    return change <= S(2) * last_change or (known > 2 and change <= S(2) * change_before);
}

/// The polynomial through n equidistant values, the latest number 0, is sum_i extrapolation(n, i) value_i one step further.
constexpr int extrapolation(int n, int i) {
    int binomial = 1; // n over i + 1
    for (int k = 0; k <= i; ++k) binomial = binomial * (n - k) / (k + 1);
    return i % 2 == 0 ? binomial : -binomial;
}

template <class S>
HILGER_ALWAYS_INLINE inline S square_root_of_epsilon() {
    using std::sqrt;
    if constexpr (std::numeric_limits<S>::is_exact)
        return S(0);
    else if constexpr (std::is_same_v<S, double>)
        return 1.4901161193847656e-08;
    else
        return S(sqrt(epsilon<S>()));
}

/// Why the derivative of an equation is regular, what helps where its root is not found, and what where there are no numbers on the way.
struct solvability {
    char const *regular, *advice;
    char const* around = "";
};
inline constexpr solvability by_the_velocity{"the second derivative of L by the velocity must be invertible, and those by q finite",
                                             "A smaller step h brings the guess closer"};
inline constexpr solvability by_the_ends{
    "the two ends must determine what lies between them, as they do not where they are half a period of an oscillator apart; nor does an L "
    "without kinetic energy",
    "There may be no solution, or none near the first guess: that is the straight line between the ends where no other one is given",
    ": a first guess nearer to the solution may lead around that"};

[[noreturn]] inline void refuse_singular(std::string const& what, solvability const& by = by_the_velocity) {
    error::raise<error::singular>(what, " has a singular derivative here: ", by.regular);
}

/// How a search for a root ends: lost_between the branches of L, or between two on which there is no root.
enum class newton_outcome { found, singular, not_finite, between, lost, lost_between };

/// Says why there is no root. @throws newton_failure<V> or, at a jump, newton_failure<V, error::no_branch>; error::singular,
/// error::not_finite
template <class V>
[[noreturn, gnu::noinline, gnu::cold]] void throw_newton_failure(std::string const& what, newton_outcome how, V const& iterate,
                                                                 V const& residual, solvability const& by = by_the_velocity) {
    if (how == newton_outcome::singular) refuse_singular(what, by);
    if (how == newton_outcome::not_finite or not all_finite(residual))
        error::raise<error::not_finite>(what, " meets NaN or infinity", by.around);
    if (how == newton_outcome::between)
        throw newton_failure<V, error::no_branch>(
            what +
                " has no solution on any branch of L that was met: where L compares its arguments its derivatives jump, and the branches "
                "on both sides of the jump lead across it. A step that does not meet the jump has one, and so has an L whose "
                "derivatives do not jump",
            iterate, residual);
    std::string const where = how == newton_outcome::lost_between ? " between the branches of L. " : ". ";
    std::string const advice =
        std::numeric_limits<scalar_of<V>>::is_exact ? "An exact scalar needs an equation that is linear in the unknown" : by.advice;
    throw newton_failure<V>(what + " did not converge" + where + advice, iterate, residual);
}

/// Where somebody asked for it, what is looked for is given up.
inline void stop_on_request(std::stop_token const& stop, char const* what) {
    if (stop.stop_requested()) error::raise<error::no_convergence>(what, " was given up on request");
}

} // namespace detail
} // namespace hilger
