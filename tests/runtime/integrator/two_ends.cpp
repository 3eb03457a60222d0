// SPDX-License-Identifier: BSL-1.0
// Problems between two ends with none, one and two solutions: each is found, or refused in one sentence, or said to be near no motion.
#include <doctest/doctest.h>

#include <cmath>

#include "hilger/multiprecision.hpp"
#include "joined_by.hpp"

namespace two_ends_tests {

using namespace hilger;
using namespace testing::two_ends;

namespace {

constexpr lagrangian oscillator{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
constexpr lagrangian descent{[](auto const& x, auto const& v) { return sqrt((1 + v * v) / (2 * x)); }};
constexpr lagrangian pendulum{[](auto const& x, auto const& v) { return v * v / 2 + cos(x); }};

} // namespace

TEST_CASE("half a period apart the ends of an oscillator determine little, which is said with the number") {
    double const pi = std::acos(-1.0);
    for (index_type const N : {100, 300, 1000}) {
        auto const T = uniform(interval{0.0, pi}, N);
        auto const f = joined_by(oscillator, T, 0.0, 1.0);
        double const angle = 2 * std::atan(T.h() / 2); // of a step of the mid-point rule
        CHECK(std::abs(f.report.response * std::abs(std::sin(static_cast<double>(N) * angle)) - 2) <= 0.01);
        CHECK(f.report.warning.find("the ends hardly determine what lies between them: it changes by ") == 0);
        CHECK(f.relative <= 16);
    }
    CHECK_THROWS_WITH_AS((void)joined_by(oscillator, uniform(interval{0.0, pi}, 10000), 0.0, 1.0),
                         doctest::Contains("the ends hardly determine what lies between them"), error::ill_conditioned);
    auto const T = uniform(interval{0.0, pi}, 300);
    auto const of_order_four = equation_of(embed(oscillator, galerkin<2, gauss>), T);
    CHECK_THROWS_AS((void)solve(of_order_four, T, boundary_values{0.0, 1.0}), error::ill_conditioned);
}

TEST_CASE("an ordinary problem responds to its ends as strongly in all steps and units") {
    for (double const unit : {1.0, 1e-9, 1e6}) {
        lagrangian const L{[unit](auto const& x, auto const& v) { return v * v / 2 - x * x / (2 * unit * unit); }};
        for (index_type const N : {20, 1000}) {
            auto const f = joined_by(L, uniform(interval{0.0, unit}, N), 1e-3, 2e-3);
            CHECK(std::abs(f.report.response - 2 * std::sin(0.5) / std::sin(1.0)) <= 1e-3);
            CHECK(f.report.warning.empty());
            CHECK(f.relative <= 16);
        }
    }
}

TEST_CASE("responses to both ends add up, whatever their signs") {
    double const T = 1.8 * std::acos(-1.0); // (sin(T - t) - sin t) / sin T is larger than their sum
    auto const f = joined_by(oscillator, uniform(interval{0.0, T}, 1000), 1.0, 1.0);
    CHECK(std::abs(f.report.response * std::sin(T / 2) - 1) <= 1e-3);
}

TEST_CASE("catenoids: two between near rings") {
    auto const shallow = joined_by(catenoid, uniform(interval{-0.5, 0.5}, 400), 1.0, 1.0);
    CHECK(std::abs(shallow.middle() - 0.848337938094979) <= 1e-5); // c cosh(1 / (2 c)) = 1
    auto const T = uniform(interval{-0.5, 0.5}, 400);
    auto const deep =
        joined_by(catenoid, T, 1.0, 1.0, function_on(T, [](double t) { return 0.25 * std::cosh(t / 0.25) - 0.25 * std::cosh(2.0) + 1; }));
    CHECK(std::abs(deep.middle() - 0.235094990234533) <= 1e-4);
    for (auto const* f : {&shallow, &deep}) {
        CHECK(f->relative <= 16);
        CHECK(f->report.warning.empty());
    }
}

TEST_CASE("Bratu's problem u'' + lambda e^u = 0: two solutions below 3.5138, none above") {
    auto const bratu = [](double lambda) {
        return lagrangian{[lambda](auto const& u, auto const& v) { return v * v / 2 - lambda * exp(u); }};
    };
    auto const T = uniform(interval{0.0, 1.0}, 200);
    auto const lower = joined_by(bratu(2), T, 0.0, 0.0);
    auto const upper = joined_by(bratu(2), T, 0.0, 0.0, function_on(T, [](double t) { return 10 * t * (1 - t); }));
    CHECK(std::abs(lower.middle() - 0.328952421341114) <= 1e-5); // 2 log cosh(theta / 4), theta = 2 cosh(theta / 4)
    CHECK(std::abs(upper.middle() - 2.89553126549277) <= 1e-3);
    for (auto const* f : {&lower, &upper}) {
        CHECK(f->relative <= 16);
        CHECK(f->report.warning.empty());
    }
    CHECK_THROWS_AS((void)joined_by(bratu(4), T, 0.0, 0.0), error::no_convergence);
}

TEST_CASE("a pendulum that is at the bottom twice, 10 apart: at rest, after half a swing, after a whole one") {
    auto const T = uniform(interval{0.0, 10.0}, 400);
    double const pi = std::acos(-1.0);
    auto const swings = [&](double most, double times) {
        return joined_by(pendulum, T, 0.0, 0.0, function_on(T, [=](double t) { return most * std::sin(times * pi * t / 10); })).x;
    };
    for (double const x : joined_by(pendulum, T, 0.0, 0.0).x) CHECK(x == 0);
    CHECK(std::abs(swings(3, 1)[200] - 3.08764330023917) <= 1e-3); // 2 K(sin(a / 2)) = 10
    CHECK(std::abs(swings(2, 2)[100] - 2.43990697162123) <= 2e-3); // 4 K = 10
}

TEST_CASE("fastest descent: from rest L is singular, and near it a discrete solution is near no motion") {
    auto const from = [](double y0, index_type N) {
        return joined_by(descent, uniform(interval{0.0, 1.0907025731743183}, N), y0, 1.4161468365471424);
    };
    CHECK_THROWS_WITH_AS((void)from(0.0, 100),
                         doctest::Contains("the derivatives of L are infinite or no numbers at t = 0, q = 0, where the first guess"),
                         error::not_finite);
    for (index_type const N : {100, 101, 200}) // of 1000 steps it is refused
        CHECK(from(0.01, N).report.warning.find("the solution may be near no motion: on every second point it is") == 0);
    auto const smooth = from(0.1, 400);
    CHECK(smooth.report.warning.empty());
    CHECK(smooth.relative <= 16);
}

} // namespace two_ends_tests
