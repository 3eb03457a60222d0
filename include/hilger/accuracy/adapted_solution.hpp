// SPDX-License-Identifier: BSL-1.0
// A solution to a wanted accuracy on a scale that follows the motion (accuracy/adapted_steps.hpp): a walk in adapted steps, and one in
// half as many again, at other points. The distance of the two is the error of the first and more than that of the second, which is the
// solution; where it is more than is wanted, both are made again for a smaller tolerance. The switching_times(a, b) of a callable, as
// formulas in text have them, are points of the scale. Between them the solution is a step of the same embedding.
#pragma once

#include <optional>

#include "hilger/accuracy/adapted_steps.hpp"
#include "hilger/accuracy/pieces.hpp"
#include "hilger/accuracy/solution.hpp"
#include "hilger/trajectory/partial_step.hpp"

namespace hilger::detail {

/// The flow is embed(L, galerkin<Degree, gauss>), with a force or without.
template <int Degree, class Flow, class S, class V>
class solving_in_adapted_steps {
    using walk = walked_states<S, V>;
    static constexpr index_type most = index_type{1} << 24; ///< steps of a walk
    using solution_function = decltype(function_on(std::declval<time_scale<S>>(), std::vector<V>{}));

public:
    using result = accurate_solution<S, V, solution_function>;
    solving_in_adapted_steps(Flow flow, char const* method, interval<S> const& I, initial_velocity<V> from, accuracy const& goal)
        : flow_(std::move(flow)), method_(method), goal_(goal),
          ends_(ends_of_pieces(I, flow_.mechanics().lagrangian, flow_.mechanics().force)), from_(std::move(from)) {}

    /// @throws error::no_convergence, or the error of a step with its last state
    result solution() {
        (void)uniform(interval<S>{ends_.front(), ends_.back()}, index_type{1}); // or it says what is wrong
        S const longest = longest_step();
        S before(-1), share(1);
        for (int still = 0, failed = 0, k = 0;; ++k) {
            std::optional<pair_of_walks> made = walks_for(share, S(longest / S(1 << std::min(k, 20))), failed == 2);
            if (not made) { // what is too inaccurate may lead to where L is not defined
                ++failed;
                share = share / S(64);
                continue;
            }
            auto& [coarse, fine, beside] = *made;
            S const size = largest_position(coarse.q), wanted = goal_.of(size), unit = epsilon<S>() * size;
            // Behind a kink both may err alike, by more than their distance.
            S const error = distance_of_positions(coarse.q, 1, beside, 1) * S(coarse.is_rough ? 4 : 1);
            if (error <= wanted) return result_of(std::move(fine), std::max(error, unit > S(0) ? unit : wanted));
            still = before < S(0) or S(2) * error < before ? 0 : still + 1;
            if (share * wanted < unit / S(16) or (still > 1 and error < S(1 << 20) * unit))
                error::raise<error::no_convergence>("an accuracy of ", goal_, " is not reached in this scalar: with ", coarse.steps(),
                                                    " steps of ", method_, " the solution is within ", error,
                                                    ", and rounding keeps it there; a scalar with more digits gets further");
            before = error;
            share = share * std::clamp(S(wanted / (S(2) * error)), S(S(1) / S(4096)), S(S(1) / S(4)));
        }
    }

private:
    struct pair_of_walks {
        walk coarse, fine;
        std::vector<V> beside; ///< positions of the fine one at the points of the other
    };
    /// Walks for a share of the tolerance; nothing, or an exception if `throws`, where they do not come to the end.
    std::optional<pair_of_walks> walks_for(S const& share, S const& longest, bool throws) {
        auto const watch = [this](index_type made) { watch_steps(made); };
        adapted_steps<Degree, Flow, S, V, decltype(watch)> const steps(flow_, ends_, from_, watch);
        try {
            pair_of_walks made;
            made.coarse = steps.adapted_to([&](S const& size) { return S(share * goal_.of(size)); }, longest);
            made_ += made.coarse.made;
            made.fine = steps.at_other_points(made.coarse, made.beside);
            made_ += made.fine.made;
            return made;
        } catch (error::no_convergence const&) {
            if (throws or is_stopped_) throw;
        } catch (error::not_finite const&) {
            if (throws) throw;
        } catch (error::singular const&) {
            if (throws) throw;
        }
        return {};
    }
    void watch_steps(index_type made) {
        is_stopped_ = goal_.stop.stop_requested() or made > most;
        if (goal_.stop.stop_requested())
            error::raise<error::no_convergence>("an accuracy of ", goal_, " was given up on request, after ", made_ + made, " steps of ",
                                                method_);
        if (is_stopped_)
            error::raise<error::no_convergence>("an accuracy of ", goal_, " is not reached with ", made, " steps of ", method_);
    }
    [[nodiscard]] S longest_step() const {
        S const whole = ends_.back() - ends_.front(), part = whole / S(32);
        double const longest = goal_.longest_step;
        require_longest_step(static_cast<double>(whole), longest, most);
        return longest > 0 ? std::min(part, S(longest)) : part;
    }
    [[nodiscard]] result result_of(walk made, S const& error) const {
        state<S, V> const end{made.t.back(), made.q.back(), made.p.back()};
        index_type const steps = made.steps();
        time_scale<S> const T(std::move(made.t));
        return {function_on(T, std::move(made.q)),
                function_on(T, std::move(made.p)),
                end,
                steps,
                method_,
                error,
                made_,
                [flow = flow_](state<S, V> const& x, S const& t) { return state_at(flow, x, t); }};
    }

    Flow flow_;
    char const* method_;
    accuracy const& goal_;
    std::vector<S> ends_; ///< of the pieces
    initial_velocity<V> from_;
    index_type made_ = 0; ///< steps of all walks
    bool is_stopped_ = false;
};

} // namespace hilger::detail
