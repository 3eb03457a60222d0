// SPDX-License-Identifier: BSL-1.0
// A solution with a memory to a wanted accuracy, by one method: the number of steps is doubled until two solutions agree, as closely as the
// order of the method predicts; where they do not, or L has branches, until six do, most of them with other points. The
// switching_times(a, b) of a callable, as formulas in text have them, are points of all runs, and T is graded behind them. Between the
// points of its scale the solution is a step of the same embedding, x(t).q, x(t).p, for which all steps before it are walked again.
#pragma once

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <optional>

#include "hilger/accuracy/pieces.hpp"
#include "hilger/accuracy/solution.hpp"
#include "hilger/integrator/flow.hpp"

namespace hilger {

namespace detail {

/// How the distances between successive runs, each with twice as many steps, fall. Below zero: there was none yet.
template <class S>
struct convergence {
    S earlier{-1}, before{-1}, error{-1};
    explicit convergence(int order) : gain_(S(std::ldexp(1.0, order / 2)) * S(1.25)), luck_(S(std::ldexp(1.0, order + 2))) {}
    void add(S const& distance) { earlier = std::exchange(before, std::exchange(error, distance)); }
    [[nodiscard]] bool is_third() const { return before >= S(0); }
    [[nodiscard]] bool falls_once() const { return is_third() and follows(before, error); }
    /// Over jumps in time, which no derivative sees, two runs agree by chance: twice in a row is asked for.
    [[nodiscard]] bool falls_twice() const { return error > S(0) and earlier >= S(0) and follows(earlier, before); }
    /// To be called once after each add.
    void count() { still_ = before > S(0) and not(S(2) * error < before) ? still_ + 1 : 0; }
    /// Rounding grows with the number of steps, and where neighbouring motions part it exceeds an epsilon of the numbers: more steps gain
    /// nothing then.
    [[nodiscard]] bool is_rounding(S const& floor, S const& lowest) const {
        return (still_ > 0 and not(error < before) and error < floor) or (still_ > 1 and error < lowest);
    }

private:
    /// A distance that falls as the order explains, and not by more.
    [[nodiscard]] bool follows(S const& coarser, S const& finer) const { return gain_ * finer <= coarser and coarser <= luck_ * finer; }
    /// The least gain of a run over the one before, half the digits, as few steps do not have the order yet. And the largest.
    S gain_, luck_;
    int still_ = 0; ///< comparisons in a row
};

/// Runs of one flow with a memory with more and more steps, graded at the start and behind times where something switches.
template <class Flow, class S, class V>
class solving_by_doubling {
    using scale = time_scale<S>;
    using solution_function = decltype(function_on(std::declval<scale>(), std::vector<V>{}));
    static constexpr index_type most = index_type{1} << 24;

public:
    using result = accurate_solution<S, V, solution_function>;
    solving_by_doubling(Flow flow, char const* method, int order, interval<S> const& I, initial_velocity<V> start)
        : flow_(std::move(flow)), method_(method), order_(order), gamma_(flow_.damping().template grading<S>()), ends_(ends_of(flow_, I)),
          start_(std::move(start)), end_{I.a, start_.q0, flow_.momentum(I.a, start_.q0, start_.v0)} {}

    /// @throws error::no_convergence, or the error that ended the last run
    result reach(accuracy const& goal) {
        std::vector<V> coarse;
        convergence<S> seen(order_);
        S told = std::numeric_limits<S>::infinity();
        for (steps_of_pieces each = first_run(goal); sum(each) <= most; each = changed(each, [](index_type n) { return 2 * n; })) {
            index_type const steps = sum(each);
            branch_watch const watch;
            std::vector<V> momenta, fine = run(each, goal, &momenta);
            if (goal.stop.stop_requested())
                error::raise<error::no_convergence>("an accuracy of ", goal, " was given up on request, after ", walked_, " steps of ",
                                                    method_);
            if (fine.empty())
                require_advance(goal, steps);
            else if (not coarse.empty()) {
                seen.add(distance_of_positions(coarse, 1, fine, 2));
                S const error = seen.error, size = largest_position(fine), wanted = goal.of(size),
                        unit = hilger::epsilon<S>() * S(magnitude(end_.q)), lowest = S(1 << 20) * unit;
                bool const may_be_smooth = not watch.saw_any() and seen.falls_once(), is_smooth = may_be_smooth and seen.falls_twice();
                told = error;
                if (seen.is_third() and error <= wanted and not is_smooth) {
                    told = of_kinks(fine, each, error, wanted, goal);
                    if (not may_be_smooth) told = std::max(seen.before, told);
                }
                if (told <= wanted and seen.is_third())
                    return result_of(each, std::move(fine), std::move(momenta),
                                     std::max(told, size > S(0) ? S(hilger::epsilon<S>() * size) : wanted));
                seen.count();
                if (wanted < error and seen.is_rounding(S(1024) * unit, lowest))
                    error::raise<error::no_convergence>("an accuracy of ", goal, " is not reached in this scalar: with ", steps,
                                                        " steps of ", method_, " the solution is within ", error,
                                                        ", and rounding keeps it there; a scalar with more digits gets further");
            }
            coarse = std::move(fine);
        }
        if (seen.error < S(0))
            error::raise<error::no_convergence>("an accuracy of ", goal, " is not reached with ", most, " steps of ", method_,
                                                ": they do not come to the end");
        error::raise<error::no_convergence>("an accuracy of ", goal, " is not reached with ", most, " steps of ", method_,
                                            "; the solution is within ", told, " then");
    }

private:
    static std::vector<S> ends_of(Flow const& flow, interval<S> const& I) {
        auto const& what = flow.undamped().mechanics();
        return with_starts(ends_of_pieces(I, what.lagrangian, what.force));
    }
    [[nodiscard]] steps_of_pieces first_run(accuracy const& goal) const {
        steps_of_pieces each = first_steps(ends_, goal.longest_step, most);
        for (std::size_t k = 0; k < each.size(); k += 2) // so that the last of them is no longer than the others
            each[k] = static_cast<index_type>(std::ceil(static_cast<double>(gamma_) * static_cast<double>(each[k])));
        return each;
    }
    [[nodiscard]] scale scale_of(steps_of_pieces const& each) const { return joined_pieces(ends_, each, gamma_); }
    /// After a run that has failed. Beyond a thousand of its steps, where shorter ones end too, the motion itself ends, or its speed is
    /// without bound; within fewer the steps are too long.
    void require_advance(accuracy const& goal, index_type steps) {
        S const a = ends_.front(), length = S(ends_.back() - a) / static_cast<S>(steps);
        stuck_ = S(end_.t - a) >= S(1024) * length and magnitude(S(end_.t - ended_)) <= S(8) * length ? stuck_ + 1 : 0;
        ended_ = end_.t;
        if (stuck_ == 3 or steps > most / 2) {
            if (failure_) std::rethrow_exception(failure_); // L is not defined there, or has no velocity
            error::raise<error::no_convergence>("an accuracy of ", goal, " is not reached: steps of ", method_, " as short as ", length,
                                                " come no further than t = ", ended_);
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
        try {
            for (auto const& x : flow_.along(scale_of(each), start_)) {
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
    [[nodiscard]] auto onward(scale const& T) const {
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
    }
    /// The error of a step over a kink depends on where the kink is in it, and steps half as long may err alike: four more runs, three
    /// of which share no point but the ends, and four times the largest distance of all. An estimate, and no bound.
    S of_kinks(std::vector<V> const& fine, steps_of_pieces const& each, S error, S const& wanted, accuracy const& goal) {
        auto const end = end_;
        auto const compare = [&](auto const& other_count, auto const& how) {
            if (not(S(4) * error <= wanted)) return;
            std::vector<V> const other = run(changed(each, other_count), goal);
            error = other.empty() ? wanted : std::max(error, S(how(other)));
        };
        auto const at_the_end = [&](auto const& other) { return magnitude(V(other.back() - fine.back())); };
        compare([](index_type n) { return n / 4 * 3; }, [&](auto const& other) { return distance_of_positions(other, 3, fine, 4); });
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
