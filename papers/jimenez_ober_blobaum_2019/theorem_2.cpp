// SPDX-License-Identifier: BSL-1.0
// Theorem 2 and remark 2 of F. Jimenez and S. Ober-Bloebaum, "Local truncation error of low-order fractional variational integrators"
// (2019): with alpha = 1/2 one step of either integrator differs by O(h^2) in x and in v from x'' = -U'(x) - rho x', so that its local
// truncation has order one by (3).
#include <doctest/doctest.h>

#include "local_truncation.hpp"

namespace jimenez_theorem_2_tests {

using namespace hilger;
using namespace hilger::papers;

namespace {
constexpr auto damped_spring = [](point const& z, float50 const& h) { return harmonic(z, h); };
constexpr auto damped_pendulum = [](point const& z, float50 const& h) { return pendulum(z, h); };
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
    check(damped_spring, float50(-1));
    check(damped_pendulum, float50(-sin(float50(1))));
}

TEST_CASE("theorem 2 and remark 2: local truncation of order one, in x and v, at the first step and later") {
    for (auto const at : {damping_at::start, damping_at::end})
        for (int const step : {0, 1, 6}) {
            CAPTURE(static_cast<int>(at));
            CAPTURE(step);
            for (double const p : truncation_orders(linearly_damped(spring, at), damped_spring, step)) CHECK(std::abs(p - 1) < 0.02);
            for (double const p : truncation_orders(linearly_damped(bob, at), damped_pendulum, step)) CHECK(std::abs(p - 1) < 0.02);
        }
}

TEST_CASE("proof of theorem 2: the first term of the errors, and -h rho v_k, which the last lines of the proof have lost") {
    // (23) less (24): x(h) - x_1 = h^2 rho v_0 / 2 + ..., v(h) - v_1 = h^2 rho (U'(x_0) + rho v_0 / 2) + ... where the damping of the step
    // is (22), that is from the second step on.
    float50 const h = float50(1) / 1000000;
    auto const flow = linearly_damped(spring, damping_at::start);
    point z{0, 0}, before{0, 0};
    for (auto const& at : flow.along(uniform(float50(0), h, 2), float50(1), float50(1) / 2)) {
        before = z;
        z = {at.q, at.p};
    }
    point const exact = damped_spring(before, h);
    float50 const hh = h * h, in_x = (exact.x - z.x) / hh, in_v = (exact.v - z.v) / hh, tolerance = 4 * h;
    CHECK(abs(float50(in_x - friction * before.v / 2)) < tolerance);
    CHECK(abs(float50(in_v - friction * (before.x + friction * before.v / 2))) < tolerance);
    // v_{k+1} in the last lines of the proof, without and with the term
    float50 const printed = before.v - h * before.x - hh / 2 * before.v - hh / 2 * friction * before.x;
    CHECK(abs(float50(printed - h * friction * before.v - z.v)) < 10 * h * hh);
    CHECK(abs(float50(printed - z.v)) > h * friction * before.v / 2);
}

} // namespace jimenez_theorem_2_tests
