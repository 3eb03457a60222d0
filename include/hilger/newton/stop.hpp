// SPDX-License-Identifier: BSL-1.0
// Stopping rules of the Newton iteration for a step, and the errors when it fails. Convergence is quadratic: a correction of relative size
// sqrt(epsilon) leaves an error of size epsilon, so the last correction is applied and not evaluated again.
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <stop_token>
#include <string>
#include <utility>

#include "hilger/inlining.hpp"
#include "hilger/linear/regular.hpp"
#include "hilger/shape.hpp"

namespace hilger {

/// A Newton iteration that failed: its last iterate and the residual there, and the error `Cause`.
template <class V, class Cause = error::no_convergence>
class newton_failure : public Cause {
    // Exceptions are aligned to 16 bytes at least, and AVX registers want 32: the values are allocated apart.
    std::shared_ptr<std::pair<V, V> const> kept_;

public:
    newton_failure(std::string const& what, V last, V rest)
        : Cause(what), kept_(std::make_shared<std::pair<V, V> const>(std::move(last), std::move(rest))), iterate(kept_->first),
          residual(kept_->second) {}
    V const& iterate;
    V const& residual;
};

namespace detail {

/// An exact scalar solves a linear equation at once; for others its digits would double each time.
template <class S>
inline constexpr int most_iterations = std::numeric_limits<S>::is_exact ? 4 : 30;

/// Whether Newton's method found the root near that of the previous step: after more than two rounds, if it differs by at most twice one of
/// the last two changes; for a first step, if there were less than five rounds. Any other root is searched for again from the last velocity
/// (newton/newton.hpp), maybe with the same result: an extrapolated guess may be attracted by a root far away.
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

enum class progress { going, done, lost };
/// Stopping rule of a contracting iteration: the remainder is below rounding, or corrections are rounding errors, which do not shrink
/// (Hairer, McLachlan, Razakarivony 2008). The remainder after a correction is the rate times it; the rate is the ratio of two corrections.
template <class S>
class contraction {
public:
    /// `rounding` is one rounding error of the iterate; the remainder may be `small` times that.
    contraction(S rounding, S small) : rounding_(std::move(rounding)), small_(std::move(small)) {}

    /// After a correction of this size. Lost: once settled, the iteration gains less than one binary digit a round.
    progress after(S const& size) {
        ++rounds_;
        if (not is_finite(size)) return progress::lost;
        if (size <= rounding_ * small_) return progress::done;
        if (rounds_ > 1) {
            if (size * (size / previous_) <= rounding_ * small_) return progress::done; // a quotient: squares of small sizes underflow
            if (not(S(2) * size < previous_)) {
                if (is_rounding(size)) return progress::done;
                if (rounds_ > 3) return progress::lost;
            }
        }
        previous_ = size;
        return progress::going;
    }

    /// Whether a correction of this size is a final rounding error.
    [[nodiscard]] bool is_rounding(S const& size) const { return size <= S(64) * rounding_; }

private:
    S rounding_, small_, previous_{0};
    int rounds_ = 0;
};

/// Weighs each component of a correction by that of the solution or, near its zero, by the terms of the residual: their sizes may differ.
template <class Unknown, class S, class Vector>
class weighed_corrections {
    using u = shape<Unknown>;

public:
    explicit weighed_corrections(Vector const& zero) : weight_(zero), per_weight_(zero) {}

    /// `moved` is near the solution; put_sizes(x) sets x to the magnitude of the residual's terms; `factorized` solves.
    template <class PutSizes, class Matrix>
    void weigh(Unknown const& moved, PutSizes const& put_sizes, Matrix& factorized) {
        per_weight_.setZero();
        put_sizes(weight_);
        factorized.solve(weight_);
        S most(0);
        for (int c = 0; c < count(); ++c) {
            S const size = magnitude(u::component(moved, c)), other = magnitude(S(weight_(c)));
            weight_(c) = size < other ? other : size;
            if (most < weight_(c)) most = weight_(c);
        }
        // components at rest have no size, and may move by the rounding of the others
        S const least = epsilon<S>() * most;
        for (int c = 0; c < count(); ++c)
            if (S const w = weight_(c) < least ? least : S(weight_(c)); S(0) < w) per_weight_(c) = S(1) / w;
    }
    [[nodiscard]] S size_of(Vector const& correction) const {
        return count() == 0 ? S(0) : S(correction.cwiseProduct(per_weight_).cwiseAbs().maxCoeff());
    }
    /// Whether Newton's next correction would be rounding: each component of this one is small enough for quadratic convergence.
    [[nodiscard]] bool is_last(Vector const& correction, Unknown const& moved, S const& small) const {
        for (int c = 0; c < count(); ++c) {
            S const size = magnitude(S(correction(c)));
            if (size <= (std::numeric_limits<S>::min)()) continue; // smaller numbers have lost their digits; 0 for exact scalars
            if (not(size <= small * magnitude(u::component(moved, c))) and not(size <= S(8) * epsilon<S>() * weight_(c))) return false;
        }
        return true;
    }

private:
    [[nodiscard]] int count() const { return static_cast<int>(weight_.size()); }
    Vector weight_, per_weight_;
};

/// Counts the steps before a cheaper method is tried again: one after a failure, twice as many after each further one. A motion that is
/// stiff throughout pays for few trials, and one that is stiff for a while, as in an encounter, gets its cheap steps back.
class back_off {
public:
    [[nodiscard]] bool allows() const { return left_ == 0; }
    void has_worked() { next_ = 1; }
    void has_failed() {
        left_ = next_;
        next_ = std::min(2 * next_, 1024);
    }
    /// A step without the cheaper method.
    void passes() { --left_; }
    /// For checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        each("left", left_);
        each("next", next_);
    }

private:
    int left_ = 0, next_ = 1; ///< steps
};

/// When the derivative of an equation is regular, advice for a root that is not found, and for numbers that are not finite.
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

/// Outcome of a root search. between: r jumps over zero between two branches of L; lost_between: lost with branches around.
enum class newton_outcome { found, singular, not_finite, between, lost, lost_between };

/// Reports a failed search. @throws newton_failure<V> or, at a jump, newton_failure<V, error::no_branch>; error::singular,
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

/// @throws error::no_convergence when a stop is requested
inline void stop_on_request(std::stop_token const& stop, char const* what) {
    if (stop.stop_requested()) error::raise<error::no_convergence>(what, " was given up on request");
}

} // namespace detail
} // namespace hilger
