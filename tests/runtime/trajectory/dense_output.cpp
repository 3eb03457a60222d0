// SPDX-License-Identifier: BSL-1.0
// Between the points of a trajectory: the data at both ends, cubics exactly, order 4.
#include <doctest/doctest.h>

#include "hilger/trajectory/dense_output.hpp"
#include "support/orders.hpp"
#include "support/systems.hpp"

namespace dense_output_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// The exact motion of L = v^2/2 + v x/3 - x^2/2 from x = 1, v = 0: the gyroscopic term is a total derivative.
state<float50, float50> exact(float50 const& t) { return {t, cos(t), -sin(t) + cos(t) / 3}; }

/// The largest errors of q and p inside a step h from t = 1.
std::pair<float50, float50> errors(float50 const& h) {
    float50 const t(1);
    problem<std::remove_cvref_t<decltype(oscillator)>> const mechanics{oscillator, {}};
    dense_step const inside(mechanics, exact(t), exact(t + h));
    std::pair<float50, float50> worst{0, 0};
    for (int k = 1; k < 16; ++k) {
        float50 const at = t + h * k / 16;
        auto const x = inside(at), y = exact(at);
        CHECK(x.t == at);
        worst.first = std::max(worst.first, float50(abs(x.q - y.q)));
        worst.second = std::max(worst.second, float50(abs(x.p - y.p)));
    }
    return worst;
}

} // namespace

TEST_CASE("the slopes are q' = v and p' = dL/dq with the force, exactly") {
    auto const free = embed(oscillator, mid_point);
    auto const slopes = slopes_at(free.mechanics(), state<Q, Q>{0, Q(2), Q(5)}); // v = p - x/3
    CHECK(slopes.q == Q(13, 3));
    CHECK(slopes.p == Q(13, 9) - 2);
    auto const drag = [](auto const& t, auto const& x, auto const& v) { return t * x - v; };
    auto const damped =
        slopes_at(problem<std::remove_cvref_t<decltype(oscillator)>, decltype(drag)>{oscillator, drag}, state<Q, Q>{Q(3), Q(2), Q(5)});
    CHECK(damped.q == Q(13, 3));
    CHECK(damped.p == Q(13, 9) - 2 + 6 - Q(13, 3));
}

TEST_CASE("free fall is reproduced exactly in the rationals") {
    lagrangian const fall{[](auto const& x, auto const& v) { return v * v / 2 - x; }};
    auto const at = [](Q const& t) { return state<Q, Q>{t, 1 + t - t * t / 2, 1 - t}; };
    dense_output const path(embed(fall, mid_point).mechanics(), std::vector{at(Q(0)), at(Q(1, 3)), at(Q(2)), at(Q(7, 2))});
    for (int k = 0; k <= 35; ++k) CHECK(path(Q(k, 10)) == at(Q(k, 10)));
    CHECK_THROWS_WITH_AS((void)path(Q(-1)), "-1 is outside the interval [0, 7/2]", error::outside_domain);
    CHECK_THROWS_AS((void)path(Q(4)), error::outside_domain);
    CHECK_THROWS_AS(dense_output(embed(fall, mid_point).mechanics(), std::vector{at(Q(0))}), error::mismatch);
}

TEST_CASE("a step back is looked into as one that goes on") {
    auto const falls = [](auto const& q, auto const& v) { return v * v / 2 - q; };
    auto const flow = embed(falls, mid_point);
    state<double, double> const from{1.0, 1.0, 0.5}, to = flow.step(from, -0.5);
    dense_step<double, double> const between(flow.mechanics(), from, to);
    CHECK(between.at_fraction(0.5).t == 0.75);
    CHECK(std::abs(between(0.75).q - (1 - 0.5 * 0.25 - 0.25 * 0.25 / 2)) <= 4 * epsilon<double>());
    CHECK_THROWS_AS((void)between(1.25), error::outside_domain);
}

TEST_CASE("order 4 in q and in p, fitted in 50 digits") {
    auto const [q_coarse, p_coarse] = errors(float50(1) / 100);
    auto const [q_fine, p_fine] = errors(float50(1) / 200);
    CHECK(std::abs(order_of(q_coarse, q_fine) - 4) < 0.02);
    CHECK(std::abs(order_of(p_coarse, p_fine) - 4) < 0.02);
    // The interpolation error is h^4 |q''''| / 384 to leading order.
    CHECK(near(static_cast<double>(q_fine), std::cos(1.0) * std::pow(0.005, 4) / 384, 0.01));
}

TEST_CASE("points of a trajectory are met, and left continuously") {
    auto const flow = embed(pendulum, mid_point);
    auto const run = record(flow.along(uniform(0.0, 0.1, 20), 1.0, 0.5));
    dense_output const path(flow.mechanics(), run.states);
    for (auto const& x : run.states) CHECK(path(x.t) == x);
    double const tiny = 1e-9; // |q'|, |p'| <= 2 along this path
    for (std::size_t i = 1; i + 1 < run.states.size(); ++i) {
        auto const& x = run.states[i];
        for (double const t : {x.t - tiny, x.t + tiny}) {
            CHECK(std::abs(path(t).q - x.q) <= 2 * tiny);
            CHECK(std::abs(path(t).p - x.p) <= 2 * tiny);
        }
    }
    dense_step const first(flow.mechanics(), run.states[0], run.states[1]);
    CHECK_THROWS_AS((void)first(0.2), error::outside_domain);
    CHECK_THROWS_AS((void)first(std::nan("")), error::outside_domain);
}

} // namespace dense_output_tests
