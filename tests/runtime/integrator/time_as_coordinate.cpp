// SPDX-License-Identifier: BSL-1.0
// L(t, q, v) and forces in a transformed time: states are (q, t, e), and t is a component of the solution.
#include <cmath>

#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "support/orders.hpp"
#include "support/systems.hpp"

namespace time_as_coordinate_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

constexpr auto rate = [](auto const& q) { return 1 / (1 + q.dot(q)); };
/// x'' = -x + cos 2t, of vectors with one component.
constexpr auto driven = [](auto const& t, auto const& q, auto const& v) { return (v.dot(v) - q.dot(q)) / 2 + q(0) * cos(2 * t); };

/// The largest distance from the exact motion x(t), at the times of the solution itself.
template <class Path, class Exact>
double farthest(Path const& path, Exact const& exact) {
    double most = 0;
    for (auto const& x : path) most = std::max(most, std::abs(x.q(0) - exact(x.q(1))));
    return most;
}
template <class S>
using vector = Eigen::Matrix<S, 3, 1>;

} // namespace

TEST_CASE("a driven oscillator is where it is at its own times, and e is its energy") {
    auto const exact = [](double t) { return (4 * std::cos(t) - std::cos(2 * t)) / 3; };
    auto const L = transform_time(driven, rate);
    vector<double> const x0(1, 0, -0.5), p0(0, 0.5, 0); // H = v^2/2 + x^2/2 - x cos 2t
    auto const T = uniform(0.0, 0.1, 200);
    auto const path = embed(L, galerkin<4, gauss>).along(T, x0, p0);
    CHECK(farthest(path, exact) <= 1e-9);
    for (auto const& x : path) {
        CHECK(std::abs(x.q(2) - ((x.p(0) * x.p(0) + x.q(0) * x.q(0)) / 2 - x.q(0) * std::cos(2 * x.q(1)))) <= 1e-9);
        CHECK(std::abs(x.p(1) + x.q(2)) <= 1e-12);
        CHECK(std::abs(x.p(2)) <= 1e-12);
    }
    int passed = 0; // t = 5 is an event
    for (auto const& x : events(path, [](auto const& y) { return y.q(1) - 5; })) {
        CHECK(std::abs(x.q(1) - 5) <= 1e-12);
        CHECK(std::abs(x.q(0) - exact(5)) <= 1e-6);
        ++passed;
    }
    CHECK(passed == 1);
    CHECK(farthest(compose(kahan_li<6>, embed(L, mid_point)).along(T, x0, p0), exact) <= 1e-5);
    // the same from a velocity
    auto const by_velocity = record(embed(L, mid_point).along(T, initial_velocity<vector<double>>{x0, vector<double>(0, 0.5, 0)}));
    auto const by_momentum = record(embed(L, mid_point).along(T, x0, p0));
    CHECK(magnitude(vector<double>(by_velocity.states.back().q - by_momentum.states.back().q)) <= 1e-11);
}

TEST_CASE("friction: the energy that it takes is that of e") {
    auto const spring = [](auto const& q, auto const& v) { return (v.dot(v) - q.dot(q)) / 2; };
    auto const friction = [](auto const&, auto const& v) { return evaluated(-v / 5); };
    double const b = std::sqrt(0.99);
    auto const exact = [b](double t) { return std::exp(-t / 10) * (std::cos(b * t) + std::sin(b * t) / (10 * b)); };
    auto const method = embed(transform_time(with_force(spring, friction), rate), galerkin<4, gauss>);
    auto const path = method.along(uniform(0.0, 0.1, 200), vector<double>(1, 0, 0.5), vector<double>(0, -0.5, 0));
    CHECK(farthest(path, exact) <= 1e-9);
    auto const end = record(path).states.back();
    CHECK(end.q(2) < 0.2);
    CHECK(std::abs(end.q(2) - (end.p(0) * end.p(0) + end.q(0) * end.q(0)) / 2) <= 1e-9);
}

TEST_CASE("without t and forces it is the motion of constant energy, and its times") {
    Eigen::Vector2d const q(0.1, 0), p(0, std::sqrt(19.0));
    auto const T = uniform(0.0, 0.05, 200);
    auto const path = embed(transform_time(kepler, sundman(1), -0.5), mid_point).along(T, q, p);
    auto const t = times_of(path);
    auto const more = record(
        embed(transform_time(kepler, sundman(1)), mid_point).along(T, Eigen::Vector4d(0.1, 0, 0, -0.5), Eigen::Vector4d(0, p(1), 0.5, 0)));
    std::size_t i = 0;
    for (auto const& x : path) {
        CHECK(magnitude(Eigen::Vector2d(more.states[i].q.head<2>() - x.q)) <= 1e-10);
        CHECK(std::abs(more.states[i].q(2) - t[static_cast<index_type>(i)]) <= 1e-10);
        CHECK(std::abs(more.states[i].q(3) + 0.5) <= 1e-13);
        ++i;
    }
}

TEST_CASE("orders in 50 digits, symplectic in (q, t, e) and their momenta, and reversible") {
    auto const L = transform_time(driven, rate);
    vector<float50> const x0(1, 0, float50(-1) / 2), p0(0, float50(1) / 2, 0);
    auto const end_of = [&](auto const& how, int steps) {
        return record(embed(L, how).along(uniform(interval<float50>{0, 1}, steps), x0, p0)).states.back().q;
    };
    auto const exact = end_of(galerkin<6, gauss>, 8);
    auto const check_order = [&](auto const& how, int steps, double order) {
        vector<float50> const coarse = end_of(how, steps) - exact, fine = end_of(how, 2 * steps) - exact;
        for (int k = 0; k < 3; ++k) CHECK(std::abs(order_of(coarse(k), fine(k)) - order) <= 0.1);
    };
    check_order(mid_point, 32, 2);
    check_order(galerkin<2, gauss>, 16, 4);

    state<float50, vector<float50>> const start{0, x0, p0};
    float50 const h = float50(1) / 10;
    CHECK(symplecticity_error(jacobian_of_step(embed(L, mid_point), start, h)) < float50("1e-38"));
    CHECK(symplecticity_error(jacobian_of_step(embed(L, galerkin<2, gauss>), start, h)) < float50("1e-38"));
    CHECK(reversibility_error(embed(L, mid_point), embed(L, mid_point), start, h) < 64 * epsilon<float50>());
    CHECK(largest_residual(embed(L, mid_point).along(uniform(float50(0), h, 10), x0, p0)) < 1000 * epsilon<float50>() / h);
}

} // namespace time_as_coordinate_tests
