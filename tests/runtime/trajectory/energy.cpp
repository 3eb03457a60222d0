// SPDX-License-Identifier: BSL-1.0
// The energy error of symplectic methods over some thousand steps, pinned: largest, least-squares slope against time, correlation with
// time. The runs are regular motions, on which rounding changes these numbers by less than 1e-8 of themselves. The tolerances of a few per
// cent leave a method free to round differently, and are far from the factors of 2 and 4 that a lost order, a wrong node or a wrong sign
// cost.
#include <vector>

#include <doctest/doctest.h>

#include "hilger/composition/methods.hpp"
#include "hilger/trajectory/diagnostics.hpp"
#include "support/systems.hpp"

namespace energy_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

auto drift_of_swing(auto const& flow) { return drift_along(flow.along(uniform(0.0, 0.05, 4000), 1.0, 0.5), energy(pendulum)); }
auto pendulum_drift(auto const& how) { return drift_of_swing(embed(pendulum, how)); }
/// Eccentricity 0.6, semi-major axis 1, from perihelion; 9.5 periods.
auto drift_of_orbit(auto const& flow) {
    return drift_along(flow.along(uniform(0.0, 0.01, 6000), Eigen::Vector2d(0.4, 0), Eigen::Vector2d(0, 2)), energy(kepler));
}
auto kepler_drift(auto const& how) { return drift_of_orbit(embed(kepler, how)); }
void check(drift_statistics<double> const& d, double largest, double slope, double correlation) {
    CHECK(near(d.largest, largest, 0.01));
    CHECK(near(d.slope(), slope, 0.03));
    CHECK(near(d.correlation(), correlation, 0.03));
}

} // namespace

TEST_CASE("energy errors of the pendulum") {
    check(pendulum_drift(mid_point), 3.39756e-5, -3.28391e-10, -1.47952e-3);
    check(pendulum_drift(order_one), 2.358593e-2, -5.23827e-7, -3.23029e-3);
    check(pendulum_drift(order_one_left), 2.458081e-2, -6.64728e-7, -3.97079e-3);
    check(pendulum_drift(theta<1, 3>), 7.962252e-3, -7.02666e-8, -1.28591e-3);
    check(pendulum_drift(galerkin<2, gauss>), 1.974381e-9, 9.61704e-14, 4.71094e-3);
    check(pendulum_drift(galerkin<3, lobatto>), 1.245648e-8, -2.51455e-13, -3.48899e-3);
    check(drift_of_swing(stoermer_verlet(pendulum)), 2.892653e-4, 1.26853e-9, 6.26993e-4);
    check(drift_of_swing(compose(suzuki<4>, embed(pendulum, mid_point))), 1.003678e-9, 5.68901e-14, 5.61738e-3);
}

TEST_CASE("energy errors of Kepler's ellipse") {
    check(kepler_drift(mid_point), 4.224078e-4, -2.91438e-8, -6.12107e-3);
    check(kepler_drift(order_one), 1.459239e-2, -9.41667e-6, -3.37751e-2);
    check(kepler_drift(theta<1, 3>), 4.638370e-3, -3.17825e-6, -3.41827e-2);
    check(kepler_drift(galerkin<2, gauss>), 6.434248e-9, -7.32368e-13, -5.31244e-3);
    check(drift_of_orbit(stoermer_verlet(kepler)), 3.706806e-4, 1.33378e-8, 3.57550e-3);
    check(drift_of_orbit(compose(suzuki<4>, embed(kepler, mid_point))), 2.205905e-8, 3.10586e-13, 2.02562e-3);
}

TEST_CASE("they are what backward error analysis says, and do not drift") {
    // Mid-point keeps H - h^2/24 H''(J dH, J dH) + O(h^4) (Hairer, Lubich, Wanner, section IX.3): the error of H is h^2/24 (D - D at the
    // start) with D = |U'|^2 + p.U''p. Pendulum: D = sin^2 q + p^2 cos q from (1, 1/2), farthest where q = 0. Kepler: from perihelion,
    // r = 2/5, p = 2, to aphelion, r = 8/5, p = 1/2.
    double const D0 = std::pow(std::sin(1.0), 2) + std::cos(1.0) / 4, D1 = 0.25 + 2 - 2 * std::cos(1.0);
    auto const swing = pendulum_drift(mid_point);
    CHECK(near(swing.largest, 0.05 * 0.05 / 24 * (D1 - D0), 0.01));
    auto const D = [](double r, double p) { return 1 / std::pow(r, 4) + p * p / std::pow(r, 3); };
    auto const orbit = kepler_drift(mid_point);
    CHECK(near(orbit.largest, 0.01 * 0.01 / 24 * (D(0.4, 2) - D(1.6, 0.5)), 0.01));
    // What the fitted line changes over the whole run is a small part of the oscillation: windows that are no whole number of periods.
    CHECK(std::abs(swing.slope()) * 200 < 0.01 * swing.largest);
    CHECK(std::abs(orbit.slope()) * 60 < 0.01 * orbit.largest);
    CHECK(std::abs(kepler_drift(order_one).slope()) * 60 < 0.05 * kepler_drift(order_one).largest);
}

TEST_CASE("the error of a method that is not symplectic grows with time, and is seen to") {
    std::vector<state<double, double>> run{{0, 1, 0.5}};
    for (int i = 1; i <= 4000; ++i) { // Runge's second-order method
        auto const [t, q, p] = run.back();
        double const h = 0.05, middle_q = q + h / 2 * p, middle_p = p - h / 2 * std::sin(q);
        run.push_back({i * h, q + h * middle_p, p - h * std::sin(middle_q)});
    }
    auto const d = drift_along(run, energy(pendulum));
    CHECK(d.correlation() > 0.99);
    CHECK(d.slope() * 200 > 0.9 * d.largest);
}

TEST_CASE("the angular momentum of the ellipse does not drift beyond rounding, in 50 digits") {
    using wide = Eigen::Matrix<float50, 2, 1>;
    auto const path = embed(kepler, mid_point)
                          .along(uniform(float50(0), float50(1) / 50, 100), wide(float50(2) / 5, float50(0)), wide(float50(0), float50(2)));
    auto const rotation = [](wide const& q) { return wide(-q(1), q(0)); };
    CHECK(drift_along(path, momentum_map(rotation)).largest < 100 * epsilon<float50>());
}

} // namespace energy_tests
