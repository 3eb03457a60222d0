// SPDX-License-Identifier: BSL-1.0
// Solutions to an accuracy with fractional damping: met against numbers known otherwise, at the points and between them, over times where a
// force switches, for vectors and several terms; and the grading that they use, chosen from the stages and the order.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "hilger/fractional/accuracy.hpp"
#include "hilger/history/history.hpp"
#include "hilger/multiprecision.hpp"
#include "series.hpp"

namespace fractional_accuracy_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

constexpr auto pendulum = [](auto const& x, auto const& v) { return v * v / 2 + cos(x); };
constexpr auto oscillator = [](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; };
constexpr fraction<1, 2> half{};

/// t^3 + 6t + 3.2/sqrt(pi) t^{5/2}: with it x'' + x + D^{1/2} x = 0 becomes the equation of t^3.
struct force_of_a_cube {
    template <class X>
    auto operator()(double t, X const& x, X const&) const {
        return 0 * x + t * t * t + 6 * t + 3.2 / std::sqrt(std::acos(-1.0)) * t * t * std::sqrt(t);
    }
};
/// 1 from `at` on.
struct push {
    double at;
    template <class T, class X>
    auto operator()(T const& t, X const& x, X const& v) const {
        return (t < at ? 0.0 : 1.0) + 0 * x + 0 * v;
    }
    [[nodiscard]] std::vector<double> switching_times(double, double) const { return {at}; }
};

} // namespace

TEST_CASE("a pendulum with memory, to the accuracy that is wanted") {
    double const at_one = 1.34165212463519; // with six stages
    for (double const wanted : {1e-2, 1e-6, 1e-10, 1e-12}) {
        CAPTURE(wanted);
        auto const x = solve(with_fractional_damping(pendulum, 1.0, half), interval{0.0, 1.0}, {.q0 = 1.0, .v0 = 1.0}, accuracy{wanted});
        CHECK(std::abs(x.end.q - at_one) <= std::min(wanted, x.error + 1e-14));
        CHECK(x.error <= wanted);
        CHECK(std::string(x.method) == (wanted > 1e-8 ? "Galerkin, 3 Radau nodes" : "Galerkin, 5 Radau nodes"));
        CHECK(x.steps <= 100);
        CHECK(x.evaluated_steps > x.steps);
    }
}

TEST_CASE("at every point and between points; the weights and the history of the damping do not matter") {
    auto const cube = with_force(oscillator, force_of_a_cube{});
    auto const solution = [&](auto const& damped) { return solve(damped, interval{0.0, 1.0}, {.q0 = 0.0, .v0 = 0.0}, accuracy{1e-11}); };
    auto const x = solution(with_fractional_damping(cube, 1.0, half));
    for (index_type i = 0; i <= x.steps; ++i) {
        double const t = x.q.root().element(i);
        CHECK(std::abs(x.q[i] - t * t * t) <= 1e-11);
        CHECK(std::abs(x.p[i] - 3 * t * t) <= 1e-10);
        CHECK(x(t).p == x.p[i]);
    }
    for (double const t : {1e-300, 1e-9, 0.01, 0.13, 0.5, 0.77, 1 - 1e-9}) {
        CAPTURE(t);
        CHECK(x(t).t == t);
        CHECK(std::abs(x(t).q - t * t * t) <= 1e-11);
        CHECK(std::abs(x(t).p - 3 * t * t) <= 1e-10);
    }
    CHECK(solution(with_fractional_damping<bdf<2>>(cube, 1.0, half, blocks{})).end.q == x.end.q);
}

TEST_CASE("components and several terms, of orders below and above 1") {
    using V = Eigen::Vector2d;
    auto const L = [](auto const& q, auto const& v) { return v.dot(v) / 2 - 2 * q.dot(q); };
    auto const exact = [](double beta) { return fractional_oscillator<float50>{1.5, float50(beta), 4, 1, 0, 0}.at(float50(2)); };
    auto const x = solve(with_fractional_damping(L, V(0, 1.5), half), interval{0.0, 2.0}, initial_velocity<V>{{1, 1}, {0, 0}}, 1e-10);
    CHECK(std::abs(x.end.q(0) - std::cos(4.0)) <= 1e-10);
    CHECK(std::abs(x.end.q(1) - static_cast<double>(exact(0.5).u)) <= 1e-10);
    CHECK(std::abs(x.end.p(1) - static_cast<double>(exact(0.5).v)) <= 1e-9);
    auto const one = [](auto const& q, auto const& v) { return v * v / 2 - 2 * q * q; };
    auto const end = [&](std::vector<fractional_term<double>> const& terms) {
        return solve(with_fractional_damping(one, terms), interval{0.0, 2.0}, {.q0 = 1.0, .v0 = 0.0}, 1e-10).end.q;
    };
    CHECK(std::abs(end({{1.0, 0.5}, {0.5, 0.5}}) - static_cast<double>(exact(0.5).u)) <= 1e-10);
    CHECK(std::abs(end({{1.5, 1.25}}) - static_cast<double>(exact(1.25).u)) <= 1e-10);
}

TEST_CASE("over a time at which a force switches the order stays") {
    auto const solution = [](double at, double wanted) {
        return solve(with_fractional_damping(with_force(oscillator, push{at}), 0.2, half), interval{0.0, 3.0}, {.q0 = 0.0, .v0 = 0.0},
                     accuracy{wanted});
    };
    // From rest, the motion begins with the push.
    auto const from_start = solution(0.0, 1e-11), later = solution(0.7, 1e-11);
    CHECK(later.steps <= 512);
    CHECK(std::abs(later.q[1]) <= 1e-14);
    CHECK(std::abs(later.end.q - from_start(2.3).q) <= 2e-11);
    CHECK(std::abs(later(1.7).q - from_start(1.0).q) <= 2e-11);
    CHECK(later.error <= 1e-11);
    // A jump that is not declared leaves little of the order, and the accuracy is met all the same.
    auto const hidden = [](auto const& t, auto const& x, auto const& v) { return (t < 0.7 ? 0.0 : 1.0) + 0 * x + 0 * v; };
    auto const met = solve(with_fractional_damping(with_force(oscillator, hidden), 0.2, half), interval{0.0, 3.0}, {.q0 = 0.0, .v0 = 0.0},
                           accuracy{1e-3});
    CHECK(std::abs(met.end.q - later.end.q) <= 1e-3);
    CHECK(met.steps > later.steps);
}

TEST_CASE("what cannot be reached is refused") {
    auto const damped = with_fractional_damping(pendulum, 1.0, half);
    initial_velocity<double> const from{1.0, 1.0};
    for (double const wanted : {0.0, -1e-3, 1e-15, std::nan("")})
        CHECK_THROWS_AS((void)solve(damped, interval{0.0, 1.0}, from, accuracy{wanted}), error::invalid_parameter);
    CHECK_THROWS_AS((void)solve(damped, interval{1.0, 0.0}, from, accuracy{1e-6}), error::invalid_scale);
    CHECK_THROWS_AS((void)solve(damped, interval{0.0, 1.0}, from, accuracy{1e-6, -1.0}), error::invalid_parameter);
    CHECK_THROWS_AS((void)with_fractional_damping(pendulum, 1.0, 2.0), error::invalid_parameter);
    CHECK_THROWS_AS((void)with_fractional_damping(pendulum, 1.0, -0.5), error::invalid_parameter);
    accuracy goal{1e-6, 1e-4};
    std::stop_source stop;
    stop.request_stop();
    goal.stop = stop.get_token();
    CHECK_THROWS_WITH_AS((void)solve(damped, interval{0.0, 1.0}, from, goal), doctest::Contains("was given up on request"),
                         error::no_convergence);
}

TEST_CASE("gamma from the number of stages and the order: (2s - 1) / (3 - beta)") {
    auto const flow = [](auto const& beta) {
        return embed(with_fractional_damping(pendulum, 1.0, beta, exponentials{}), galerkin<4, radau>);
    };
    auto const gamma = [&](double beta) { return flow(beta).damping().template grading<double>(); };
    CHECK(gamma(0.5) == doctest::Approx(2.8));
    CHECK(gamma(1.5) == doctest::Approx(2.8));
    CHECK(gamma(1.0) == doctest::Approx(7.0 / 3));
    auto const both = embed(with_fractional_damping(pendulum, {{1.0, 1.25}, {1.0, 0.5}}, exponentials{}), galerkin<4, radau>);
    CHECK(both.damping().grading<double>() == doctest::Approx(2.8)); // the larger one
    auto const one_stage = embed(with_fractional_damping(pendulum, 1.0, half, exponentials{}), galerkin<1, radau>);
    CHECK(one_stage.damping().grading<double>() == 1);
    CHECK(graded(0.0, 1.0, 24, flow(0.5)).same_points(graded(0.0, 1.0, 24, gamma(0.5))));
    CHECK(graded_start(0.0, 3.0, 0.1, flow(0.5)).same_points(graded_start(0.0, 3.0, 0.1, gamma(0.5))));
    CHECK_THROWS_AS((void)graded(1.0, 0.0, 24, flow(0.5)), error::invalid_scale);
    // With it the error of x(1) has the order of the steps behind the start.
    auto const error = [&](int N) {
        double last = 0;
        for (auto const& x : flow(0.5).along(graded(0.0, 1.0, N, flow(0.5)), {.q0 = 1.0, .v0 = 1.0})) last = x.q;
        return std::abs(last - 1.34165212463519);
    };
    CHECK(std::log2(error(8) / error(16)) >= 6);
}

} // namespace fractional_accuracy_tests
