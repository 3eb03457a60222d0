// SPDX-License-Identifier: BSL-1.0
// The validity of a solution between two ends: its equation holds to rounding (integrator/rows.hpp), its ends determine it, and other steps
// have it too. A discrete equation has solutions that are near no motion, and a linear one has a solution for nearly every N even where
// there is no motion.
#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "hilger/newton/stop.hpp"
#include "hilger/scale/time_scale.hpp"
#include "hilger/scale/uniform.hpp"
#include "hilger/variational/sum_of_actions.hpp"

namespace hilger {

/// A report on a solution between two ends.
template <class S>
struct ends_report {
    /// The largest change of a value, relative to the largest of its component, for relative changes of 1 at both ends: 1 for a straight
    /// line, less than 2 / |sin T| for an oscillator on [0, T].
    S response{0};
    /// Its distance from the solution on every second point, joined by straight lines, and the distance of that from the one on every
    /// second of these, relative to the range of a component; below 0 where there is none.
    S distance{-1}, coarser_distance{-1};
    std::string warning; ///< a sentence, or empty
};

namespace detail {

/// From this response on ends known to three digits do not determine a solution, in any scalar.
inline constexpr int strong_response = 1000;

/// @throws error::ill_conditioned
template <class S>
void judge_response(S const& response, ends_report<S>& report) {
    report.response = response;
    if (not(S(strong_response) < response)) return;
    std::ostringstream message;
    message << "the ends hardly determine what lies between them: it changes by " << response
            << " times what they do, as where they are nearly half a period of an oscillator apart and there may be no motion; with other "
               "ends, or another time between them, it is determined";
    if (not(response * square_root_of_epsilon<S>() < S(1))) throw error::ill_conditioned(message.str());
    report.warning = message.str();
}

/// About every second point of T.
template <class S>
uniform_scale<S> coarsened(uniform_scale<S> const& T) {
    index_type const steps = T.steps() / 2;
    return {T.element(0), S((T.element(T.steps()) - T.element(0)) / S(steps)), T.element(T.steps()), steps};
}
template <class S>
time_scale<S> coarsened(time_scale<S> const& T) {
    std::vector<S> points;
    for (index_type i = 0; i + 1 < T.steps(); i += 2) points.push_back(T.element(i));
    points.push_back(T.element(T.steps()));
    return time_scale<S>(std::move(points));
}
/// The values x on T interpolated linearly at the points of another scale with the same ends; both have `parts` values a step.
template <class Root, class V>
std::vector<V> on_straight_lines(Root const& T, std::vector<V> const& x, index_type parts, Root const& other) {
    using S = scalar_of<V>;
    auto const at = [&](index_type i) -> V const& { return x[static_cast<std::size_t>(parts * i)]; };
    std::vector<V> made(static_cast<std::size_t>(parts * other.steps() + 1), x.back());
    for (index_type j = 0, i = 0; j < other.steps(); ++j) {
        S const t = other.element(j);
        while (i + 2 < T.size() and T.element(i + 1) <= t) ++i;
        V const displacement = at(i + 1) - at(i);
        made[static_cast<std::size_t>(parts * j)] = at(i) + displacement * S((t - T.element(i)) / (T.element(i + 1) - T.element(i)));
    }
    return made;
}
/// The largest difference of two lists of values at the points, for each component, relative to the range of the first.
template <class V>
std::vector<scalar_of<V>> distances(std::vector<V> const& x, std::vector<V> const& y, index_type parts) {
    using s = shape<V>;
    using S = scalar_of<V>;
    std::vector<S> all;
    for (int c = 0; c < s::dimension(x[0]); ++c) {
        S most(0), low = s::component(x[0], c), high = low;
        for (std::size_t k = 0; k < x.size(); k += static_cast<std::size_t>(parts)) {
            S const here = s::component(x[k], c);
            most = std::max(most, S(magnitude(S(here - s::component(y[k], c)))));
            low = std::min(low, here);
            high = std::max(high, here);
        }
        all.push_back(low < high ? S(most / (high - low)) : S(0));
    }
    return all;
}

/// Compares x, a solution on T, with those on every second point and every second of these, which solve(scale, values) finds near values.
/// As h -> 0 the distances at least halve: order one halves them, and linear interpolation of any higher order quarters them. A solution
/// whose distances fall by less than half an order, and exceed a thousandth of the range, is reported: these steps do not resolve it.
template <class Root, class V, class Solve>
void compare_with_coarser(Root const& T, std::vector<V> const& x, index_type parts, Solve const& solve, ends_report<scalar_of<V>>& report) {
    using S = scalar_of<V>;
    if (T.steps() < 8) return;
    std::vector<S> fine, coarse;
    try {
        Root const second = coarsened(T), fourth = coarsened(second);
        auto y = on_straight_lines(T, x, parts, second);
        solve(second, y);
        fine = distances(x, on_straight_lines(second, y, parts, T), parts);
        auto z = on_straight_lines(second, y, parts, fourth);
        solve(fourth, z);
        coarse = distances(y, on_straight_lines(fourth, z, parts, second), parts);
    } catch (error::exception const&) {}
    std::size_t worst = 0;
    for (std::size_t c = 1; c < fine.size(); ++c)
        if (fine[worst] < fine[c]) worst = c;
    std::ostringstream message;
    if (fine.empty())
        message << "there is no solution near it on every second point";
    else {
        report.distance = fine[worst];
        bool falls = not(S(1) / S(1000) < fine[worst]);
        if (not coarse.empty()) {
            report.coarser_distance = coarse[worst];
            falls = falls or S(141) * fine[worst] < S(100) * coarse[worst];
        }
        if (falls) return;
        message << "on every second point it is " << fine[worst] << " of its range away";
        if (coarse.empty())
            message << ", and on every second of these there is none";
        else
            message << ", and that from the one on every second of these " << coarse[worst] << ", of which it should be half or less";
    }
    report.warning += (report.warning.empty() ? "" : "; ") + ("the solution may be near no motion: " + message.str()) +
                      "; shorter steps, or a first guess near a motion, tell";
}

template <class Derivatives>
inline constexpr int parts_of_derivatives = 1;
template <class F, class Force>
inline constexpr int parts_of_derivatives<derivatives_by_node<problem<F, Force>>> = parts_of<F>;
/// @throws error::not_finite where the derivatives of L are not finite at the points of T, along first values x
template <class Derivatives, class Root, class V>
void require_regular(Derivatives const& derivatives, Root const& T, std::vector<V> const& x, index_type parts) {
    using S = scalar_of<V>;
    if constexpr (requires { derivatives.gradients(0, S(0), x[0], x[0]); })
        for (index_type i = 0; i <= T.steps(); ++i) {
            auto const at = [&](index_type k) -> V const& { return x[static_cast<std::size_t>(parts * k)]; };
            index_type const step = std::min(i, T.steps() - 1);
            V const v = V(at(step + 1) - at(step)) / T.step(step);
            for (int part = 0; part < parts_of_derivatives<Derivatives>; ++part) {
                auto const [by_q, by_v] = derivatives.gradients(part, S(T.element(i)), at(i), v);
                if (all_finite(by_q) and all_finite(by_v)) continue;
                std::ostringstream where;
                for (int c = 0; c < shape<V>::dimension(v); ++c) where << (c == 0 ? "" : ", ") << shape<V>::component(at(i), c);
                error::raise<error::not_finite>(
                    "the derivatives of L are infinite or no numbers at t = ", T.element(i), ", q = ", where.str(),
                    ", where the first guess between the ends of T, a straight line unless another one is given, "
                    "passes: it and the ends must be where L is regular");
            }
        }
}

} // namespace detail
} // namespace hilger
