// SPDX-License-Identifier: BSL-1.0
// Whatever sums the history of a run, the run is the same: every policy against the direct sum at every point, for flows, structures and
// viscoelastic materials.
#include <cmath>

#include <doctest/doctest.h>

#include "../../../examples/beam.hpp"
#include "hilger/fractional/flow.hpp"
#include "hilger/fractional/newmark.hpp"
#include "hilger/fractional/zener.hpp"
#include "hilger/history/history.hpp"
#include "support/systems.hpp"

namespace fractional_policies_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

constexpr int N = 600;

/// The largest difference between the positions of two runs.
template <class Path>
double apart(Path const& path, auto const& other) {
    double worst = 0;
    int points = 0;
    auto y = other.begin();
    for (auto const& x : path) {
        worst = std::max(worst, static_cast<double>(magnitude(plain_t<decltype(x.q)>(x.q - y->q))));
        ++y, ++points;
    }
    CHECK(points == N + 1);
    return worst;
}
/// Calls each(policy, tolerance relative to values of size 1).
template <class Each>
void for_policies(Each const& each) {
    double const rounding = 1024 * epsilon<double>();
    each("blocks", blocks{}, rounding);
    each("exponentials", exponentials{0, N}, rounding);
    each("exponentials to 1e-8", exponentials{1e-8, N}, 1e-6);
}

} // namespace

TEST_CASE("a damped pendulum") {
    auto const T = uniform(0.0, 0.05, N);
    auto const run = [&](auto beta, auto policy) {
        return embed(with_fractional_damping(pendulum, 0.3, beta, policy), mid_point).along(T, 1.0, 0.5);
    };
    auto const half = run(fraction<1, 2>{}, direct{});
    for_policies([&](char const* name, auto policy, double tolerance) {
        CAPTURE(name);
        CHECK(apart(run(fraction<1, 2>{}, policy), half) < tolerance);
    });
    auto const above_one = run(1.5, direct{});
    CHECK(apart(run(1.5, blocks{}), above_one) < 1e4 * epsilon<double>());
    CHECK(apart(half, above_one) > 0.1);
}

TEST_CASE("components of a vector") {
    auto const T = uniform(0.0, 0.02, N);
    Eigen::Vector2d const rho(0.0, 0.2);
    auto const run_of = [&](auto const& coefficient, auto policy) {
        return embed(with_fractional_damping(kepler, coefficient, fraction<1, 2>{}, policy), mid_point)
            .along(T, Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1));
    };
    auto const run = [&](auto policy) { return run_of(rho, policy); };
    auto const expected = run(direct{});
    CHECK(apart(run_of(2 * rho / 2, direct{}), expected) == 0);
    CHECK(apart(run_of(rho.array(), direct{}), expected) == 0);
    for_policies([&](char const* name, auto policy, double tolerance) {
        CAPTURE(name);
        CHECK(apart(run(policy), expected) < 16 * tolerance);
    });
}

TEST_CASE("the oscillator and the cantilever of Galucio, Deue, Dubois") {
    auto const oscillator = [](auto policy) {
        return newmark<bdf<2>>(
                   fractional_structure{1.0, 1.0, 1.0, 1.0, 0.5}, [](double) { return 1.0; }, average_acceleration, policy)
            .along(uniform(0.0, 0.025, N), 0.0, 0.0);
    };
    auto const expected = oscillator(direct{});
    auto const matrices = beams::cantilever(0.15, 2.6e-4, 0.125, 5);
    auto const beam = [&](auto policy) {
        auto const load = [](double t) -> Eigen::VectorXd { return Eigen::VectorXd::Unit(10, 8) * 0.01 * std::min(20 * t, 1.0); };
        Eigen::VectorXd const rest = Eigen::VectorXd::Zero(10);
        return newmark<bdf<2>>(zener_structure{matrices.mass, matrices.stiffness, 1e6, 50e6, 1e-3, fraction<1, 2>{}}, load,
                               average_acceleration, policy)
            .along(uniform(0.0, 0.002, N), rest, rest);
    };
    auto const bent = beam(direct{});
    for_policies([&](char const* name, auto policy, double tolerance) {
        CAPTURE(name);
        CHECK(apart(oscillator(policy), expected) < tolerance);
        CHECK(apart(beam(policy), bent) < tolerance);
    });
}

TEST_CASE("a run that goes further than its history says at which step and time") {
    auto const walk = [](auto const& path) {
        double last = 0;
        try {
            for (auto const& x : path) last = x.t;
        } catch (error::outside_domain const& e) {
            CHECK(last == 1.5);
            CHECK(dynamic_cast<interrupted<double, double> const&>(e).last.t == 1.5);
            return std::string(e.what());
        }
        return std::string();
    };
    auto const T = uniform(0.0, 0.5, 10);
    char const* const sentence = "the step from t = 1.5 with h = 0.5 failed: these exponentials were made for 3 steps, and this is step 4";
    exponentials const few{1e-6, 3};
    CHECK(walk(embed(with_fractional_damping(pendulum, 0.3, 0.5, few), mid_point).along(T, 1.0, 0.5)) == sentence);
    auto const still = [](double) { return 0.0; };
    CHECK(walk(newmark<bdf<2>>(fractional_structure{1.0, 1.0, 1.0, 1.0, 0.5}, still, average_acceleration, few).along(T, 1.0, 0.5)) ==
          sentence);
}

} // namespace fractional_policies_tests
