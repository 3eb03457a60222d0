// SPDX-License-Identifier: BSL-1.0
// A solution to a wanted accuracy, by one method: the number of steps is doubled until two solutions agree, as closely as the order of the
// method predicts; where they do not, or L has branches, until six do, most of them with other points. The switching_times(a, b) of a
// callable, as formulas in text have them, are points of all runs. Between the points of its scale the solution is a step of the same
// embedding, x(t).q, x(t).p; with a history all steps before it are walked again.
#pragma once

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <optional>

#include "hilger/integrator/accurate_solution.hpp"
#include "hilger/integrator/flow.hpp"
#include "hilger/integrator/pieces.hpp"

namespace hilger {

namespace detail {

/// How the distances between successive runs, each with twice as many steps, fall. Below zero: there was none yet.
template <class S>
struct convergence {
    S earlier{-1}, before{-1}, error{-1};
    explicit convergence(int order)
        : is_low_(order == 2), gain_(is_low_ ? S(3) : S(std::ldexp(1.0, order / 2)) * S(1.25)),
          luck_(is_low_ ? S(5.5) : S(std::ldexp(1.0, order + 2))) {}
    void add(S const& distance) { earlier = std::exchange(before, std::exchange(error, distance)); }
    [[nodiscard]] bool is_third() const { return before >= S(0); }
    [[nodiscard]] bool falls_once() const { return is_third() and follows(before, error); }
    /// Over jumps in time, which no derivative sees, two runs agree by chance: twice in a row is asked for.
    [[nodiscard]] bool falls_twice() const { return not is_low_ and error > S(0) and earlier >= S(0) and follows(earlier, before); }
    /// To be called once after each add, with the largest position and the distance below which rounding may keep runs from agreeing.
    void count(bool has_branches, S const& size, S const& lowest) {
        bool const is_near = error < size / S(64);
        slow_ = has_branches and is_third() and is_near and before < S(4) * error ? slow_ + 1 : 0;
        // The error of a jump in time depends on where it is in its step, and so do single gains: three runs are compared.
        late_ = earlier >= S(0) and is_near and not(error < lowest) and earlier < S(16) * error ? late_ + 1 : 0;
        still_ = before > S(0) and not(S(2) * error < before) ? still_ + 1 : 0;
    }
    /// Kinks, or jumps in time, leave of the order less than two.
    [[nodiscard]] bool is_of_low_order() const { return slow_ == 3 or late_ == 3; }
    /// Rounding grows with the number of steps, and where neighbouring motions part it exceeds an epsilon of the numbers: more steps gain
    /// nothing then.
    [[nodiscard]] bool is_rounding(S const& floor, S const& lowest) const {
        return (still_ > 0 and not(error < before) and error < floor) or (still_ > 1 and error < lowest);
    }

private:
    /// A distance that falls as the order explains, and not by more.
    [[nodiscard]] bool follows(S const& coarser, S const& finer) const { return gain_ * finer <= coarser and coarser <= luck_ * finer; }
    bool is_low_;
    /// The least gain of a run over the one before: of order two nearly a factor of four, which two runs have by chance too; of high
    /// orders, which few steps do not have yet, half the digits. And the largest.
    S gain_, luck_;
    int slow_ = 0, late_ = 0, still_ = 0; ///< comparisons in a row
};

template <class Flow>
decltype(auto) undamped_mechanics(Flow const& flow) {
    if constexpr (has_history<Flow>)
        return flow.undamped().mechanics();
    else
        return flow.mechanics();
}

/// Runs of one flow with more and more steps: equal ones between two times where something switches, with a history graded behind them.
template <class Flow, class S, class V>
class solving_by_doubling {
    using mechanics = std::remove_cvref_t<decltype(undamped_mechanics(std::declval<Flow const&>()))>;
    static constexpr bool may_switch =
        says_when_it_switches<decltype(mechanics::lagrangian), S> or says_when_it_switches<decltype(mechanics::force), S>;
    using scale = std::conditional_t<may_switch or has_history<Flow>, time_scale<S>, decltype(uniform(interval<S>{}, index_type{1}))>;
    using solution_function = decltype(function_on(std::declval<scale>(), std::vector<V>{}));
    static constexpr index_type most = index_type{1} << 24;

public:
    using result = accurate_solution<S, V, solution_function>;
    solving_by_doubling(Flow flow, char const* method, int order, interval<S> const& I, initial_velocity<V> start)
        : flow_(std::move(flow)), method_(method), order_(order), gamma_(gamma_of(flow_)), ends_(ends_of(flow_, I)),
          start_(std::move(start)), end_{I.a, start_.q0, flow_.momentum(I.a, start_.q0, start_.v0)} {}

    /// The solution; nothing where kinks of L leave of the method's order less than two, so that cheaper steps do as well.
    /// @throws error::no_convergence, or the error that ended the last run
    std::optional<result> reach(accuracy const& goal) {
        S const wanted = S(goal.wanted);
        std::vector<V> coarse;
        convergence<S> seen(order_);
        S told = std::numeric_limits<S>::infinity();
        for (steps_of_pieces each = first_run(goal); sum(each) <= most; each = changed(each, [](index_type n) { return 2 * n; })) {
            index_type const steps = sum(each);
            branch_watch const watch;
            std::vector<V> momenta, fine = run(each, goal, &momenta);
            if (goal.stop.stop_requested())
                error::raise<error::no_convergence>("an accuracy of ", goal.wanted, " was given up on request, after ", walked_,
                                                    " steps of ", method_);
            if (fine.empty())
                require_advance(goal, steps);
            else if (not coarse.empty()) {
                seen.add(distance(coarse, 1, fine, 2));
                S const error = seen.error, size = largest(fine), unit = hilger::epsilon<S>() * S(magnitude(end_.q)),
                        lowest = S(1 << 20) * unit;
                bool const may_be_smooth = not watch.saw_any() and seen.falls_once(), is_smooth = may_be_smooth and seen.falls_twice();
                told = error;
                if (seen.is_third() and error <= wanted and not is_smooth) {
                    told = of_kinks(fine, each, error, goal);
                    if (not may_be_smooth) told = std::max(seen.before, told);
                }
                if (told <= wanted and seen.is_third())
                    return result_of(each, std::move(fine), std::move(momenta),
                                     std::max(told, size > S(0) ? S(hilger::epsilon<S>() * size) : wanted));
                seen.count(watch.saw_any(), size, lowest);
                if constexpr (std::is_floating_point_v<S> and not has_history<Flow>)
                    if (seen.is_of_low_order() and order_ > 2) return std::nullopt;
                if (wanted < error and seen.is_rounding(S(1024) * unit, lowest))
                    error::raise<error::no_convergence>("an accuracy of ", goal.wanted, " is not reached in this scalar: with ", steps,
                                                        " steps of ", method_, " the solution is within ", error,
                                                        ", and rounding keeps it there; a scalar with more digits gets further");
            }
            coarse = std::move(fine);
        }
        if (seen.error < S(0))
            error::raise<error::no_convergence>("an accuracy of ", goal.wanted, " is not reached with ", most, " steps of ", method_,
                                                ": they do not come to the end");
        error::raise<error::no_convergence>("an accuracy of ", goal.wanted, " is not reached with ", most, " steps of ", method_,
                                            "; the solution is within ", told, " then");
    }

    /// Steps of all runs together.
    [[nodiscard]] index_type walked() const { return walked_; }

private:
    static S gamma_of(Flow const& flow) {
        if constexpr (has_history<Flow>)
            return flow.damping().template grading<S>();
        else
            return S(1);
    }
    static std::vector<S> ends_of(Flow const& flow, interval<S> const& I) {
        auto const& what = undamped_mechanics(flow);
        auto const ends = ends_of_pieces(I, what.lagrangian, what.force);
        return has_history<Flow> ? with_starts(ends) : ends;
    }
    [[nodiscard]] steps_of_pieces first_run(accuracy const& goal) const {
        steps_of_pieces each = first_steps(ends_, goal.longest_step, most);
        if constexpr (has_history<Flow>)
            for (std::size_t k = 0; k < each.size(); k += 2) // so that the last of them is no longer than the others
                each[k] = static_cast<index_type>(std::ceil(static_cast<double>(gamma_) * static_cast<double>(each[k])));
        return each;
    }
    [[nodiscard]] scale scale_of(steps_of_pieces const& each) const {
        if constexpr (may_switch or has_history<Flow>)
            return joined_pieces(ends_, each, gamma_);
        else
            return piece(ends_, each, 0);
    }
    /// After a run that has failed. Beyond a thousand of its steps, where shorter ones end too, the motion itself ends, or its speed is
    /// without bound; within fewer the steps are too long.
    void require_advance(accuracy const& goal, index_type steps) {
        S const a = ends_.front(), length = S(ends_.back() - a) / static_cast<S>(steps);
        stuck_ = S(end_.t - a) >= S(1024) * length and magnitude(S(end_.t - ended_)) <= S(8) * length ? stuck_ + 1 : 0;
        ended_ = end_.t;
        if (stuck_ == 3 or steps > most / 2) {
            if (failure_) std::rethrow_exception(failure_); // L is not defined there, or has no velocity
            error::raise<error::no_convergence>("an accuracy of ", goal.wanted, " is not reached: steps of ", method_, " as short as ",
                                                length, " come no further than t = ", ended_);
        }
    }
    [[nodiscard]] result result_of(steps_of_pieces const& each, std::vector<V> q, std::vector<V> p, S const& error) const {
        auto const T = scale_of(each);
        index_type const steps = sum(each);
        return {function_on(T, std::move(q)), function_on(T, std::move(p)), end_, steps, method_, error, walked_, onward(T)};
    }
    /// The positions, and the momenta where they are asked for; empty where the steps are too long: they have no solution, or lead to
    /// where L is not defined.
    std::vector<V> run(steps_of_pieces const& each, accuracy const& goal, std::vector<V>* momenta = nullptr) {
        std::vector<V> q;
        q.reserve(static_cast<std::size_t>(sum(each)) + 1);
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
            bool goes_on = true;
            if constexpr (has_history<Flow>)
                goes_on = keep(flow_.along(scale_of(each), start_));
            else
                for (std::size_t k = 0; goes_on and k < each.size(); ++k) {
                    state<S, V> const from = end_;
                    goes_on = k == 0 ? keep(flow_.along(piece(ends_, each, 0), start_))
                                     : keep(flow_.along(piece(ends_, each, k), from.q, from.p));
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
    /// A part of a step may be too long for Newton's method from another start: then it is divided.
    [[nodiscard]] auto onward(scale const& T) const {
        if constexpr (has_history<Flow>)
            return [flow = flow_, T, start = start_](state<S, V> const& from, S const& t) {
                state<S, V> last{t, from.q, from.p};
                S const unit = hilger::epsilon<S>() * std::max(magnitude(t), S(T.max() - T.min()));
                if (t < from.t + S(8) * unit) return last; // no history is made for so short a step
                std::vector<S> points;
                for (index_type i = 0; T.element(i) <= from.t; ++i) points.push_back(T.element(i));
                points.push_back(t);
                for (auto const& x : flow.along(time_scale<S>(std::move(points)), start)) last = x;
                return last;
            };
        else
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
    /// The largest distance between every j-th position of x and every k-th of y.
    static S distance(std::vector<V> const& x, std::size_t j, std::vector<V> const& y, std::size_t k) {
        S found(0);
        for (std::size_t i = 0; i * j < x.size(); ++i) found = std::max(found, S(magnitude(V(x[i * j] - y[i * k]))));
        return found;
    }
    /// The error of a step over a kink depends on where the kink is in it, and steps half as long may err alike: four more runs, three
    /// of which share no point but the ends, and four times the largest distance of all. An estimate, and no bound.
    S of_kinks(std::vector<V> const& fine, steps_of_pieces const& each, S error, accuracy const& goal) {
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
    S gamma_;             ///< of the graded pieces
    std::vector<S> ends_; ///< of the pieces
    initial_velocity<V> start_;
    state<S, V> end_;            ///< that a run has reached
    S ended_ = ends_.front();    ///< the time that the failed run before has reached
    int stuck_ = 0;              ///< failed runs in a row that ended where the one before did
    std::exception_ptr failure_; ///< of the last run, that is no want of convergence
    index_type walked_ = 0;
};

} // namespace detail

} // namespace hilger
