// SPDX-License-Identifier: BSL-1.0
// Events are located to the scalar's epsilon, in their direction, lazily.
#include <doctest/doctest.h>

#include "hilger/trajectory/events.hpp"
#include "hilger/trajectory/recording.hpp"
#include "support/orders.hpp"
#include "support/systems.hpp"

namespace events_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

constexpr auto position = [](auto const& x) { return x.q; };
constexpr auto momentum = [](auto const& x) { return x.p; };

template <class Range>
auto first_of(Range const& range) {
    return *range.begin();
}
template <class Range>
std::vector<double> times(Range const& range) {
    std::vector<double> result;
    for (auto const& x : range) result.push_back(static_cast<double>(x.t));
    return result;
}
/// The same with a free particle, whose every scheme and dense output are exact: q = t - 2 in steps of 1/2.
template <class S>
auto passing_zero(S const& start) {
    lagrangian const free{[](auto const& x, auto const& v) { return v * v / 2 + 0 * x; }};
    return embed(free, mid_point).along(uniform(S(0), S(1) / S(2), 8), start, S(1));
}

} // namespace

TEST_CASE("a zero is located to epsilon") {
    auto const cube = [](auto const& x) { return x.q * x.q * x.q - x.q / 3 + 1; }; // one real zero
    auto const in_double = first_of(events(passing_zero(-2.0), cube));
    CHECK(in_double.t - 2 == doctest::Approx(-1.1107).epsilon(1e-4));
    CHECK(std::abs(cube(in_double)) <= 8 * 4 * epsilon<double>()); // |g'| < 4
    auto const in_wide = first_of(events(passing_zero(float50(-2)), cube));
    CHECK(abs(cube(in_wide)) <= 8 * 4 * epsilon<float50>());
    CHECK(static_cast<double>(abs(in_wide.t - 2 - in_double.t + 2)) < 1e-15);
}

TEST_CASE("the state at an event is at or behind the zero, wherever rounding has put it") {
    for (int k = 0; k < 32; ++k) {
        CAPTURE(k);
        auto const up = [k](auto const& x) { return x.q * x.q * x.q - x.q / 3 + k / 32.0; };
        auto const down = [up](auto const& x) { return -up(x); };
        CHECK(up(first_of(events(passing_zero(-2.0), up))) >= 0);
        CHECK(down(first_of(events(passing_zero(-2.0), down))) <= 0);
    }
}

TEST_CASE("directions, zeros at points of T, and none at the start") {
    CHECK(times(events(passing_zero(-1.75), position)) == std::vector{1.75});
    CHECK(times(events(passing_zero(-2.0), position)) == std::vector{2.0}); // g = 0 at t_4, seen once
    CHECK(times(events(passing_zero(-2.0), position, crossing::rising)) == std::vector{2.0});
    CHECK(times(events(passing_zero(-2.0), position, crossing::falling)).empty());
    CHECK(times(events(passing_zero(0.0), position)).empty());
    CHECK(times(events(passing_zero(-4.0), position)) == std::vector{4.0}); // the last point
    CHECK(times(events(passing_zero(1.0), position)).empty());
    auto const fold = [](auto const& x) { return (x.q + 1.125) * (x.q - 0.625); }; // + - +
    CHECK(times(events(passing_zero(-2.0), fold)) == std::vector{0.875, 2.625});
    CHECK(times(events(passing_zero(-2.0), fold, crossing::falling)) == std::vector{0.875});
    CHECK(times(events(passing_zero(-2.0), fold, crossing::rising)) == std::vector{2.625});
}

TEST_CASE("what reaches zero and stays there does at its first zero, and not at the next point of T") {
    // q = t - 1.8: a gap that closes, of any shape
    auto const gap = [](auto const& x) { return std::max(-x.q, 0.0); };
    auto const flat = [](auto const& x) { return std::pow(std::max(-x.q, 0.0), 3); };
    auto const contact = [](auto const& x) { return x.q < 0 ? x.q - 1 : 0.0; };
    for (auto const& at : {times(events(passing_zero(-1.8), gap)), times(events(passing_zero(-1.8), contact))}) {
        REQUIRE(at.size() == 1);
        CHECK(std::abs(at[0] - 1.8) <= 4 * epsilon<double>());
    }
    auto const cubed = times(events(passing_zero(-1.8), flat));
    REQUIRE(cubed.size() == 1);
    CHECK(std::abs(cubed[0] - 1.8) <= 4 * epsilon<double>());
    CHECK(times(events(passing_zero(-1.8), gap, crossing::falling)).size() == 1);
    CHECK(times(events(passing_zero(-1.8), gap, crossing::rising)).empty());
}

TEST_CASE("a recording of no events has no state") {
    auto const never = [](auto const& x) { return x.q - 100; };
    CHECK(record(events(passing_zero(-2.0), never)).states.empty());
    CHECK(record(events(passing_zero(-2.0), never), 3).states.empty());
    CHECK(record(events(passing_zero(-2.0), position)).states.size() == 1);
}

TEST_CASE("a condition is an event where it changes") {
    auto const free = [](auto const&, auto const& v) { return v * v / 2; };
    auto const path = embed(free, mid_point).along(uniform(0.0, 0.25, 16), -1.0, 1.0);
    auto const beyond = [](auto const& x) { return x.q > 0.1; };
    std::vector<double> times;
    for (auto const& x : events(path, beyond)) times.push_back(x.t);
    REQUIRE(times.size() == 1);
    CHECK(std::abs(times[0] - 1.1) <= 4 * epsilon<double>());
    int falling = 0;
    for (auto const& x : events(path, beyond, crossing::falling)) falling += x.t >= 0;
    CHECK(falling == 0);
    double end = 0;
    for (auto const& x : until(path, beyond, crossing::rising)) end = x.t;
    CHECK(end == times[0]);
}

TEST_CASE("a pole is no zero") {
    auto const free = embed(lagrangian{[](auto const&, auto const& v) { return v * v / 2; }}, mid_point);
    auto const path = free.along(uniform(0.0, 0.125, 40), 0.0, 1.0);
    auto const times = [&](auto const& g) {
        std::vector<double> all;
        for (auto const& x : events(path, g)) all.push_back(x.t);
        return all;
    };
    CHECK(times([](auto const& x) { return 1 / (x.q - 0.55); }).empty());
    auto const of_tangent = times([](auto const& x) { return std::tan(x.q); });
    REQUIRE(of_tangent.size() == 1);
    CHECK(std::abs(of_tangent[0] - std::acos(-1.0)) <= 8 * epsilon<double>());
    // A jump is one, as that of a condition is.
    CHECK(times([](auto const& x) { return x.q < 0.55 ? -1.0 : 3.0; }).size() == 1);
}

TEST_CASE("until ends at the event, or with the trajectory") {
    CHECK(times(until(passing_zero(-0.75), position)) == std::vector{0.0, 0.5, 0.75});
    CHECK(times(until(passing_zero(-1.0), position)) == std::vector{0.0, 0.5, 1.0});
    CHECK(times(until(passing_zero(3.0), position)) == times(passing_zero(3.0)));
    auto const run = record(until(passing_zero(-0.75), position));
    CHECK(run.states.back() == state<double, double>{0.75, 0, 1});
    auto const path = passing_zero(-0.75);
    auto at = path.begin();
    ++at;
    CHECK(times(until(path.resume(at.checkpoint()), position)) == std::vector{0.5, 0.75});
}

TEST_CASE("nothing behind the event is computed") {
    // The cubic system runs away and its steps fail after t = 0.9; its first event is before.
    auto const path = embed(cubic, mid_point).along(uniform(0.0, 0.1, 50), 1.0, 0.0);
    auto const g = [](auto const& x) { return x.q - 1.5; };
    double last = 0;
    for (auto const& x : until(path, g)) last = x.q;
    CHECK(last == doctest::Approx(1.5).epsilon(1e-14));
    auto const all = events(path, g);
    auto found = all.begin();
    CHECK(found->q == last);
    CHECK_THROWS_AS(++found, error::no_convergence);
    CHECK_THROWS_WITH_AS((void)first_of(events(path, [](auto const&) { return std::nan(""); })),
                         "the function whose zeros are events is NaN or infinite at t = 0", error::not_finite);
}

TEST_CASE("half periods of the pendulum are equal, and of order 2") {
    auto const half_period = [](float50 const& h) {
        auto const path = embed(pendulum, mid_point).along(uniform(float50(0), h, 2000), float50(1), float50(0));
        auto const zeros = events(path, momentum);
        auto at = zeros.begin();
        float50 const first = at->t;
        return std::pair<float50, float50>((++at)->t - first, first);
    };
    // 2 K(sin(1/2)): half a period at an amplitude of one radian, by the arithmetic-geometric mean
    float50 const exact("3.349987832185226356350605689580507713614038164486888");
    auto const [coarse, coarse_first] = half_period(float50(1) / 40);
    auto const [fine, fine_first] = half_period(float50(1) / 80);
    CHECK(std::abs(order_of(float50(coarse - exact), float50(fine - exact)) - 2) < 0.02);
    CHECK(static_cast<double>(abs(coarse - coarse_first)) < 1e-5);
}

TEST_CASE("a Poincare section of Henon and Heiles: the plane x = 0, one sheet, one energy") {
    lagrangian const henon_heiles{[](auto const& q, auto const& v) {
        auto const &x = q(0), &y = q(1);
        return v.dot(v) / 2 - (x * x + y * y) / 2 - x * x * y + y * y * y / 3;
    }};
    using vector = Eigen::Vector2d;
    auto const H = [](auto const& z) {
        double const x = z.q(0), y = z.q(1);
        return z.p.dot(z.p) / 2 + (x * x + y * y) / 2 + x * x * y - y * y * y / 3;
    };
    double const E = 1.0 / 12, y0 = 0.1, py0 = 0.05;
    double const px0 = std::sqrt(2 * E - py0 * py0 - y0 * y0 + 2 * y0 * y0 * y0 / 3);
    auto const path = embed(henon_heiles, mid_point).along(uniform(0.0, 0.02, 20'000), vector(0, y0), vector(px0, py0));
    int count = 0;
    for (auto const& z : events(
             path, [](auto const& x) { return x.q(0); }, crossing::rising)) {
        CHECK(std::abs(z.q(0)) <= 4 * epsilon<double>() * 0.01); // a step moves q by less than 0.01
        CHECK(z.p(0) > 0);
        // h^2 / 24 times third derivatives of this size; the points between the steps are no worse
        CHECK(std::abs(H(z) - E) < 2e-5);
        ++count;
    }
    CHECK(count > 55); // the period is near 2 pi: 400 / (2 pi) = 63.7
    CHECK(count < 70);
}

} // namespace events_tests
