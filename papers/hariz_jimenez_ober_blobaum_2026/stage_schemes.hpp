// SPDX-License-Identifier: BSL-1.0
// K. Hariz, F. Jimenez and S. Ober-Bloebaum, arXiv:2403.18362 and arXiv:2510.11082: their problems A to E, under the preprints' schemes and
// under Radau's nodes. A preprint's scheme with s stages is galerkin<s, lobatto> with the damping at the stages of Lobatto IIIC, or
// mid-point with the weights of the trapezoidal rule.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

#include "hilger/hilger.hpp"

namespace hilger::papers {

/// The damping -rho D^mu q of Lagrangians L at the stages of Lobatto IIIC.
template <int Stages, class L>
auto lobatto_flow(L const& l, double rho, double mu) {
    auto damped = with_fractional_damping(l, rho, mu, exponentials{1e-14});
    using damping = typename decltype(damped.damping.dampings)::value_type;
    using reading = at_stages<damping, Stages, lobatto>;
    return embed(damped_problem<decltype(damped.mechanics), reading>{damped.mechanics, {damped.damping.dampings}},
                 galerkin<Stages, lobatto>);
}
/// The same at the stages of Radau IIA.
template <int Stages, class L>
auto radau_flow(L const& l, double rho, double mu) {
    return embed(with_fractional_damping(l, rho, mu, exponentials{1e-14}), galerkin<Stages, radau>);
}
/// f of a number of stages, 2, 3 or 4, as a constant.
template <class F>
auto with_stages(int stages, F const& f) {
    if (stages == 2) return f(std::integral_constant<int, 2>{});
    return stages == 3 ? f(std::integral_constant<int, 3>{}) : f(std::integral_constant<int, 4>{});
}
/// The same as a mean over each step.
template <class L>
auto mid_point_flow(L const& l, double rho, double mu) {
    return embed(with_fractional_damping<trapezoid>(l, rho, mu, blocks{}), mid_point);
}

/// Problems A and E: q'' + c q' + k q = 0.
struct damped_oscillator {
    double c, k;
    [[nodiscard]] auto lagrangian() const {
        return [half = k / 2](auto const& q, auto const& v) { return v * v / 2 - half * q * q; };
    }
    /// From q0 with the velocity v0.
    [[nodiscard]] double solution(double q0, double v0, double t) const {
        double const decay = c / 2, w = std::sqrt(k - decay * decay);
        return std::exp(-decay * t) * (q0 * std::cos(w * t) + (v0 + decay * q0) / w * std::sin(w * t));
    }
};
inline constexpr damped_oscillator problem_a{0.25, 0.5}, problem_e{0.25, 1};

/// Problems B to D: x'' + x + rho D^mu x with the solution t^power.
struct forced_oscillator {
    double power, rho, mu;
    [[nodiscard]] auto mechanics() const {
        double const p = power, of_damping = rho * std::tgamma(p + 1) / std::tgamma(p + 1 - mu), m = mu;
        return with_force([](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; },
                          [p, of_damping, m](auto const& t, auto const& x, auto const&) {
                              using std::pow;
                              return 0 * x + pow(t, p) + p * (p - 1) * pow(t, p - 2) + of_damping * pow(t, p - m);
                          });
    }
};
inline constexpr forced_oscillator problem_b{3, 1, 0.5}, problem_c{2.5, 1, 1.5};
inline constexpr forced_oscillator problems_d[] = {{2, 0.5, 0.8}, {2.5, 0.25, 1.2}, {2.5, 0.25, 1.7}};

/// The largest distance of the positions on T from a solution of t.
template <class Flow, class Scale, class Solution>
double largest_error(Flow const& flow, Scale const& T, double q0, double p0, Solution const& solution) {
    double worst = 0;
    for (auto const& x : flow.along(T, q0, p0)) worst = std::max(worst, std::abs(x.q - solution(x.t)));
    return worst;
}
/// Of both components of problem A on [0, 30], with `steps` equal steps.
template <class Flow>
double largest_error_of_a(Flow const& flow, int steps) {
    auto const error = [&](double q0, double p0) {
        return largest_error(flow, uniform(interval{0.0, 30.0}, steps), q0, p0, [&](double t) { return problem_a.solution(q0, p0, t); });
    };
    return std::max(error(0.8, 0.4), error(-0.5, 0.0));
}
/// Of problems B to D on T in [0, 1].
template <class Flow, class Scale>
double largest_error_of(forced_oscillator const& problem, Flow const& flow, Scale const& T) {
    return largest_error(flow, T, 0.0, 0.0, [&](double t) { return std::pow(t, problem.power); });
}

/// The preprint's number of a line of stage_errors.csv: problem, stages, steps.
inline double preprint_error(std::string const& problem, int stages, int steps) {
    return with_stages(stages, [&](auto s) {
        if (problem == "A") return largest_error_of_a(lobatto_flow<s>(problem_a.lagrangian(), problem_a.c, 1), steps);
        return largest_error_of(problem_b, lobatto_flow<s>(problem_b.mechanics(), problem_b.rho, problem_b.mu),
                                uniform(interval{0.0, 1.0}, steps));
    });
}
/// The orders of largest errors on T graded by gamma, equal for gamma = 1, from N steps to 2N.
template <class Flow>
double order_of(forced_oscillator const& problem, Flow const& flow, double gamma, int N) {
    auto const error = [&](int n) { return largest_error_of(problem, flow, graded(0.0, 1.0, n, gamma)); };
    return std::log2(error(N) / error(2 * N));
}
/// The order where the solution is smooth: p of the method without damping, q its stage order.
inline double smooth_order(int p, int q, double mu) { return std::min<double>(p, q + 3 - mu); }

} // namespace hilger::papers
