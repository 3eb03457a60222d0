// SPDX-License-Identifier: BSL-1.0
// The energy error of symplectic methods over some thousand steps: largest, least-squares slope against time, correlation with time. They
// are those of the same methods written out here, as partitioned Runge-Kutta methods (Hairer, Lubich, Wanner, II.2 and VI.6.4).
#include <vector>

#include <doctest/doctest.h>

#include "hilger/composition/methods.hpp"
#include "hilger/trajectory/diagnostics.hpp"
#include "support/systems.hpp"

namespace energy_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// Q_i = q + h sum a_ij P_j, P_i = p + h sum b_ij U'(Q_j): positions by a, momenta by b, q' and p' by the weights w.
struct table {
    std::vector<std::vector<double>> a, b;
    std::vector<double> w;
};
table one_stage(double lambda) { return {{{lambda}}, {{1 - lambda}}, {1}}; }
table const right = one_stage(0), left = one_stage(1), third = one_stage(1.0 / 3), middle = one_stage(0.5);
double const r = std::sqrt(3.0) / 6;
table const gauss_2{{{0.25, 0.25 - r}, {0.25 + r, 0.25}}, {{0.25, 0.25 - r}, {0.25 + r, 0.25}}, {0.5, 0.5}};
table const lobatto_3{{{0, 0, 0}, {5. / 24, 1. / 3, -1. / 24}, {1. / 6, 2. / 3, 1. / 6}},
                      {{1. / 6, -1. / 6, 0}, {1. / 6, 1. / 3, 0}, {1. / 6, 5. / 6, 0}},
                      {1. / 6, 2. / 3, 1. / 6}};
table const kick_drift_kick{{{0, 0}, {0.5, 0.5}}, {{0.5, 0}, {0.5, 0}}, {0.5, 0.5}};
std::vector<double> const whole{1};
std::vector<double> const five_parts = [] {
    double const c = 1 / (4 - std::cbrt(4.0));
    return std::vector<double>{c, c, 1 - 4 * c, c, c};
}();

/// One step for H = p.p / 2 + U(q), by iteration.
template <class V>
void make_step(table const& m, auto const& force, V& q, V& p, double h) {
    std::vector<V> Q(m.w.size(), q), P(m.w.size(), p);
    for (int iteration = 0; iteration < 40; ++iteration)
        for (std::size_t i = 0; i < m.w.size(); ++i) {
            V x = q, y = p;
            for (std::size_t j = 0; j < m.w.size(); ++j) x += h * m.a[i][j] * P[j], y += h * m.b[i][j] * force(Q[j]);
            Q[i] = x, P[i] = y;
        }
    for (std::size_t i = 0; i < m.w.size(); ++i) q += h * m.w[i] * P[i], p += h * m.w[i] * force(Q[i]);
}
/// Largest error, slope and correlation by their definitions, and N epsilon, which rounding stays below, in largest errors.
struct expected {
    double largest, change, correlation, rounding;
};
template <class V>
expected errors_of(table const& m, std::vector<double> const& parts, auto const& force, auto const& H, V q, V p, double h, int N) {
    std::vector<double> e{0};
    double const start = H(q, p);
    for (int i = 0; i < N; ++i) {
        for (double const c : parts) make_step(m, force, q, p, c * h);
        e.push_back(H(q, p) - start);
    }
    double mean = 0, largest = 0, tt = 0, ee = 0, te = 0;
    for (double const x : e) mean += x / (N + 1), largest = std::max(largest, std::abs(x));
    for (int i = 0; i <= N; ++i) {
        double const t = h * (i - N / 2.0), x = e[static_cast<std::size_t>(i)] - mean;
        tt += t * t, ee += x * x, te += t * x;
    }
    return {largest, te / tt * N * h / largest, te / std::sqrt(tt * ee), N * epsilon<double>() / largest};
}
void check(drift_statistics<double> const& d, double time, expected const& x) {
    CAPTURE(x.largest);
    CHECK(near(d.largest, x.largest, x.rounding));
    CHECK(std::abs(d.slope() * time / x.largest - x.change) < x.rounding);
    CHECK(std::abs(d.correlation() - x.correlation) < x.rounding);
}

auto drift_of_swing(auto const& flow) { return drift_along(flow.along(uniform(0.0, 0.05, 4000), 1.0, 0.5), energy(pendulum)); }
auto pendulum_drift(auto const& how) { return drift_of_swing(embed(pendulum, how)); }
void check_swing(auto const& flow, table const& m, std::vector<double> const& parts = whole) {
    auto const force = [](double q) { return -std::sin(q); };
    auto const H = [](double q, double p) { return p * p / 2 - std::cos(q); };
    check(drift_of_swing(flow), 200, errors_of(m, parts, force, H, 1.0, 0.5, 0.05, 4000));
}
/// Eccentricity 0.6, semi-major axis 1, from perihelion; 9.5 periods.
auto drift_of_orbit(auto const& flow) {
    return drift_along(flow.along(uniform(0.0, 0.01, 6000), Eigen::Vector2d(0.4, 0), Eigen::Vector2d(0, 2)), energy(kepler));
}
auto kepler_drift(auto const& how) { return drift_of_orbit(embed(kepler, how)); }
void check_orbit(auto const& flow, table const& m, std::vector<double> const& parts = whole) {
    using plane = Eigen::Vector2d;
    auto const force = [](plane const& q) { return plane(-q / std::pow(q.norm(), 3)); };
    auto const H = [](plane const& q, plane const& p) { return p.squaredNorm() / 2 - 1 / q.norm(); };
    check(drift_of_orbit(flow), 60, errors_of(m, parts, force, H, plane(0.4, 0), plane(0, 2), 0.01, 6000));
}

} // namespace

TEST_CASE("energy errors of the pendulum") {
    check_swing(embed(pendulum, mid_point), middle);
    check_swing(embed(pendulum, order_one), right);
    check_swing(embed(pendulum, order_one_left), left);
    check_swing(embed(pendulum, theta<1, 3>), third);
    check_swing(embed(pendulum, galerkin<2, gauss>), gauss_2);
    check_swing(embed(pendulum, galerkin<3, lobatto>), lobatto_3);
    check_swing(stoermer_verlet(pendulum), kick_drift_kick);
    check_swing(compose(suzuki<4>, embed(pendulum, mid_point)), middle, five_parts);
}

TEST_CASE("energy errors of Kepler's ellipse") {
    check_orbit(embed(kepler, mid_point), middle);
    check_orbit(embed(kepler, order_one), right);
    check_orbit(embed(kepler, theta<1, 3>), third);
    check_orbit(embed(kepler, galerkin<2, gauss>), gauss_2);
    check_orbit(stoermer_verlet(kepler), kick_drift_kick);
    check_orbit(compose(suzuki<4>, embed(kepler, mid_point)), middle, five_parts);
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
