// SPDX-License-Identifier: BSL-1.0
// Local truncation errors, (3) of F. Jimenez and S. Ober-Bloebaum (2019), in 50 digits: of the integrators (21) and of remark 2 against the
// linearly damped systems (13), and of the family (11) against (5).
#pragma once

#include <array>
#include <cmath>

#include "../table.hpp"
#include "hilger/fractional/flow.hpp"
#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace hilger::papers {

/// rho of (13) in the computations here.
inline float50 const friction = float50(3) / 10;

struct point {
    float50 x, v;
};
/// The solution of (13) with U = x^2 / 2 after h, for rho < 2, where both roots of s^2 + rho s + 1 are complex; (5) for rho = 0.
inline point harmonic(point const& z, float50 const& h, float50 const& rho = friction) {
    float50 const w = sqrt(float50(1 - rho * rho / 4)), e = exp(float50(-rho * h / 2)), c = cos(float50(w * h)), s = sin(float50(w * h));
    float50 const b = (z.v + rho * z.x / 2) / w;
    return {e * (z.x * c + b * s), e * (z.v * c - (rho * z.v / 2 + z.x) * s / w)};
}
/// With U = 1 - cos x, by the Taylor series of x, sin x and cos x to the order 32: h < 1/16 leaves less than 1e-38.
inline point pendulum(point const& z, float50 const& h, float50 const& rho = friction) {
    constexpr std::size_t most = 32;
    std::array<float50, most + 2> x{z.x, z.v}, s{sin(z.x)}, c{cos(z.x)};
    for (std::size_t n = 0; n < most; ++n) {
        int const k = static_cast<int>(n);
        x[n + 2 > most + 1 ? most + 1 : n + 2] = (-s[n] - rho * (k + 1) * x[n + 1]) / ((k + 1) * (k + 2));
        float50 ds(0), dc(0); // of (sin x)' = cos x x' and (cos x)' = -sin x x'
        for (std::size_t j = 0; j <= n; ++j) {
            float50 const slope = static_cast<int>(n - j + 1) * x[n - j + 1];
            ds += c[j] * slope;
            dc -= s[j] * slope;
        }
        s[n + 1] = ds / (k + 1);
        c[n + 1] = dc / (k + 1);
    }
    point sum{0, 0};
    for (std::size_t n = most; n > 0; --n) {
        sum.x = (sum.x + x[n]) * h;
        sum.v = sum.v * h + static_cast<int>(n) * x[n];
    }
    return {sum.x + x[0], sum.v};
}

inline constexpr lagrangian spring{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
inline constexpr lagrangian bob{[](auto const& x, auto const& v) {
    using std::cos;
    return v * v / 2 + cos(x);
}};

/// What a flow from x = 1, v = 1/2 adds to the error in its step number `step` (from 0): the distance to the solution that starts where the
/// steps before it ended.
template <class Flow, class Solution>
point truncation_error(Flow const& flow, Solution const& solution, float50 const& h, int step = 0) {
    point last{0, 0}, error{0, 0};
    for (auto const& z : flow.along(uniform(float50(0), h, step + 1), float50(1), float50(1) / 2)) {
        if (z.t > 0) {
            point const exact = solution(last, h);
            error = {abs(float50(exact.x - z.q)), abs(float50(exact.v - z.p))};
        }
        last = {z.q, z.p};
    }
    return error;
}
/// The steps of the fits: 1/512 / 4^n.
inline constexpr int coarsest_step = 512, step_ratio = 4;
/// p of (3) in x and in v: the slopes of the errors of a step, less one.
template <class Flow, class Solution>
std::array<double, 2> truncation_orders(Flow const& flow, Solution const& solution, int step = 0) {
    std::array<float50, 2> x, v;
    float50 h = float50(1) / coarsest_step;
    for (std::size_t n = 0; n < 2; ++n, h /= step_ratio) {
        point const e = truncation_error(flow, solution, h, step);
        x[n] = e.x, v[n] = e.v;
    }
    return {fitted_slope(x, step_ratio) - 1, fitted_slope(v, step_ratio) - 1};
}
/// The integrator (21) for 2 alpha = 1, or that of remark 2, which has the damping at the end of its steps.
template <class L>
auto linearly_damped(L const& undamped, damping_at at) {
    return embed(with_fractional_impulses(undamped, friction, fraction<1>{}, direct{}, {.at = at}), mid_point);
}

} // namespace hilger::papers
