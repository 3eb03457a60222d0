// SPDX-License-Identifier: BSL-1.0
// The times of motions in a transformed time under compositions: the sum of g over the nodes of their parts.
#include <cmath>

#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "support/orders.hpp"
#include "support/systems.hpp"

namespace times_of_compositions_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

constexpr auto twice = [](auto const&) { return 2; };
constexpr auto rate = [](auto const& x) { return 1 / (2 + x * x); };
constexpr auto thirds = shares<fraction<1, 3>, fraction<2, 3>>{};

/// Position and time at tau = 1 of the pendulum, as a composition of flows makes them.
template <class Make>
std::pair<float50, float50> end_of(Make const& make, int steps) {
    float50 const E = float50(1) / 8 - cos(float50(1));
    auto const path = make(transform_time(pendulum, rate, E)).along(uniform(interval<float50>{0, 1}, steps), float50(1), float50(1) / 2);
    return {record(path).states.back().q, times_of(path).get(steps)};
}
template <class Make>
void check_orders(Make const& make, int steps, double order) {
    auto const exact = end_of([](auto const& L) { return compose(kahan_li<8>, embed(L, galerkin<2, gauss>)); }, 40);
    auto const coarse = end_of(make, steps), fine = end_of(make, 2 * steps);
    CHECK(std::abs(order_of(float50(coarse.first - exact.first), float50(fine.first - exact.first)) - order) <= 0.1);
    CHECK(std::abs(order_of(float50(coarse.second - exact.second), float50(fine.second - exact.second)) - order) <= 0.1);
}

} // namespace

TEST_CASE("g = 2: t = 2 tau, exactly, from the first point on") {
    time_scale<Q> const T{Q(1), Q(11, 10), Q(13, 10), Q(27, 20)};
    auto const check = [&](auto const& method) {
        auto const path = method.along(T, Q(1), Q(1, 2));
        auto const t = times_of(path), recorded = times_of(method, record(path));
        for (index_type i = 0; i < 4; ++i) {
            CHECK(t[i] == 2 * T.element(i) - 1);
            CHECK(recorded[i] == t[i]);
        }
    };
    auto const L = transform_time(oscillator, twice, Q(3));
    check(stoermer_verlet(L));
    check(position_verlet(L));
    check(compose(thirds, embed(L, mid_point), embed(L, order_one)));
    check(compose(thirds, compose(thirds, embed(L, mid_point)), adjoint(embed(L, order_one))));
}

TEST_CASE("a rate that is not constant: the nodes of the parts") {
    auto const L = transform_time(
        oscillator, [](auto const& x) { return 2 + x; }, 1.0);
    double const h = 0.1, rounding = 16 * epsilon<double>();
    auto const first = embed(L, mid_point);
    auto const second = embed(L, order_one);
    auto const path = compose(thirds, first, second).along(uniform(0.0, h, 1), 1.0, 0.5);
    auto const between = first.step(state<double, double>{0, 1, 0.5}, h / 3);
    CHECK(std::abs(times_of(path)[1] - (h / 3 * (2 + (1 + between.q) / 2) + 2 * h / 3 * (2 + between.q))) <= rounding);
    // read from the end of the step
    auto const back = adjoint(second).along(uniform(0.0, h, 1), 1.0, 0.5);
    CHECK(std::abs(times_of(back)[1] - h * (2 + record(back).states.back().q)) <= rounding);
}

TEST_CASE("orders of the positions and of the times, in 50 digits; parts with points inside too") {
    check_orders([](auto const& L) { return stoermer_verlet(L); }, 64, 2);
    check_orders([](auto const& L) { return compose(suzuki<4>, embed(L, mid_point)); }, 16, 4);
    check_orders([](auto const& L) { return compose(kahan_li<6>, stoermer_verlet(L)); }, 16, 6);
    check_orders([](auto const& L) { return compose(suzuki<4>, embed(L, galerkin<2, gauss>)); }, 16, 4);
}

TEST_CASE("they are the times that are coordinates") {
    Eigen::Vector2d const q(0.1, 0), p(0, std::sqrt(19.0));
    auto const T = uniform(0.0, 0.05, 100);
    auto const by = [](auto const& L) { return compose(kahan_li<6>, embed(L, mid_point)); };
    auto const t = times_of(by(transform_time(kepler, sundman(1), -0.5)).along(T, q, p));
    auto const more =
        record(by(transform_time(kepler, sundman(1))).along(T, Eigen::Vector4d(0.1, 0, 0, -0.5), Eigen::Vector4d(0, p(1), 0.5, 0)));
    for (index_type i = 0; i <= 100; ++i) CHECK(std::abs(more.states[static_cast<std::size_t>(i)].q(2) - t[i]) <= 1e-10);
}

TEST_CASE("a rate that is not positive at a node is refused") {
    auto const method = stoermer_verlet(transform_time(
        oscillator, [](auto const& x) { return x; }, 1.0));
    auto run = record(method.along(uniform(0.0, 0.25, 4), 1.0, 0.5));
    run.states[2].q = -1; // another program's
    CHECK_THROWS_AS((void)times_of(method, run), error::invalid_parameter);
}

} // namespace times_of_compositions_tests
