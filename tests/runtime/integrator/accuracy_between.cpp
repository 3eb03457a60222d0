// SPDX-License-Identifier: BSL-1.0
// Solutions between two ends to an accuracy, against closed forms.
#include <doctest/doctest.h>

#include <cmath>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace accuracy_between_tests {

using namespace hilger;

namespace {

constexpr lagrangian oscillator{[](auto const& x, auto const& v) { return (v * v - x * x) / 2; }};
constexpr lagrangian catenoid{[](auto const& x, auto const& v) { return x * sqrt(1 + v * v); }};
constexpr lagrangian layer{[](auto const& x, auto const& v) { return v * v / 2000000 + x * x / 2; }}; // of width 1/1000

template <class X, class Exact>
auto error_of(X const& x, Exact const& exact) {
    auto most = x.error - x.error;
    auto const& T = x.q.root();
    for (index_type i = 0; i < T.size(); ++i) most = std::max(most, decltype(most)(magnitude(exact(T.element(i)) - x.q[i])));
    return most;
}

} // namespace

TEST_CASE("an oscillator, positions and momenta") {
    for (double const wanted : {1e-3, 1e-8, 1e-12}) {
        auto const x = solve(oscillator, interval{0.0, 2.0}, {.q0 = 0.0, .qN = 1.0}, accuracy{wanted});
        CHECK(x.error <= wanted);
        CHECK(error_of(x, [](double t) { return std::sin(t) / std::sin(2.0); }) <= wanted);
        for (index_type i = 0; i <= x.steps; ++i) CHECK(std::abs(x.p[i] - std::cos(x.q.root().element(i)) / std::sin(2.0)) <= 100 * wanted);
    }
}

TEST_CASE("a throw in the plane, and against a drag") {
    lagrangian const throws{[](auto const& x, auto const& v) { return v.dot(v) / 2 - x(1); }};
    auto const x = solve(throws, interval{0.0, 2.0}, {.q0 = {0.0, 0.0}, .qN = {4.0, 1.0}}, 1e-10);
    CHECK(error_of(x, [](double t) { return Eigen::Vector2d(2 * t, 1.5 * t - t * t / 2); }) <= 1e-10);
    lagrangian const free{[](auto const&, auto const& v) { return v * v / 2; }};
    auto const y =
        solve(with_force(free, [](auto const&, auto const& v) { return -v; }), interval{0.0, 1.0}, {.q0 = 0.0, .qN = 1.0}, 1e-10);
    CHECK(error_of(y, [](double t) { return (1 - std::exp(-t)) / (1 - std::exp(-1.0)); }) <= 1e-10);
}

TEST_CASE("a catenary") {
    double const c = 0.848337938094979; // c cosh(1 / (2 c)) = 1
    auto const x = solve(catenoid, interval{-0.5, 0.5}, {.q0 = 1.0, .qN = 1.0}, 1e-10);
    CHECK(error_of(x, [c](double t) { return c * std::cosh(t / c); }) <= 1e-10);
    CHECK_THROWS_AS((void)solve(catenoid, interval{-1.0, 1.0}, {.q0 = 1.0, .qN = 1.0}, 1e-10), error::no_convergence);
}

TEST_CASE("in a boundary layer the steps are short, and nowhere else") {
    auto const exact = [](double t) { return std::exp((t - 1) * 1000); };
    auto const x = solve(layer, interval{0.0, 1.0}, {.q0 = 0.0, .qN = 1.0}, 1e-8);
    CHECK(error_of(x, exact) <= 1e-8);
    double shortest = 1, longest = 0;
    for (index_type i = 0; i < x.steps; ++i) {
        shortest = std::min(shortest, x.q.root().step(i));
        longest = std::max(longest, x.q.root().step(i));
    }
    CHECK(longest >= 1.0 / 16);
    CHECK(static_cast<double>(x.steps) * 8 <= 1 / shortest); // equal steps as short are eight times as many
}

TEST_CASE("to 40 digits") {
    auto const x = solve(oscillator, interval{float50(0), float50(1)}, {.q0 = 0, .qN = 1}, accuracy{1e-40});
    CHECK(error_of(x, [](float50 const& t) { return float50(sin(t) / sin(float50(1))); }) <= float50(1e-40));
}

TEST_CASE("an accuracy that is none, and ends that do not fit") {
    CHECK_THROWS_AS((void)solve(oscillator, interval{0.0, 1.0}, {.q0 = 0.0, .qN = 1.0}, 0.0), error::invalid_parameter);
    CHECK_THROWS_AS((void)solve(oscillator, interval{0.0, 1.0}, {.q0 = 0.0, .qN = std::nan("")}, 1e-8), error::not_finite);
    for (double const longest : {-1.0, std::nan(""), 1e-5})
        CHECK_THROWS_AS((void)solve(oscillator, interval{0.0, 1.0}, {.q0 = 0.0, .qN = 1.0}, accuracy{1e-8, longest}),
                        error::invalid_parameter);
}

} // namespace accuracy_between_tests
