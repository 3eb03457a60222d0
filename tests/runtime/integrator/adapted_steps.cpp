// SPDX-License-Identifier: BSL-1.0
// Steps that follow the motion: close encounters, a light mass on a heavy one, kinks and jumps that nothing announces, units, ends of the
// motion. Errors are known from closed forms, or from a problem with the same motion and other equations.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace adapted_steps_tests {

using namespace hilger;
using plane = Eigen::Vector2d;

namespace {

constexpr auto kepler = [](auto const& q, auto const& v) { return v.squaredNorm() / 2 + 1 / q.norm(); };
/// Kepler's ellipse of eccentricity e at t, from its nearest point.
plane ellipse(double e, double t) {
    double const period = 2 * std::acos(-1.0);
    t -= period * std::floor(t / period);
    double E = period / 2; // from there Newton's method converges for every e
    for (int i = 0; i < 200; ++i) E = E - (E - e * std::sin(E) - t) / (1 - e * std::cos(E));
    return {std::cos(E) - e, std::sqrt(1 - e * e) * std::sin(E)};
}
initial_velocity<plane> nearest(double e) { return {{1 - e, 0}, {0, std::sqrt((1 + e) / (1 - e))}}; }
constexpr auto oscillator = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };

} // namespace

TEST_CASE("close encounters: short steps where the motion is fast, and there alone") {
    for (double const e : {0.6, 0.9, 0.99}) {
        CAPTURE(e);
        auto const x = solve(kepler, interval{0.0, 20.0}, nearest(e), accuracy{1e-9});
        double worst = 0, shortest = 1, longest = 0;
        for (index_type i = 0; i <= x.steps; ++i) worst = std::max(worst, (x.q[i] - ellipse(e, x.q.root().element(i))).norm());
        for (index_type i = 0; i < x.steps; ++i) {
            shortest = std::min(shortest, x.q.root().step(i));
            longest = std::max(longest, x.q.root().step(i));
        }
        CHECK(worst <= 1e-9);
        // The ratio of the velocities, (1 + e) / (1 - e), tells how uneven the steps are; equal ones would be 20 / shortest.
        CHECK(longest > (1 + e) / (1 - e) / 2 * shortest);
        CHECK(4 * static_cast<double>(x.steps) < 20 / shortest);
        CHECK(x.steps < 400);
    }
}

TEST_CASE("a light cart under a heavy pendulum moves as the pendulum alone with the mass that it has then") {
    double const M = 1, m = 1e4, g = 9.81;
    auto const cart = [=](auto const& q, auto const& v) {
        return (M + m) * v(0) * v(0) / 2 + m * v(0) * v(1) * cos(q(1)) + m * v(1) * v(1) / 2 + m * g * cos(q(1));
    };
    // The momentum of the cart is 0: (M + m) x + m sin(angle) stays.
    auto const reduced = [=](auto const& q, auto const& v) { return (1 - m / (M + m) * cos(q) * cos(q)) * v * v / 2 + g * cos(q); };
    for (double const angle : {1.0, 2.0, 3.0}) {
        CAPTURE(angle);
        auto const x = solve(cart, interval{0.0, 5.0}, initial_velocity<plane>{{0, angle}, {0, 0}}, accuracy{1e-8});
        auto const y = solve(reduced, interval{0.0, 5.0}, initial_velocity<double>{angle, 0}, accuracy{1e-9});
        CHECK(std::abs(x.end.q(1) - y.end.q) <= 1.2e-8);
        for (index_type i = 0; i <= x.steps; ++i)
            CHECK(std::abs(x.q[i](0) - m / (M + m) * (std::sin(angle) - std::sin(x.q[i](1)))) <= 2e-8);
    }
    // Its velocities have the rounding of 10^4 kg: that is said, and not taken for a force without bound.
    CHECK_THROWS_WITH_AS((void)solve(cart, interval{0.0, 3.0}, initial_velocity<plane>{{0, 2}, {0, 0}}, accuracy{1e-13}),
                         doctest::Contains("rounding keeps it there"), error::no_convergence);
}

TEST_CASE("jumps and kinks that nothing announces are stepped over by short steps") {
    for (int k = 0; k < 12; ++k) {
        double const s = 0.5 + 0.7615 * k;
        CAPTURE(s);
        auto const push = [s](auto const& t, auto const& q, auto const& v) { return (t < s ? 0.0 : 1.0) + 0 * q + 0 * v; };
        for (double const wanted : {1e-4, 1e-8}) {
            auto const x = solve(with_force(oscillator, push), interval{0.0, 10.0}, initial_velocity<double>{1.0, 0.0}, accuracy{wanted});
            double worst = 0;
            for (index_type i = 0; i <= x.steps; ++i) {
                double const t = x.q.root().element(i);
                worst = std::max(worst, std::abs(x.q[i] - std::cos(t) - (t > s ? 1 - std::cos(t - s) : 0)));
            }
            CHECK(worst <= wanted);
            CHECK(x.steps < 1000);
        }
    }
    // A ball falls on a spring of Hertz, and leaves as fast as it came.
    auto const contact = [](auto const& q, auto const& v) { return v * v / 2 - (q < 0 ? pow(-q, 2.5) * 0.4 : 0 * q); };
    auto const x = solve(contact, interval{0.0, 5.0}, initial_velocity<double>{0.5, -1.0}, accuracy{1e-11});
    CHECK(std::abs(x.end.p - 1) <= 1e-10);
    // 2 (25/16)^(2/5) sqrt(pi) Gamma(2/5) / (5 Gamma(9/10)) for a contact of unit stiffness and velocity
    CHECK(std::abs(x.end.q - (5 - 0.5 - 3.2180654597190431)) <= 1e-10);
}

TEST_CASE("the points do not depend on the unit, and a run repeated gives the same bits") {
    auto const from = nearest(0.6);
    auto const x = solve(kepler, interval{0.0, 10.0}, from, accuracy{1e-7}),
               again = solve(kepler, interval{0.0, 10.0}, from, accuracy{1e-7});
    for (double const unit : {std::ldexp(1.0, -30), std::ldexp(1.0, 20)}) { // powers of 2: not even the rounding depends on it
        CAPTURE(unit);
        auto const scaled = [=](auto const& q, auto const& v) { return v.squaredNorm() / 2 + unit * unit * unit / q.norm(); };
        auto const y = solve(scaled, interval{0.0, 10.0}, initial_velocity<plane>{from.q0 * unit, from.v0 * unit}, accuracy{1e-7 * unit});
        REQUIRE(y.steps == x.steps);
        CHECK(std::string(y.method) == x.method);
        for (index_type i = 0; i <= x.steps; ++i) {
            CHECK(y.q.root().element(i) == x.q.root().element(i));
            CHECK(y.q[i] == x.q[i] * unit);
            CHECK(again.q[i] == x.q[i]);
        }
    }
    // Two atoms of argon in metres: an accuracy of 1e-18 is coarse beside 4e-10.
    double const mass = 6.6335e-26 / 2, depth = 1.65e-21, sigma = 3.4e-10;
    auto const argon = [=](auto const& q, auto const& v) {
        auto const s = sigma / q, s2 = s * s, s6 = s2 * s2 * s2;
        return mass * v * v / 2 - 4 * depth * (s6 * s6 - s6);
    };
    auto const at = [&](double wanted) { return solve(argon, interval{0.0, 1e-11}, {.q0 = 4.2e-10, .v0 = 0.0}, accuracy{wanted}); };
    auto const fine = at(1e-20);
    for (double const wanted : {1e-13, 1e-16, 1e-18}) CHECK(std::abs(at(wanted).end.q - fine.end.q) <= wanted + 1e-20);
    CHECK_THROWS_AS((void)at(1e-25), error::invalid_parameter);
}

TEST_CASE("an accuracy relative to the largest position, alone or beside another") {
    interval const I{0.0, 10.0};
    for (accuracy const& goal : {accuracy{.relative = 1e-9}, accuracy{.wanted = 1e-9, .relative = 1e-9}}) {
        auto const x = solve(kepler, I, nearest(0.6), goal);
        double worst = 0;
        for (index_type i = 0; i <= x.steps; ++i) worst = std::max(worst, (x.q[i] - ellipse(0.6, x.q.root().element(i))).norm());
        CHECK(worst <= 1.6e-9 + goal.wanted);
        CHECK(x.error <= 1.6e-9 + goal.wanted);
    }
    // What grows to 10^8 is had to 10^-9 of that.
    auto const hill = [](auto const& q, auto const& v) { return v * v / 2 + q * q / 2; };
    auto const x = solve(hill, interval{0.0, 20.0}, {.q0 = 1.0, .v0 = 0.0}, accuracy{.relative = 1e-9});
    CHECK(std::abs(x.end.q / std::cosh(20.0) - 1) <= 1e-9);
    CHECK_THROWS_AS((void)solve(hill, I, {.q0 = 1.0, .v0 = 0.0}, accuracy{.relative = 1e-15}), error::invalid_parameter);
    CHECK_THROWS_AS((void)solve(hill, I, {.q0 = 1.0, .v0 = 0.0}, accuracy{.relative = -1e-5}), error::invalid_parameter);
    CHECK_THROWS_AS((void)solve(hill, I, {.q0 = 1.0, .v0 = 0.0}, accuracy{}), error::invalid_parameter);
}

TEST_CASE("a motion into a collision ends in an error that has its last state") {
    // From rest at a distance of 1 it takes pi / (2 sqrt 2).
    try {
        (void)solve(kepler, interval{0.0, 20.0}, initial_velocity<plane>{{1, 0}, {0, 0}}, accuracy{1e-8});
        FAIL("there is no motion behind a collision");
    } catch (error::no_convergence const& why) {
        auto const* where = dynamic_cast<interrupted<double, plane> const*>(&why);
        REQUIRE(where != nullptr);
        CHECK(std::abs(where->last.t - std::acos(-1.0) / std::sqrt(8.0)) <= 1e-6);
        CHECK(where->last.q.norm() < 1e-3);
        CHECK(std::string(why.what()).find("no step is short enough") != std::string::npos);
    }
}

TEST_CASE("other points divide a walk into half as many steps again") {
    std::vector<double> const t{0, 1, 2, 4, 8, 9};
    auto const all = detail::other_points(t, 0, 5);
    REQUIRE(all.size() == 8);
    CHECK(all.back() == 9);
    for (std::size_t j = 1; j < all.size(); ++j) CHECK(all[j - 1] < all[j]);
    for (std::size_t j = 0; j + 1 < all.size(); ++j) // none is a point of the walk
        CHECK(std::find(t.begin(), t.end(), all[j]) == t.end());
    CHECK(detail::other_points(t, 3, 4) == std::vector<double>{6, 8});
}

} // namespace adapted_steps_tests
