// SPDX-License-Identifier: BSL-1.0
// Flows with fractional damping: what is damped and what is not, in any embedding; only damped components of a fractional order keep a
// history; and bad input is refused.
#include <type_traits>

#include <doctest/doctest.h>

#include "orders.hpp"
#include "support/histories.hpp"
#include "support/systems.hpp"

namespace fractional_flow_tests {

using namespace hilger;
using namespace hilger::testing;

TEST_CASE("a constant is not damped by Caputo's derivative, nor is uniform motion for an order above 1") {
    constexpr lagrangian free{[](auto const& x, auto const& v) { return v * v / 2 + 0 * x; }};
    auto const T = uniform(0.0, 0.1, 40);
    auto const last = [&](auto beta, double p0) {
        return positions(embed(with_fractional_damping(free, 1.0, beta), mid_point), T, 1.0, p0).back();
    };
    CHECK(last(0.5, 0.0) == 1.0);
    CHECK(last(1.0, 0.0) == 1.0);
    CHECK(std::abs(last(1.5, 0.25) - 2) <= 40 * epsilon<double>()); // 40 steps round
    CHECK(last(0.5, 0.25) < 1.8);
}

TEST_CASE("components without a coefficient move as if nothing were damped, and keep nothing") {
    constexpr lagrangian two{[](auto const& x, auto const& v) { return v.dot(v) / 2 + cos(x(0)) - x(1) * x(1); }};
    constexpr lagrangian second{[](auto const& x, auto const& v) { return v * v / 2 - x * x; }};
    auto const T = uniform(0.0, 0.1, 30);
    Eigen::Vector2d const q0(1, -1), p0(0.5, 0.25);
    auto const damped = with_fractional_damping(two, Eigen::Vector2d(0, 0.5), fraction<1, 2>{});
    auto const both = positions(embed(damped, mid_point), T, q0, p0);
    auto const first = positions(embed(pendulum, mid_point), T, 1.0, 0.5);
    auto const other = positions(embed(with_fractional_damping(second, 0.5, fraction<1, 2>{}), mid_point), T, -1.0, 0.25);
    for (std::size_t k = 0; k < both.size(); ++k) {
        CHECK(std::abs(both[k](0) - first[k]) < 64 * epsilon<double>());
        CHECK(std::abs(both[k](1) - other[k]) < 64 * epsilon<double>());
    }
    // The same for vectors whose dimension is known at run time only.
    auto const dynamic =
        positions(embed(with_fractional_damping(two, Eigen::VectorXd(Eigen::Vector2d(0, 0.5)), fraction<1, 2>{}), mid_point), T,
                  Eigen::VectorXd(q0), Eigen::VectorXd(p0));
    for (std::size_t k = 0; k < both.size(); ++k) CHECK((dynamic[k] - both[k]).norm() < 256 * epsilon<double>());

    auto const kept_after_20 = [&](auto const& flow, auto const& q, auto const& p) {
        using V = std::remove_cvref_t<decltype(q)>;
        typename std::remove_cvref_t<decltype(flow)>::template memory<double, V> memory(flow, 0.1, q);
        state<double, V> x{0.0, q, p};
        for (int k = 0; k < 20; ++k) memory.advance(flow, x, 0.1);
        return testing::numbers_of_histories(memory, flow);
    };
    CHECK(kept_after_20(embed(damped, mid_point), q0, p0) == 21);
    CHECK(kept_after_20(embed(with_fractional_damping(two, 0.5, 0.5), mid_point), q0, p0) == 2 * 21);
    CHECK(kept_after_20(embed(with_fractional_damping(two, 0.5, 1.0), mid_point), q0, p0) == 0);
    CHECK(kept_after_20(embed(with_fractional_damping<bdf<2>>(two, 0.5, fraction<1>{}), mid_point), q0, p0) == 0);
    CHECK(kept_after_20(embed(with_fractional_damping(two, 0.0, 0.5), mid_point), q0, p0) == 0);
}

TEST_CASE("any embedding, forces and compensated sums can be damped; a checkpoint takes the history with it") {
    auto const T = uniform(0.0, 0.05, 100);
    auto const friction = [](auto const& x, auto const& v) { return -v / 10 + 0 * x; };
    auto const end = [&](auto const& flow) { return positions(flow, T, 1.0, 0.5).back(); };
    auto const damp = [](auto const& L) { return with_fractional_damping(L, 0.3, fraction<1, 2>{}); };
    double const expected = end(embed(damp(pendulum), mid_point));
    CHECK(end(embed(damp(pendulum), mid_point, compensated)) == doctest::Approx(expected).epsilon(1e-13));
    // What is apart halves with the steps, and becomes a quarter: one scheme is of order one.
    auto const apart = [&](auto const& how, int N) {
        auto const on = uniform(interval{0.0, 5.0}, N);
        return positions(embed(damp(pendulum), how), on, 1.0, 0.5).back() -
               positions(embed(damp(pendulum), mid_point), on, 1.0, 0.5).back();
    };
    CHECK(apart(order_one, 200) / apart(order_one, 400) == doctest::Approx(2).epsilon(0.02));
    CHECK(apart(galerkin<2, gauss>, 200) / apart(galerkin<2, gauss>, 400) == doctest::Approx(4).epsilon(0.02));
    auto const bob = mechanical(1.0, [](auto const& x) {
        using std::cos;
        return -cos(x(0));
    });
    Eigen::VectorXd const one = Eigen::VectorXd::Ones(1);
    CHECK(positions(embed(damp(bob), mid_point), T, one, Eigen::VectorXd(one / 2)).back()(0) == doctest::Approx(expected).epsilon(1e-12));
    CHECK(positions(embed(with_fractional_damping(bob, 0.3, 1.0), mid_point), T, one, Eigen::VectorXd(one / 2)).back()(0) ==
          doctest::Approx(end(embed(with_fractional_damping(pendulum, 0.3, 1.0), mid_point))).epsilon(1e-12));
    CHECK(std::abs(end(embed(damp(with_force(pendulum, friction)), mid_point)) - expected) > 0.001);

    auto const path = embed(damp(pendulum), mid_point).along(T, 1.0, 0.5);
    auto at = path.begin();
    for (int k = 0; k < 40; ++k) ++at;
    double resumed = 0;
    for (auto const& x : path.resume(at.checkpoint())) resumed = x.q;
    CHECK(resumed == expected);
}

TEST_CASE("what is no damping is refused in one sentence, and a failed step leaves the state as it was") {
    double const nan = std::nan("");
    for (double const beta : {0.0, 2.0, -0.5, 2.5, nan})
        CHECK_THROWS_AS((void)with_fractional_damping(pendulum, 0.1, beta), error::invalid_parameter);
    CHECK_THROWS_WITH_AS((void)with_fractional_damping(pendulum, 0.1, 2.0),
                         "the order of a fractional damping lies in ]0, 2[, and this one is 2", error::invalid_parameter);
    CHECK_THROWS_WITH_AS((void)with_fractional_damping(pendulum, nan, 0.5), "the coefficient of a fractional damping is a finite number",
                         error::invalid_parameter);
    CHECK_THROWS_AS((void)with_fractional_damping(kepler, Eigen::Vector2d(0.1, nan), 0.5), error::invalid_parameter);

    auto const T = uniform(0.0, 0.1, 10);
    auto const plane = embed(with_fractional_damping(kepler, Eigen::VectorXd(Eigen::VectorXd::Ones(3)), 0.5), mid_point);
    CHECK_THROWS_WITH_AS((void)plane.along(T, Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)),
                         "a fractional damping has one coefficient for each component, and here are 3 for 2", error::mismatch);
    auto const flow = embed(with_fractional_damping(pendulum, 0.1, 0.5), mid_point);
    CHECK_THROWS_AS((void)flow.along(T, nan, 0.0), error::not_finite);
    decltype(flow)::memory<double, double> memory(flow, 0.1, 1.0);
    state<double, double> x{0, 1, 0};
    CHECK_THROWS_WITH_AS(memory.advance(flow, x, 0.2), "fractional damping remembers steps of one length, 0.1, and this step has 0.2",
                         error::mismatch);
    // h^{1/2} is no rational number, h is.
    auto const exact = embed(with_fractional_damping(oscillator, Q(1, 3), fraction<1, 2>{}), mid_point);
    auto const walk = [](auto const& path) {
        for (auto const& at : path) (void)at;
    };
    CHECK_THROWS_AS(walk(exact.along(uniform(Q(0), Q(1, 4), 3), Q(1), Q(0))), error::invalid_parameter);
}

} // namespace fractional_flow_tests
