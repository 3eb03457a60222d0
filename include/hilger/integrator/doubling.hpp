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
#include <optional>

#include "hilger/integrator/accurate_solution.hpp"
#include "hilger/integrator/flow.hpp"
#include "hilger/integrator/pieces.hpp"
#include "hilger/trajectory/dense_output.hpp"

namespace hilger {

namespace detail {

/// Runs of one flow with more and more steps, equal ones between two times where something switches.
template <class Flow, class S, class V>
class solving_by_doubling {
    /// Steps are equal where nothing says that it switches, and where they are remembered.
    static constexpr bool may_switch = [] {
        if constexpr (has_history<Flow>)
            return false;
        else {
            using mechanics = std::remove_cvref_t<decltype(std::declval<Flow const&>().mechanics())>;
            return says_when_it_switches<decltype(mechanics::lagrangian), S> or says_when_it_switches<decltype(mechanics::force), S>;
        }
    }();
    using scale = std::conditional_t<may_switch, time_scale<S>, decltype(uniform(interval<S>{}, index_type{1}))>;
    using solution_function = decltype(function_on(std::declval<scale>(), std::vector<V>{}));
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
        for (steps_of_pieces each = first_steps(ends_, goal.longest_step, most); sum(each) <= most;
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
    [[nodiscard]] scale scale_of(steps_of_pieces const& each) const {
        if constexpr (may_switch)
            return joined_pieces(ends_, each);
        else
            return piece(ends_, each, 0);
    }
    /// The positions, and the momenta for who wants them; nothing where the steps are too long: they have no solution, or lead to where L
    /// is not defined.
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
            bool goes_on = keep(flow_.along(piece(ends_, each, 0), start_));
            if constexpr (may_switch)
                for (std::size_t k = 1; goes_on and k < each.size(); ++k) {
                    state<S, V> const from = end_;
                    goes_on = keep(flow_.along(piece(ends_, each, k), from.q, from.p));
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
    std::vector<S> ends_; ///< of the pieces
    initial_velocity<V> start_;
    state<S, V> end_;            ///< that a run has reached
    std::exception_ptr failure_; ///< of the last run, that is no want of convergence
    index_type walked_ = 0;
};

} // namespace detail

} // namespace hilger
