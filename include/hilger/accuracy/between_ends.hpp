// SPDX-License-Identifier: BSL-1.0
// A solution between two ends to a wanted accuracy instead of a number of steps:
//   auto const x = solve(L, interval{0.0, 1.0}, {.q0 = a, .qN = b}, accuracy{1e-10});      x.q, x.p, x.steps, x.method, x.error
// The solutions on T and on T with all steps divided are compared at their common points and in the middles of the steps of T. Where they
// differ inside a step by more than at its ends, the step is divided, until they agree: in a boundary layer T has short steps. The
// embedding is a Galerkin embedding, whose order depends on the accuracy.
#pragma once

#include <algorithm>
#include <vector>

#include "hilger/accuracy/from_start.hpp"
#include "hilger/accuracy/pieces.hpp"
#include "hilger/integrator/momenta.hpp"
#include "hilger/integrator/solve.hpp"

namespace hilger {

/// A solution between two ends on the scale that was found.
template <class S, class V, class Function>
struct solution_between {
    Function q;         ///< positions, a function on T
    Function p;         ///< momenta there
    index_type steps;   ///< of T
    char const* method; ///< the embedding that was chosen
    S error; ///< the largest distance from the solution on T with pairs of steps joined, more than its own error where L is smooth
};

namespace detail {

/// The search for T, with the solution on T and on T with all steps divided.
template <class Flow, class S, class V>
class solving_between {
    using Position = std::remove_cvref_t<decltype(std::declval<Flow const&>().embedding().position)>;
    static constexpr index_type parts = controls_of<std::remove_cvref_t<decltype(std::declval<Flow const&>().embedding())>> - 1;
    static_assert(parts % 2 == 0, "a value of an even number of parts is in the middle of the step");

public:
    using function = decltype(function_on(std::declval<time_scale<S>>(), std::vector<V>{}));
    solving_between(Flow const& flow, char const* method, boundary_values<V> const& ends, accuracy const& goal)
        : flow_(flow), method_(method), ends_(ends), goal_(goal) {}

    /// From these points on. @throws error::no_convergence, and the errors of a problem on most points
    solution_between<S, V, function> reach(std::vector<S> points) const {
        std::vector<V> coarse, fine;
        S before(-1);
        while (true) {
            std::vector<S> const all = divided(points);
            try {
                coarse = solved(points, coarse);
                fine = solved(all, every(coarse, parts / 2));
            } catch (error::no_convergence const&) {
                if (goal_.stop.stop_requested() or points.size() > 256) throw;
                points = all, coarse.clear();
                continue;
            }
            S error(0);
            std::vector<S> const inside = differences(coarse, fine, error);
            S const wanted = goal_.of(largest_position(fine));
            if (before >= S(0) and error <= wanted) return made(all, std::move(fine), error);
            if (all.size() > (1u << 15) or (before >= S(0) and before <= error and error < square_root_of_epsilon<S>()))
                error::raise<error::no_convergence>("an accuracy of ", goal_, " between two ends is not reached with ", all.size() - 1,
                                                    " steps of ", method_, "; the solution is within ", error);
            S const worst = *std::max_element(inside.begin(), inside.end()), least = std::max(S(wanted / S(64)), S(worst / S(256)));
            std::vector<bool> divides;
            for (S const& x : inside) divides.push_back(not(x < std::min(worst, least)));
            before = error;
            coarse = chosen(every(fine, parts), divides);
            points = chosen(all, divides);
        }
    }

private:
    static std::vector<V> every(std::vector<V> const& x, index_type step) {
        std::vector<V> y;
        for (std::size_t k = 0; k < x.size(); k += static_cast<std::size_t>(step)) y.push_back(x[k]);
        return y;
    }
    /// Of points, or values there, with the middles of all steps, those at the ends of steps and in the middles of the steps to be divided.
    template <class X>
    static std::vector<X> chosen(std::vector<X> const& with_middles, std::vector<bool> const& divides) {
        std::vector<X> x{with_middles[0]};
        for (std::size_t i = 0; i < divides.size(); ++i) {
            if (divides[i]) x.push_back(with_middles[2 * i + 1]);
            x.push_back(with_middles[2 * i + 2]);
        }
        return x;
    }
    static std::vector<S> divided(std::vector<S> const& points) {
        std::vector<S> all{points[0]};
        for (std::size_t i = 1; i < points.size(); ++i) all.insert(all.end(), {S((points[i - 1] + points[i]) / S(2)), points[i]});
        return all;
    }
    /// The values at all points and inside the steps, from values at the points or, where there are none, from a straight line.
    [[nodiscard]] std::vector<V> solved(std::vector<S> const& points, std::vector<V> const& guess) const {
        time_scale<S> const T(points);
        if (guess.empty()) return solve_between(flow_, T, ends_, straight_line{}, goal_.stop, nullptr);
        return solve_between(flow_, T, ends_, function_on(T, guess), goal_.stop, nullptr);
    }
    /// The difference in the middle of each step, less that on the line between its ends; `error` is the largest one of all.
    static std::vector<S> differences(std::vector<V> const& coarse, std::vector<V> const& fine, S& error) {
        std::vector<V> const x = every(coarse, parts / 2), y = every(fine, parts);
        std::vector<S> inside;
        for (std::size_t k = 0; k < x.size(); ++k) error = std::max(error, S(magnitude(V(y[k] - x[k]))));
        for (std::size_t k = 0; k + 2 < x.size(); k += 2)
            inside.push_back(S(magnitude(V(y[k + 1] - x[k + 1] - ((y[k] - x[k]) + (y[k + 2] - x[k + 2])) / S(2)))));
        return inside;
    }
    [[nodiscard]] solution_between<S, V, function> made(std::vector<S> const& points, std::vector<V> fine, S const& error) const {
        time_scale<S> const T(points);
        auto q = function_on(T, every(fine, parts));
        auto p = momenta_of(flow_, function_on(derived_scale(T, domain<typename Position::from>{}), std::move(fine)));
        return {std::move(q), std::move(p), T.steps(), method_, error};
    }
    Flow const& flow_;
    char const* method_;
    boundary_values<V> ends_;
    accuracy const& goal_;
};

} // namespace detail

/// The motion of L(q, v) or L(t, q, v), or of with_force(L, f), from q0 at a to qN at b. @throws error::invalid_parameter where the
/// accuracy is not positive or below 64 epsilon; error::no_convergence; and what problems on given points throw (integrator/solve.hpp)
template <class F, class S, class W>
auto solve(F const& L, interval<S> const& I, boundary_values<W> const& ends, detail::given_accuracy const& goal) {
    auto const given = detail::given_ends<S>(ends);
    (void)detail::checked_start<S>(initial_velocity<W>{ends.q0, ends.qN}, goal);
    (void)uniform(I, index_type{1}); // or it says what is wrong
    std::vector<S> points;
    for (S const& t : uniform(I, detail::first_steps(std::vector<S>{I.a, I.b}, goal.longest_step, index_type{1} << 12)[0]))
        points.push_back(t);
    S const size = std::max(S(magnitude(given.q0)), S(magnitude(given.qN))), ratio = size > S(0) ? S(goal.of(size) / size) : S(0);
    return detail::with_gauss_for(ratio, [&]<int Nodes>(std::integral_constant<int, Nodes>, char const* method) {
        auto const flow = embed(L, galerkin<Nodes, gauss>);
        using V = std::remove_cvref_t<decltype(given.q0)>;
        return detail::solving_between<std::remove_const_t<decltype(flow)>, S, V>(flow, method, given, goal).reach(points);
    });
}
#define HILGER_SOLVE_OF_SIZE(Size)                                                                                                         \
    template <class F, class S>                                                                                                            \
    auto solve(F const& L, interval<S> const& I, detail::ends_in_braces<S, Size> const& from, detail::given_accuracy const& goal) {        \
        return solve(L, I, from.data(), goal);                                                                                             \
    }
HILGER_FOR_EACH_SIZE(HILGER_SOLVE_OF_SIZE)
#undef HILGER_SOLVE_OF_SIZE

} // namespace hilger
