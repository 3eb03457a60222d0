// SPDX-License-Identifier: BSL-1.0
// Fractional damping by impulses, as the restricted variational principle has it: of order one, explicit, with the positions of one
// equation wherever in the step the impulse is; and its limit of stability, which is noticed in the run.
#include <doctest/doctest.h>

#include "orders.hpp"
#include "support/systems.hpp"

namespace fractional_impulses_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

template <generating_function G = grunwald_letnikov, class Order>
std::array<double, 2> orders(Order beta, impulse_options options) {
    return orders_of(embed(with_fractional_impulses<G>(spring, c, beta, direct{}, options), mid_point), beta, options.history);
}
template <class Order>
void is_of_order_one(Order beta, impulse_options options) {
    auto const [q, p] = orders(beta, options);
    CHECK(std::abs(q - 1) < 0.02);
    CHECK(std::abs(p - 1) < 0.02);
}
template <class Path>
void walk(Path const& path) {
    for (auto const& at : path) (void)at;
}

} // namespace

TEST_CASE("the flow of order 1/2, 1 and 3/2 has order one against Caputo's equation, x_0 and v_0 not zero") {
    for (auto const at : {damping_at::start, damping_at::end}) {
        CAPTURE(static_cast<int>(at));
        is_of_order_one(fraction<1, 2>{}, {.at = at});
        is_of_order_one(fraction<1>{}, {.at = at});
        is_of_order_one(fraction<3, 2>{}, {.at = at});
    }
}

TEST_CASE("half of the damping at each end, with weights of order two, has order two") {
    auto const is_of_order_two = [](auto beta) {
        for (double const slope : orders<bdf<2>>(beta, {.at = damping_at::both})) CHECK(std::abs(slope - 2) < 0.02);
    };
    is_of_order_two(fraction<1, 2>{});
    is_of_order_two(fraction<1>{});
    is_of_order_two(fraction<3, 2>{});
    for (double const slope : orders(fraction<1, 2>{}, {.at = damping_at::both})) CHECK(std::abs(slope - 1) < 0.02);
}

TEST_CASE("and against Riemann and Liouville's, whose x jumps from zero at t_0, where the jump is in a step") {
    is_of_order_one(fraction<1, 2>{}, {.at = damping_at::start, .history = initial_history::riemann_liouville});
    // At the end of steps the impulse h^{1 - beta} x_0 at t_0 is in none: what is left out has the order 1 - beta.
    auto const [q, p] = orders(fraction<1, 2>{}, {.at = damping_at::end, .history = initial_history::riemann_liouville});
    CHECK(std::abs(q - 0.5) < 0.02);
    CHECK(std::abs(p - 0.5) < 0.05);
    // The two equations differ by more than either is wrong.
    double const apart = std::abs(reference(fraction<1, 2>{}, initial_history::caputo).u -
                                  reference(fraction<1, 2>{}, initial_history::riemann_liouville).u);
    CHECK(apart > 0.1);
}

TEST_CASE("orders 1 and none are what they should be, to the bit") {
    auto const T = uniform(0.0, 0.1, 50);
    auto const q = positions(embed(with_fractional_impulses(pendulum, 0.3, fraction<1>{}), mid_point), T, 1.0, 0.5);
    CHECK(q == positions(embed(with_fractional_impulses(pendulum, 0.3, 1.0), mid_point), T, 1.0, 0.5));
    CHECK(q == positions(embed(with_fractional_impulses(pendulum, 0.3, fraction<2, 2>{}), mid_point), T, 1.0, 0.5));
    CHECK(positions(embed(with_fractional_impulses(pendulum, 0, 0.5), mid_point), T, 1.0, 0.5) ==
          positions(embed(pendulum, mid_point), T, 1.0, 0.5));
    auto const half = positions(embed(with_fractional_impulses(pendulum, 0.3, fraction<1, 2>{}), mid_point), T, 1.0, 0.5);
    CHECK(half == positions(embed(with_fractional_impulses(pendulum, 0.3, 0.5), mid_point), T, 1.0, 0.5));
    CHECK(half != q);
    // Both integrators have the positions of (20): from the same first two they are the same curve.
    auto const late = embed(with_fractional_impulses(pendulum, 0.3, fraction<1, 2>{}, direct{}, {.at = damping_at::end}), mid_point);
    auto const at_end = positions(late, T, 1.0, 0.5);
    for (std::size_t k = 0; k < half.size(); ++k) CHECK(std::abs(half[k] - at_end[k]) < 256 * epsilon<double>());
}

TEST_CASE("a constant is not damped by Caputo's derivative, nor is uniform motion for an order above 1; Riemann and Liouville damp both") {
    constexpr lagrangian free{[](auto const& x, auto const& v) { return v * v / 2 + 0 * x; }};
    auto const T = uniform(0.0, 0.1, 40);
    auto const last = [&](auto beta, initial_history history, double p0) {
        return positions(embed(with_fractional_impulses(free, 1.0, beta, direct{}, {.history = history}), mid_point), T, 1.0, p0).back();
    };
    CHECK(last(0.5, initial_history::caputo, 0.0) == 1.0);
    CHECK(last(1.0, initial_history::caputo, 0.0) == 1.0);
    CHECK(last(1.5, initial_history::caputo, 0.25) == 2.0);
    CHECK(last(0.5, initial_history::riemann_liouville, 0.0) < 0.5);
    CHECK(last(1.5, initial_history::riemann_liouville, 0.25) < 1.5);
    CHECK(last(0.5, initial_history::caputo, 0.25) < 1.8);
}

TEST_CASE("a failed step leaves the state as it was") {
    auto const T = uniform(0.0, 1.0, 3);
    // y - 1 = 5 ((1 + y)/2)^2 has no real solution; the momentum of the last good state has not been damped for the step that failed.
    try {
        walk(embed(with_fractional_impulses(cubic, 0.1, fraction<1>{}), mid_point).along(T, 1.0, 0.125));
        FAIL("an equation without a solution must be reported");
    } catch (error::no_convergence const& e) {
        auto const& last = dynamic_cast<interrupted<double, double> const&>(e).last;
        CHECK(last == state<double, double>{0.0, 1.0, 0.125});
    }
}

TEST_CASE("a run beyond the limit of stability ends in an error, and one within it does not") {
    // rho h^(2 - beta) omega(-1)^beta / M = 4: omega(-1) = 2, beta = 1, M = 2, h = 1/4: rho = 16
    constexpr lagrangian heavy{[](auto const& x, auto const& v) { return v * v - x * x / 2; }};
    auto const T = uniform(0.0, 0.25, 400);
    auto const largest = [&](auto const& flow) {
        double most = 0;
        for (auto const& x : flow.along(T, 1.0, 0.0)) most = std::max(most, std::abs(x.q));
        return most;
    };
    CHECK(largest(embed(with_fractional_impulses(heavy, 15.9, fraction<1>{}), mid_point)) == 1.0);
    CHECK_THROWS_AS(walk(embed(with_fractional_impulses(heavy, 16.9, fraction<1>{}), mid_point).along(T, 1.0, 0.0)), error::not_finite);
    // beta = 3/2 and bdf<2>: 4 = rho / 2 h^(1/2) 4^(3/2) = 2 rho
    CHECK(largest(embed(with_fractional_impulses<bdf<2>>(heavy, 1.99, 1.5), mid_point)) < 1.1);
    for (auto const at : {damping_at::start, damping_at::end, damping_at::both})
        CHECK_THROWS_AS(walk(embed(with_fractional_impulses<bdf<2>>(heavy, 2.2, 1.5, direct{}, {.at = at}), mid_point).along(T, 1.0, 0.0)),
                        error::not_finite);
    // Vectors: each component has its mass.
    Eigen::VectorXd const one = Eigen::VectorXd::Ones(3), zero = Eigen::VectorXd::Zero(3);
    Eigen::VectorXd masses(3);
    masses << 1, 0.01, 1;
    auto const row = mechanical(masses, chain([](hilger::index_type, auto const& r) { return r * r / 2; }));
    auto const damped = [&](double second) {
        Eigen::VectorXd rho(3);
        rho << 1, second, 0;
        return embed(with_fractional_impulses(row, rho, 1.0), mid_point);
    };
    CHECK_NOTHROW(walk(damped(0.07).along(T, one, zero)));
    CHECK_THROWS_AS(walk(damped(0.09).along(T, one, zero)), error::not_finite);
}

TEST_CASE("impulses that alternate and grow are an error and no numbers of 1e300") {
    // The oscillator with a gyroscopic term, which couples q and v: rho < 4 / (2^(3/2) h^(1/2)) = 2.83.
    auto const T = uniform(0.0, 0.25, 2000);
    double most = 0;
    auto const run = [&](double rho) {
        auto const flow = embed(with_fractional_impulses(oscillator, rho, 1.5), mid_point);
        for (auto const& x : flow.along(T, 0.5, 0.0)) most = std::max(most, std::abs(x.q));
    };
    CHECK_NOTHROW(run(2.82));
    CHECK(most == 0.5);
    CHECK_THROWS_WITH_AS(run(2.9), doctest::Contains("the impulses of a fractional damping alternate and grow: steps of 0.25 are beyond"),
                         error::not_finite);
    CHECK(most < 1e5);
    // What alternates without growing is no error: hw = 1000, where a mid-point step turns by nearly pi.
    constexpr lagrangian stiff{[](auto const& x, auto const& v) { return v * v * (1 + 0 * x) / 2 - 16'000'000 * x * x / 2; }};
    CHECK_NOTHROW(walk(embed(with_fractional_impulses(stiff, 1e-3, 0.5), mid_point).along(T, 1.0, 0.0)));
}

} // namespace fractional_impulses_tests
