// SPDX-License-Identifier: BSL-1.0
// A solution to a wanted accuracy, by one method: the number of steps is doubled until two solutions agree, as closely as the order of the
// method says that they should; where they do not, or L has branches, until six do, of which most have their points elsewhere. Between the
// points of its scale the solution is a step of the same embedding, x(t).q, x(t).p; with a history, which such a step has not, the cubic
// polynomial of dense_output.
#pragma once

#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>

#include "hilger/function/function.hpp"
#include "hilger/integrator/flow.hpp"
#include "hilger/trajectory/dense_output.hpp"

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
    S error;                    ///< its distance from the run with half as many steps, more than its own error where L is smooth, down to
                                ///< the rounding that both runs share; elsewhere four times the largest distance from five other runs, or
                                ///< more
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

namespace detail {

/// The number of steps to begin with. @throws error::invalid_parameter
template <class S>
index_type first_steps(interval<S> const& I, double longest, index_type most) {
    index_type steps = 8;
    if (not(longest >= 0)) error::raise<error::invalid_parameter>("the longest step is positive, or 0 for any, and not ", longest);
    if (longest > 0)
        while (steps <= most and static_cast<double>(S(I.b - I.a)) > longest * static_cast<double>(steps)) steps *= 2;
    if (steps > most) error::raise<error::invalid_parameter>("steps of at most ", longest, " are more than ", most, " on this interval");
    return steps;
}

/// Runs of one flow with more and more steps.
template <class Flow, class S, class V>
class solving_by_doubling {
    using solution_function = decltype(function_on(uniform(interval<S>{}, index_type{1}), std::vector<V>{}));
    static constexpr index_type most = index_type{1} << 24;

public:
    using result = accurate_solution<S, V, solution_function>;
    solving_by_doubling(Flow flow, char const* method, int order, interval<S> const& I, initial_velocity<V> start)
        : flow_(std::move(flow)), method_(method), order_(order), I_(I),
          start_(std::move(start)), end_{I_.a, start_.q0, flow_.momentum(I_.a, start_.q0, start_.v0)} {}

    /// Nothing where kinks of L leave of the method's order less than two, so that a step that costs less does as much.
    std::optional<result> reach(accuracy const& goal) {
        S const wanted = S(goal.wanted);
        // What a run wins over the one before where the order of the method says it: of order two a factor of four or nearly so, which two
        // runs have by chance too; of high ones, which few steps do not have yet, half the digits or more.
        bool const is_low = order_ == 2;
        S const gain = is_low ? S(3) : S(std::ldexp(1.0, order_ / 2)) * S(1.25), luck = is_low ? S(5.5) : S(std::ldexp(1.0, order_ + 2));
        std::vector<V> coarse;
        S earlier(-1), before(-1), error(-1), told(-1);
        int slow = 0, late = 0, still = 0, stuck = 0; // comparisons, and runs that ended where the one before did, in a row
        S ended = I_.a;
        for (index_type steps = first_steps(I_, goal.longest_step, most); steps <= most; steps *= 2) {
            branch_watch const watch;
            std::vector<V> momenta, fine = run(steps, goal, &momenta);
            if (goal.stop.stop_requested())
                error::raise<error::no_convergence>("an accuracy of ", goal.wanted, " was given up on request, after ", walked_,
                                                    " steps of ", method_);
            if (fine.empty()) {
                // However short the steps are, they come no further: the motion itself ends there, or its speed is without bound.
                S const length = (I_.b - I_.a) / static_cast<S>(steps);
                stuck = steps >= 1024 and magnitude(S(end_.t - ended)) <= S(8) * magnitude(length) ? stuck + 1 : 0;
                ended = end_.t;
                if (stuck == 3 and failure_) std::rethrow_exception(failure_); // L is not defined there, or has no velocity
                if (stuck == 3)
                    error::raise<error::no_convergence>("an accuracy of ", goal.wanted, " is not reached: steps of ", method_,
                                                        " come no further than t = ", ended, ", however short they are");
            } else if (not coarse.empty()) {
                earlier = std::exchange(before, std::exchange(error, distance(coarse, 1, fine, 2)));
                // Twice in a row, and not by more than the order explains: over jumps in time, which nothing sees, two runs agree by
                // chance.
                auto const follows = [&](S const& coarser, S const& finer) { return gain * finer <= coarser and coarser <= luck * finer; };
                bool const is_third = before >= S(0), may_be_smooth = not watch.saw_any() and is_third and follows(before, error);
                bool const is_smooth = may_be_smooth and not is_low and earlier >= S(0) and follows(earlier, before);
                S const unit = hilger::epsilon<S>() * S(magnitude(end_.q)), floor = S(1024) * unit, lowest = S(1 << 20) * unit;
                told = error;
                if (is_third and error <= wanted and not is_smooth) {
                    told = of_kinks(fine, error, goal);
                    if (not may_be_smooth) told = std::max(before, told);
                }
                if (told <= wanted and is_third) {
                    state<S, V> end = end_;
                    auto const T = uniform(I_, steps);
                    return result{function_on(T, std::move(fine)),
                                  function_on(T, std::move(momenta)),
                                  end,
                                  steps,
                                  method_,
                                  told,
                                  walked_,
                                  onward(steps)};
                }
                bool const is_near = error < largest(fine) / S(64);
                slow = watch.saw_any() and is_third and is_near and before < S(4) * error ? slow + 1 : 0;
                // Of a jump in time, which nothing sees, the error depends on where it is in its step, and so do single gains. What
                // rounding keeps from shrinking is no jump.
                late = earlier >= S(0) and is_near and not(error < lowest) and earlier < S(16) * error ? late + 1 : 0;
                if constexpr (std::is_floating_point_v<S>)
                    if ((slow == 3 or late == 3) and order_ > 2) return std::nullopt;
                // Rounding grows with the number of steps, and where neighbouring motions part it is more than the numbers are: from there
                // on nothing gets better.
                still = before > S(0) and not(S(2) * error < before) ? still + 1 : 0;
                if (wanted < error and ((still > 0 and not(error < before) and error < floor) or (still > 1 and error < lowest)))
                    error::raise<error::no_convergence>("an accuracy of ", goal.wanted, " is not reached in this scalar: with ", steps,
                                                        " steps of ", method_, " the solution is within ", error,
                                                        ", and rounding keeps it there; a scalar with more digits gets further");
            }
            coarse = std::move(fine);
        }
        if (error < S(0))
            error::raise<error::no_convergence>("an accuracy of ", goal.wanted, " is not reached with ", most, " steps of ", method_,
                                                ": they do not come to the end");
        error::raise<error::no_convergence>("an accuracy of ", goal.wanted, " is not reached with ", most, " steps of ", method_,
                                            "; the solution is within ", told, " then");
    }

    /// Steps of all runs together.
    [[nodiscard]] index_type walked() const { return walked_; }

private:
    /// The positions, and the momenta for who wants them; nothing where the steps are too long: they have no solution, or lead to where L
    /// is not defined.
    std::vector<V> run(index_type steps, accuracy const& goal, std::vector<V>* momenta = nullptr) {
        std::vector<V> q;
        q.reserve(static_cast<std::size_t>(steps) + 1);
        walked_ += steps;
        end_.t = I_.a;
        failure_ = {};
        try {
            auto const path = flow_.along(uniform(I_, steps), start_);
            for (auto const& x : path) {
                q.push_back(x.q);
                if (momenta != nullptr) momenta->push_back(x.p);
                end_ = x;
                if (q.size() % 1024 == 0 and goal.stop.stop_requested()) return {};
            }
        } catch (error::no_convergence const&) {
            q.clear();
        } catch (error::not_finite const&) {
            q.clear();
            failure_ = std::current_exception();
        } catch (error::singular const&) {
            q.clear();
            failure_ = std::current_exception();
        }
        return q;
    }
    /// What is short within a step may be long for another start: it is cut into more, then.
    [[nodiscard]] auto onward(index_type all) const {
        if constexpr (has_history<Flow>) {
            struct walked_again {
                std::once_flag once;
                std::optional<dense_output<S, V>> path;
            };
            return [flow = flow_, T = uniform(I_, all), start = start_, kept = std::make_shared<walked_again>()](state<S, V> const&,
                                                                                                                 S const& t) {
                std::call_once(kept->once, [&] { kept->path.emplace(flow.along(T, start)); });
                return (*kept->path)(t);
            };
        } else
            return [flow = flow_](state<S, V> const& from, S const& t) {
                S const unit =
                    std::max(S(hilger::epsilon<S>() * std::max(magnitude(from.t), magnitude(t))), S((std::numeric_limits<S>::min)()));
                if (t - from.t < S(8) * unit) return state<S, V>{t, from.q, from.p}; // no T has so short a step
                for (index_type steps = 1;; steps *= 2) {
                    try {
                        state<S, V> last = from;
                        for (auto const& x : flow.along(uniform(interval<S>{from.t, t}, steps), from.q, from.p)) last = x;
                        return last;
                    } catch (error::no_convergence const&) {
                        if (steps == 8) throw;
                    }
                }
            };
    }
    static S largest(std::vector<V> const& x) {
        S found(0);
        for (V const& q : x) found = std::max(found, S(magnitude(q)));
        return found;
    }
    /// Of every j-th position of x and every k-th of y.
    static S distance(std::vector<V> const& x, std::size_t j, std::vector<V> const& y, std::size_t k) {
        S found(0);
        for (std::size_t i = 0; i * j < x.size(); ++i) found = std::max(found, S(magnitude(V(x[i * j] - y[i * k]))));
        return found;
    }
    /// Steps over a kink err by where it is in its step, and half as long ones may err in the same way: four more runs, three of which
    /// share no point but the ends, and four times the largest distance of all. An estimate, and no bound.
    S of_kinks(std::vector<V> const& fine, S error, accuracy const& goal) {
        S const wanted = S(goal.wanted);
        auto const end = end_;
        auto const steps = static_cast<index_type>(fine.size()) - 1;
        auto const compare = [&](index_type others, auto const& how) {
            if (not(S(4) * error <= wanted)) return;
            std::vector<V> const other = run(others, goal);
            error = other.empty() ? wanted : std::max(error, S(how(other)));
        };
        compare(steps / 4 * 3, [&](auto const& other) { return distance(other, 3, fine, 4); });
        for (index_type const others : {steps / 8 * 5 + 1, steps / 2 + 3, steps / 16 * 11 + 2})
            compare(others, [&](auto const& other) { return magnitude(V(other.back() - fine.back())); });
        end_ = end;
        return S(4) * error;
    }
    Flow flow_;
    char const* method_;
    int order_;
    interval<S> I_;
    initial_velocity<V> start_;
    state<S, V> end_;            ///< that a run has reached
    std::exception_ptr failure_; ///< of the last run, that is no want of convergence
    index_type walked_ = 0;
};

} // namespace detail

} // namespace hilger
