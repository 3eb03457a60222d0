// SPDX-License-Identifier: BSL-1.0
// Motions in a transformed time: their times are the integral of g by the embedding's own nodes, and they keep what variational integrators
// keep.
#include <cmath>

#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "support/orders.hpp"
#include "support/systems.hpp"

namespace times_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

constexpr auto twice = [](auto const&) { return 2; };
constexpr auto rational = [](auto const& x) { return (2 + x) / (1 + x * x); };
constexpr auto of_pendulum = [](auto const& x) { return 1 / (2 + cos(x)); };

/// In rationals, with g = 2 under an embedding: steps h are steps 2h of L, and t = 2 tau.
template <class E>
void check_twice(E const& how) {
    time_scale<Q> const T{Q(0), Q(1, 10), Q(3, 10), Q(7, 20)}, longer{Q(0), Q(1, 5), Q(3, 5), Q(7, 10)};
    auto const path = embed(transform_time(oscillator, twice, Q(3)), how).along(T, Q(1), Q(1, 2));
    auto const t = times_of(path);
    auto const there = record(path), plain = record(embed(oscillator, how).along(longer, Q(1), Q(1, 2)));
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(there.states[i].q == plain.states[i].q);
        CHECK(there.states[i].p == plain.states[i].p);
        CHECK(t[static_cast<index_type>(i)] == plain.states[i].t);
    }
    CHECK(times_of(path.method(), there.positions()).get(3) == Q(7, 10));
    CHECK(times_of(path.method(), there).get(3) == Q(7, 10));
}

/// Position and time at tau = 1 of the pendulum in the time of of_pendulum.
template <class E>
std::pair<float50, float50> end_of(E const& how, int steps) {
    float50 const E0 = float50(1) / 8 - cos(float50(1));
    auto const T = uniform(interval<float50>{0, 1}, steps);
    auto const path = embed(transform_time(pendulum, of_pendulum, E0), how).along(T, float50(1), float50(1) / 2);
    auto const t = times_of(path);
    return {record(path).states.back().q, t.get(steps)};
}
template <class E>
void check_orders(E const& how, int steps, double order, std::pair<float50, float50> const& exact) {
    auto const coarse = end_of(how, steps), fine = end_of(how, 2 * steps);
    CHECK(std::abs(order_of(float50(coarse.first - exact.first), float50(fine.first - exact.first)) - order) <= 0.05);
    CHECK(std::abs(order_of(float50(coarse.second - exact.second), float50(fine.second - exact.second)) - order) <= 0.05);
}

} // namespace

TEST_CASE("g = 2: steps of twice the length, exactly") {
    check_twice(mid_point);
    check_twice(theta<1, 3>);
    check_twice(order_one);
    check_twice(order_one_left);
    check_twice(galerkin<2, lobatto>);
    check_twice(galerkin<3, lobatto>);
    check_twice(galerkin<2, radau>);
}

TEST_CASE("t is the antiderivative of g, at the points that the embedding integrates over, exactly") {
    time_scale<Q> const T{Q(1), Q(11, 10), Q(13, 10), Q(27, 20)};
    std::vector<Q> const values{Q(1, 2), Q(2), Q(-1, 3), Q(1)};
    function_on const x(T, values);
    auto const of = [&](auto const& how) { return times_of(embed(transform_time(oscillator, rational, Q(1)), how), x); };
    auto const g = apply_pointwise(rational, x);
    auto const middle = antiderivative_h[apply_pointwise(rational, mid_point.position[x])];
    for (index_type i = 0; i < 4; ++i) {
        CHECK(of(mid_point)[i] == 1 + middle[i]);
        CHECK(of(order_one)[i] == 1 + antiderivative[g][i]);
        CHECK(of(order_one_left)[i] == 1 + antiderivative_nabla[g][i]);
        CHECK(2 * of(galerkin<2, lobatto>)[i] == of(order_one)[i] + of(order_one_left)[i]); // the trapezoidal rule
    }
}

TEST_CASE("t begins at the first point of T") {
    auto const path = embed(transform_time(pendulum, twice, 0.25), mid_point).along(uniform(1.0, 0.25, 4), 1.0, 0.5);
    auto const t = times_of(path);
    for (index_type i = 0; i <= 4; ++i) CHECK(t[i] == 1 + 0.5 * static_cast<double>(i));
}

TEST_CASE("a time that stands still or goes back is refused") {
    auto const T = uniform(0.0, 0.1, 4);
    function_on const x(T, std::vector<double>{1, 0.5, 0.25, 0, -1});
    auto const method = embed(transform_time(
                                  pendulum, [](auto const& q) { return q; }, 1.0),
                              order_one);
    CHECK_THROWS_AS((void)times_of(method, x), error::invalid_parameter);
}

TEST_CASE("orders of the positions and of the times, in 50 digits, and the motion is that of L") {
    auto const exact = end_of(galerkin<8, gauss>, 8);
    check_orders(mid_point, 64, 2, exact);
    check_orders(galerkin<2, gauss>, 16, 4, exact);
    check_orders(galerkin<3, gauss>, 8, 6, exact);
    check_orders(galerkin<3, lobatto>, 32, 4, exact);

    auto const T = uniform(interval<float50>{0, exact.second}, 8);
    auto const plain = record(embed(pendulum, galerkin<8, gauss>).along(T, float50(1), float50(1) / 2));
    CHECK(abs(float50(plain.states.back().q - exact.first)) < float50("1e-15"));
}

TEST_CASE("symplectic in (q, p), with the momentum map of rotations, in 50 digits") {
    using vector = Eigen::Matrix<float50, 2, 1>;
    auto const charge = [](auto const& q, auto const& v) {
        auto const r2 = q.squaredNorm();
        return v.squaredNorm() / 2 + r2 * (q(0) * v(1) - q(1) * v(0)) / 3 + 1 / sqrt(r2);
    };
    vector const q(1, float50(1) / 4), p(float50(1) / 3, float50(3) / 4);
    float50 const E = hamiltonian(charge)(p, q), h = float50(1) / 10;
    auto const rotation = momentum_map([](vector const& x) { return vector(-x(1), x(0)); });
    auto const conserves = [&](auto const& flow) {
        CHECK(symplecticity_error(jacobian_of_step(flow, state<float50, vector>{0, q, p}, h)) < float50("1e-38"));
        CHECK(drift_along(flow.along(uniform(float50(0), h, 5), q, p), rotation).largest < 1000 * epsilon<float50>());
    };
    auto const L = transform_time(charge, sundman(1), E);
    conserves(embed(L, mid_point));
    conserves(embed(L, galerkin<2, gauss>));
    conserves(compose(suzuki<4>, embed(L, mid_point)));
}

TEST_CASE("reversible to rounding, and its equation holds to rounding") {
    Eigen::Vector2d const q(0.1, 0), p(0, std::sqrt(19.0));
    auto const L = transform_time(kepler, sundman(1), -0.5);
    state<double, Eigen::Vector2d> x{0, q, p};
    auto const middle = embed(L, mid_point);
    auto const high = embed(L, galerkin<3, gauss>);
    auto const composed = compose(kahan_li<6>, middle);
    for (int i = 0; i < 10; ++i) {
        double const rounding = 64 * epsilon<double>() * (1 + magnitude(x.p));
        CHECK(reversibility_error(middle, middle, x, 0.1) <= rounding);
        CHECK(reversibility_error(high, high, x, 0.1) <= rounding);
        CHECK(reversibility_error(composed, composed, x, 0.1) <= 16 * rounding);
        x = high.step(x, 0.5);
    }
    auto const T = uniform(0.0, 0.1, 100);
    CHECK(relative_residual(middle.along(T, q, p)) <= 50);
    CHECK(relative_residual(high.along(T, q, p)) <= 50);
}

TEST_CASE("Kepler's problem, e = 0.9: equal steps in the eccentric anomaly") {
    // tau is the eccentric anomaly: q = (cos tau - e, sqrt(1 - e^2) sin tau), t = tau - e sin tau
    Eigen::Vector2d const q(0.1, 0), p(0, std::sqrt(19.0));
    auto const T = uniform(0.0, std::acos(-1.0) / 32, 320); // five revolutions
    auto const path = embed(transform_time(kepler, sundman(1), -0.5), galerkin<6, gauss>).along(T, q, p);
    auto const t = times_of(path);
    index_type i = 0;
    for (auto const& x : path) {
        CHECK(magnitude(Eigen::Vector2d(x.q - Eigen::Vector2d(std::cos(x.t) - 0.9, std::sqrt(0.19) * std::sin(x.t)))) <= 1e-11);
        CHECK(std::abs(t[i] - (x.t - 0.9 * std::sin(x.t))) <= 1e-11);
        ++i;
    }
    // the inverse of the potential is the same rate
    auto const other = record(embed(transform_time(kepler, inverse_potential(kepler), -0.5), galerkin<6, gauss>).along(T, q, p));
    CHECK(magnitude(Eigen::Vector2d(other.states.back().q - q)) <= 1e-11);
}

TEST_CASE("an eccentricity of 0.99: 200 times as many equal steps have a larger error of the energy") {
    double const e = 0.99;
    Eigen::Vector2d const q(1 + e, 0), p(0, std::sqrt((1 - e) / (1 + e))); // the aphelion
    double const revolution = 2 * std::acos(-1.0);
    double of_tau = 0; // int r^(-3/2) dt = int r^(-1/2) over the eccentric anomaly
    for (int i = 0; i < 1000; ++i) of_tau += revolution / 1000 / std::sqrt(1 - e * std::cos(revolution * (i + 0.5) / 1000));
    auto const largest = [&](auto const& L, auto const& how, auto const& T) {
        return drift_along(embed(L, how).along(T, q, p), energy(kepler)).largest;
    };
    auto const L = transform_time(kepler, sundman(1.5), -0.5);
    // 100 steps for each of 1000 revolutions; the first of them shows the largest error of all, which does not grow
    double const first = largest(L, mid_point, uniform(0.0, of_tau / 100, 200));
    double const all = largest(L, mid_point, uniform(0.0, of_tau / 100, 100'000));
    CHECK(first <= all);
    CHECK(all <= 1.05 * first);
    CHECK(all < largest(kepler, mid_point, uniform(0.0, revolution / 20'000, 20'000)));
    // and 50 of order 6
    CHECK(largest(L, galerkin<3, gauss>, uniform(0.0, of_tau / 50, 500)) <
          largest(kepler, galerkin<3, gauss>, uniform(0.0, revolution / 4000, 4000)));
}

TEST_CASE("over many steps the energy does not drift") {
    Eigen::Vector2d const q(0.1, 0), p(0, std::sqrt(19.0));
    auto const method = embed(transform_time(kepler, sundman(1), -0.5), mid_point);
    auto const drift = drift_along(method.along(uniform(0.0, 0.1, 50'000), q, p), energy(kepler));
    CHECK(drift.largest <= 0.1);
    CHECK(std::abs(drift.correlation()) <= 0.01);
    // equal steps in t have no solution at an encounter
    CHECK_THROWS_AS((void)record(embed(kepler, mid_point).along(uniform(0.0, 0.1, 500), q, p)), error::no_convergence);
}

} // namespace times_tests
