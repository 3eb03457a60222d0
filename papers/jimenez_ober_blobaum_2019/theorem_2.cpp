// SPDX-License-Identifier: BSL-1.0
// Theorem 2 and remark 2 of F. Jimenez and S. Ober-Bloebaum, "Local truncation error of low-order fractional variational integrators"
// (2019): with alpha = 1/2 one step of either integrator differs by O(h^2) in x and in v from x'' = -U'(x) - rho x', so that its local
// truncation has order one by (3).
#include <array>
#include <cmath>

#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/integrator/fractional_flow.hpp"
#include "hilger/multiprecision.hpp"

using namespace hilger;

namespace {

float50 const friction = float50(3) / 10;

struct point {
    float50 x, v;
};
/// The solution of (13) with U = x^2 / 2 after h: both roots of s^2 + friction s + 1 are complex.
point harmonic(point const& z, float50 const& h) {
    float50 const w = sqrt(float50(1 - friction * friction / 4)), e = exp(float50(-friction * h / 2)), c = cos(float50(w * h)),
                  s = sin(float50(w * h));
    float50 const b = (z.v + friction * z.x / 2) / w;
    return {e * (z.x * c + b * s), e * (z.v * c - (friction * z.v / 2 + z.x) * s / w)};
}
/// With U = 1 - cos x, by the Taylor series of x, sin x and cos x to the order 32: h < 1/16 leaves less than 1e-38.
point pendulum(point const& z, float50 const& h) {
    constexpr std::size_t most = 32;
    std::array<float50, most + 2> x{z.x, z.v}, s{sin(z.x)}, c{cos(z.x)};
    for (std::size_t n = 0; n < most; ++n) {
        int const k = static_cast<int>(n);
        x[n + 2 > most + 1 ? most + 1 : n + 2] = (-s[n] - friction * (k + 1) * x[n + 1]) / ((k + 1) * (k + 2));
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

constexpr lagrangian spring{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
constexpr lagrangian bob{[](auto const& x, auto const& v) {
    using std::cos;
    return v * v / 2 + cos(x);
}};

/// The slopes of the errors of the step number `step` (from 0), from the state that the steps before it made.
template <class L, class Solution>
std::array<double, 2> truncation_slopes(L const& lagrangian, Solution const& solution, damping_at at, int step) {
    auto const flow = embed(with_fractional_damping(lagrangian, friction, fraction<1>{}, direct{}, {.at = at}), midpoint);
    auto const errors = [&](float50 const& h) {
        point last{0, 0};
        point error{0, 0};
        for (auto const& z : flow.along(uniform(float50(0), h, step + 1), float50(1), float50(1) / 2)) {
            if (z.t > 0) {
                point const exact = solution(last, h);
                error = {abs(float50(exact.x - z.q)), abs(float50(exact.v - z.p))};
            }
            last = {z.q, z.p};
        }
        return error;
    };
    float50 const h = float50(1) / 512;
    point const coarse = errors(h), fine = errors(float50(h / 4));
    auto const slope = [](float50 const& a, float50 const& b) { return static_cast<double>(log(float50(a / b)) / log(float50(4))); };
    return {slope(coarse.x, fine.x), slope(coarse.v, fine.v)};
}

} // namespace

TEST_CASE("the two references solve (13): they agree with themselves in two steps, and with their equation") {
    point const z{float50(1), float50(1) / 2};
    float50 const h = float50(1) / 64, e("1e-15");
    auto const check = [&](auto const& solution, float50 const& force) {
        point const once = solution(z, h), twice = solution(solution(z, float50(h / 2)), float50(h / 2));
        CHECK(abs(float50(once.x - twice.x)) < float50("1e-40"));
        CHECK(abs(float50(once.v - twice.v)) < float50("1e-40"));
        point const there = solution(z, e), back = solution(z, float50(-e));
        CHECK(abs(float50((there.x - back.x) / (2 * e) - z.v)) < float50("1e-25"));
        CHECK(abs(float50((there.v - back.v) / (2 * e) - (force - friction * z.v))) < float50("1e-25"));
    };
    check(harmonic, float50(-1));
    check(pendulum, float50(-sin(float50(1))));
}

TEST_CASE("theorem 2 and remark 2: local truncation of order one, in x and v, at the first step and later") {
    for (auto const at : {damping_at::start, damping_at::end})
        for (int const step : {0, 1, 6}) {
            CAPTURE(static_cast<int>(at));
            CAPTURE(step);
            for (double const slope : truncation_slopes(spring, harmonic, at, step)) CHECK(std::abs(slope - 1 - 1) < 0.02);
            for (double const slope : truncation_slopes(bob, pendulum, at, step)) CHECK(std::abs(slope - 1 - 1) < 0.02);
        }
}
