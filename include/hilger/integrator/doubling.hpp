// SPDX-License-Identifier: BSL-1.0
// A solution to a wanted accuracy, by one method: the number of steps is doubled until two solutions agree, as closely as the order of the
// method says that they should; where they do not, or L has branches, until six do, of which most have their points elsewhere. Times at
// which a callable says that it switches, by a member switching_times(a, b) as formulas in text have it, are points of all runs. Between
// the points of its scale the solution is a step of the same embedding, x(t).q, x(t).p; with a history, which such a step has not, the
// cubic polynomial of dense_output.
#pragma once

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <stop_token>

#include "hilger/function/function.hpp"
#include "hilger/integrator/flow.hpp"
#include "hilger/scale/time_scale.hpp"
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

namespace detail {

/// The ends of the pieces of [a, b] between which nothing switches: a callable says where it does by a member switching_times(a, b).
template <class S, class... Callables>
std::vector<S> ends_of_pieces(interval<S> const& I, Callables const&... callables) {
    std::vector<S> ends{I.a, I.b};
    if (not(I.a < I.b)) return ends; // which no scale is made of
    auto const add = [&](auto const& f) {
        if constexpr (requires { f.switching_times(I.a, I.b); })
            for (S const& t : f.switching_times(I.a, I.b)) ends.push_back(t);
    };
    (add(callables), ...);
    std::sort(ends.begin(), ends.end());
    S const unit = S(64) * epsilon<S>() * std::max(magnitude(I.a), magnitude(I.b)); // two callables may say the same otherwise rounded
    std::erase_if(ends, [&, last = I.a](S const& t) mutable {
        bool const is_new = t == I.a or (last + unit < t and (t == I.b or t + unit < I.b));
        if (is_new) last = t;
        return not is_new;
    });
    return ends;
}
/// The numbers of steps of the pieces to begin with. @throws error::invalid_parameter
template <class S>
std::vector<index_type> first_steps(std::vector<S> const& ends, double longest, index_type most) {
    double const whole = static_cast<double>(S(ends.back() - ends.front()));
    index_type steps = 8;
    if (not(longest >= 0)) error::raise<error::invalid_parameter>("the longest step is positive, or 0 for any, and not ", longest);
    if (longest > 0)
        while (steps <= most and whole > longest * static_cast<double>(steps)) steps *= 2;
    if (steps > most) error::raise<error::invalid_parameter>("steps of at most ", longest, " are more than ", most, " on this interval");
    std::vector<index_type> each;
    for (std::size_t k = 1; k < ends.size(); ++k) {
        double const share = static_cast<double>(S(ends[k] - ends[k - 1])) / whole;
        each.push_back(std::max<index_type>(1, static_cast<index_type>(std::ceil(share * static_cast<double>(steps)))));
    }
    return each;
}

/// Runs of one flow with more and more steps, equal ones between two times where something switches.
template <class Flow, class S, class V>
class solving_by_doubling {
    /// Steps are equal where nothing says that it switches, and where they are remembered.
    static constexpr bool may_switch = [] {
        if constexpr (has_history<Flow>)
            return false;
        else
            return requires(Flow const& f, S const& t) { f.mechanics().lagrangian.switching_times(t, t); }
        or requires(Flow const& f, S const& t) { f.mechanics().force.switching_times(t, t); };
    }();
    using scale = std::conditional_t<may_switch, time_scale<S>, decltype(uniform(interval<S>{}, index_type{1}))>;
    using solution_function = decltype(function_on(std::declval<scale>(), std::vector<V>{}));
    using counts = std::vector<index_type>; // of the steps of each piece
    static constexpr index_type most = index_type{1} << 24;

public:
    using result = accurate_solution<S, V, solution_function>;
    solving_by_doubling(Flow flow, char const* method, int order, interval<S> const& I, initial_velocity<V> start)
        : flow_(std::move(flow)), method_(method), order_(order), ends_(ends_of(flow_, I)),
          start_(std::move(start)), end_{I.a, start_.q0, flow_.momentum(I.a, start_.q0, start_.v0)} {}

    /// Nothing where kinks of L leave of the method's order less than two, so that a step that costs less does as much.
    std::optional<result> reach(accuracy const& goal) {
        S const wanted = S(goal.wanted);
        // What a run wins over the one before where the order of the method says it: of order two a factor of four or nearly so, which two
        // runs have by chance too; of high ones, which few steps do not have yet, half the digits or more.
        bool const is_low = order_ == 2;
        S const gain = is_low ? S(3) : S(std::ldexp(1.0, order_ / 2)) * S(1.25), luck = is_low ? S(5.5) : S(std::ldexp(1.0, order_ + 2));
        std::vector<V> coarse;
        S earlier(-1), before(-1), error(-1), told = std::numeric_limits<S>::infinity();
        int slow = 0, late = 0, still = 0, stuck = 0; // comparisons, and runs that ended where the one before did, in a row
        S const a = ends_.front(), b = ends_.back();
        S ended = a;
        for (counts each = first_steps(ends_, goal.longest_step, most); sum(each) <= most;
             each = changed(each, [](index_type n) { return 2 * n; })) {
            index_type const steps = sum(each);
            branch_watch const watch;
            std::vector<V> momenta, fine = run(each, goal, &momenta);
            if (goal.stop.stop_requested())
                error::raise<error::no_convergence>("an accuracy of ", goal.wanted, " was given up on request, after ", walked_,
                                                    " steps of ", method_);
            if (fine.empty()) {
                // Behind a thousand steps, which shorter ones come as far as, the motion itself ends, or its speed is without bound. Within
                // fewer the steps are too long.
                S const length = S(b - a) / static_cast<S>(steps), way = S(end_.t - a);
                stuck = way >= S(1024) * length and magnitude(S(end_.t - ended)) <= S(8) * length ? stuck + 1 : 0;
                ended = end_.t;
                if (stuck == 3 or steps > most / 2) {
                    if (failure_) std::rethrow_exception(failure_); // L is not defined there, or has no velocity
                    error::raise<error::no_convergence>("an accuracy of ", goal.wanted, " is not reached: steps of ", method_,
                                                        " as short as ", length, " come no further than t = ", ended);
                }
            } else if (not coarse.empty()) {
                earlier = std::exchange(before, std::exchange(error, distance(coarse, 1, fine, 2)));
                // Twice in a row, and not by more than the order explains: over jumps in time, which nothing sees, two runs agree by
                // chance.
                auto const follows = [&](S const& coarser, S const& finer) { return gain * finer <= coarser and coarser <= luck * finer; };
                bool const is_third = before >= S(0), may_be_smooth = not watch.saw_any() and is_third and follows(before, error);
                bool const is_smooth = may_be_smooth and not is_low and error > S(0) and earlier >= S(0) and follows(earlier, before);
                S const size = largest(fine), unit = hilger::epsilon<S>() * S(magnitude(end_.q)), floor = S(1024) * unit,
                        lowest = S(1 << 20) * unit;
                told = error;
                if (is_third and error <= wanted and not is_smooth) {
                    told = of_kinks(fine, each, error, goal);
                    if (not may_be_smooth) told = std::max(before, told);
                }
                if (told <= wanted and is_third) {
                    state<S, V> end = end_;
                    auto const T = scale_of(each);
                    return result{function_on(T, std::move(fine)),
                                  function_on(T, std::move(momenta)),
                                  end,
                                  steps,
                                  method_,
                                  std::max(told, size > S(0) ? S(hilger::epsilon<S>() * size) : wanted),
                                  walked_,
                                  onward(steps)};
                }
                bool const is_near = error < size / S(64);
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
    static std::vector<S> ends_of(Flow const& flow, interval<S> const& I) {
        if constexpr (may_switch)
            return ends_of_pieces(I, flow.mechanics().lagrangian, flow.mechanics().force);
        else
            return {I.a, I.b};
    }
    static index_type sum(counts const& each) { return std::accumulate(each.begin(), each.end(), index_type{0}); }
    template <class Change>
    static counts changed(counts each, Change const& change) {
        for (index_type& n : each) n = change(n);
        return each;
    }
    [[nodiscard]] auto piece(counts const& each, std::size_t k) const { return uniform(interval<S>{ends_[k], ends_[k + 1]}, each[k]); }
    [[nodiscard]] scale scale_of(counts const& each) const {
        if constexpr (may_switch) {
            std::vector<S> points{ends_.front()};
            for (std::size_t k = 0; k < each.size(); ++k)
                for (index_type i = 1; i <= each[k]; ++i) points.push_back(piece(each, k).element(i));
            return time_scale<S>(std::move(points));
        } else
            return piece(each, 0);
    }
    /// The positions, and the momenta for who wants them; nothing where the steps are too long: they have no solution, or lead to where L
    /// is not defined.
    std::vector<V> run(counts const& each, accuracy const& goal, std::vector<V>* momenta = nullptr) {
        std::vector<V> q;
        walked_ += sum(each);
        end_.t = ends_.front();
        failure_ = {};
        // The states of a path, without the first one of a piece behind others.
        auto const keep = [&](auto const& path) {
            for (auto const& x : path) {
                if (not q.empty() and x.t == end_.t) continue;
                q.push_back(x.q);
                if (momenta != nullptr) momenta->push_back(x.p);
                end_ = x;
                if (q.size() % 1024 == 0 and goal.stop.stop_requested()) return false;
            }
            return true;
        };
        try {
            bool goes_on = keep(flow_.along(piece(each, 0), start_));
            if constexpr (may_switch)
                for (std::size_t k = 1; goes_on and k < each.size(); ++k) {
                    state<S, V> const from = end_;
                    goes_on = keep(flow_.along(piece(each, k), from.q, from.p));
                }
            if (not goes_on) return {};
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
            return [flow = flow_, T = uniform(interval<S>{ends_.front(), ends_.back()}, all), start = start_,
                    kept = std::make_shared<walked_again>()](state<S, V> const&, S const& t) {
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
    S of_kinks(std::vector<V> const& fine, counts const& each, S error, accuracy const& goal) {
        S const wanted = S(goal.wanted);
        auto const end = end_;
        auto const compare = [&](auto const& other_count, auto const& how) {
            if (not(S(4) * error <= wanted)) return;
            std::vector<V> const other = run(changed(each, other_count), goal);
            error = other.empty() ? wanted : std::max(error, S(how(other)));
        };
        auto const at_the_end = [&](auto const& other) { return magnitude(V(other.back() - fine.back())); };
        compare([](index_type n) { return n / 4 * 3; }, [&](auto const& other) { return distance(other, 3, fine, 4); });
        compare([](index_type n) { return n / 8 * 5 + 1; }, at_the_end);
        compare([](index_type n) { return n / 2 + 3; }, at_the_end);
        compare([](index_type n) { return n / 16 * 11 + 2; }, at_the_end);
        end_ = end;
        return S(4) * error;
    }
    Flow flow_;
    char const* method_;
    int order_;
    std::vector<S> ends_; ///< of the pieces
    initial_velocity<V> start_;
    state<S, V> end_;            ///< that a run has reached
    std::exception_ptr failure_; ///< of the last run, that is no want of convergence
    index_type walked_ = 0;
};

} // namespace detail

} // namespace hilger
