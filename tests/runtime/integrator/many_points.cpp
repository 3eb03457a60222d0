// SPDX-License-Identifier: BSL-1.0
// Problems between two ends on many points, with and without points inside the steps: first solved on every eighth point.
#include <doctest/doctest.h>

#include <cmath>

#include "joined_by.hpp"

namespace many_points_tests {

using namespace hilger;
using namespace testing::two_ends;

namespace {

constexpr lagrangian pendulum{[](auto const& x, auto const& v) { return v * v / 2 + 9.81 * cos(x); }};
constexpr lagrangian in_space{
    [](auto const& x, auto const& v) { return v.dot(v) / 2 + v(0) * x(1) / 3 - x.dot(x) / 2 - x(0) * x(0) * x(1) * x(1) / 4; }};

template <class X, class Y>
double distance(X const& x, Y const& y) {
    double most = 0;
    for (index_type i = 0; i < x.size(); ++i) most = std::max(most, static_cast<double>(magnitude(value_of<X>(x[i] - y[i]))));
    return most;
}
/// The walk from its first position and momentum comes to the same values.
template <class L, class E, class T, class V, class Force = no_force>
void is_walked_again(L const& l, E const& how, T const& scale, V const& q0, V const& qN, double most, Force const& force = {}) {
    auto const EL = equation_of(embed(l, how), scale);
    auto const x = solve(EL, scale, boundary_values<V>{q0, qN}, force);
    CHECK(x[0] == q0);
    CHECK(x[x.size() - 1] == qN);
    auto const method = flow_of(EL, force);
    CHECK(distance(x, solve(EL, scale, initial_momentum<V>{q0, momenta_of(method, x)[0]}, force)) <= most);
    if (x.size() < 2000) CHECK(relative_residual(EL, x, force) <= 4);
}

} // namespace

TEST_CASE("a pendulum between two ends is walked again from the first of them") {
    auto const on = [](index_type N) { return uniform(interval{0.0, 1.0}, N); };
    is_walked_again(pendulum, mid_point, on(10000), 0.0, 1.0, 1e-9);
    is_walked_again(pendulum, galerkin<2, gauss>, on(1000), 0.0, 1.0, 1e-10);
    is_walked_again(pendulum, galerkin<4, gauss>, on(300), 0.0, 1.0, 1e-11);
    is_walked_again(pendulum, galerkin<4, gauss>, on(4000), 0.0, 1.0, 1e-10);
}

TEST_CASE("on unequal points, in space and with a force") {
    std::vector<double> points{0};
    for (int k = 0; k < 300; ++k) points.push_back(points.back() + 0.002 + 0.001 * (k % 3));
    time_scale<double> const T(points);
    Eigen::Vector3d const first(0.3, -0.2, 1), last(0.5, 0.4, -1);
    auto const drag = [](auto const&, auto const& v) { return -(v.norm() * v) / 5; };
    is_walked_again(pendulum, galerkin<3, lobatto>, T, 0.0, 1.0, 1e-11);
    is_walked_again(in_space, mid_point, T, first, last, 1e-11, drag);
    is_walked_again(in_space, galerkin<2, gauss>, T, first, last, 1e-11, drag);
    is_walked_again(in_space, galerkin<2, gauss>, T, Eigen::VectorXd(first), Eigen::VectorXd(last), 1e-11, drag);
}

TEST_CASE("a linear equation has the solution of its recurrence") {
    auto const T = uniform(interval{0.0, 1.0}, 10000);
    lagrangian const L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
    lagrangian const in_three{[](auto const& x, auto const& v) { return v.dot(v) / 2 - x.dot(x) / 2; }};
    auto const check = [&](auto const& how, double angle) {
        Eigen::Vector3d const last(1, -2, 0.5);
        auto const x = solve(equation_of(embed(L, how), T), T, boundary_values{0.0, 1.0});
        auto const y = solve(equation_of(embed(in_three, how), T), T, boundary_values<Eigen::Vector3d>{last * 0, last});
        for (index_type i = 0; i <= 10000; i += 500) {
            double const share = std::sin(static_cast<double>(i) * angle) / std::sin(10000 * angle);
            CHECK(std::abs(x[i] - share) <= 1e-10);
            CHECK((y[i] - share * last).norm() <= 1e-9);
        }
    };
    check(mid_point, 2 * std::atan(T.h() / 2));
    check(order_one, 2 * std::asin(T.h() / 2));
}

TEST_CASE("where there is no solution none is found on many points either") {
    auto const T = uniform(interval{-1.0, 1.0}, 4000);
    CHECK_THROWS_AS((void)solve(middle_of(catenoid, T), T, boundary_values{1.0, 1.0}), error::no_convergence);
    auto const D = uniform(interval{0.0, 1.0}, 2000);
    lagrangian const bratu{[](auto const& u, auto const& v) { return v * v / 2 - 4 * exp(u); }};
    CHECK_THROWS_AS((void)solve(middle_of(bratu, D), D, boundary_values{0.0, 0.0}), error::no_convergence);
}

TEST_CASE("of two solutions the one near a guess") {
    auto const T = uniform(interval{0.0, 1.0}, 2000);
    lagrangian const bratu{[](auto const& u, auto const& v) { return v * v / 2 - 2 * exp(u); }};
    auto const upper = joined_by(bratu, T, 0.0, 0.0, function_on(T, [](double t) { return 10 * t * (1 - t); }));
    CHECK(std::abs(upper.middle() - 2.89553126549277) <= 1e-5);
    CHECK(std::abs(joined_by(bratu, T, 0.0, 0.0).middle() - 0.328952421341114) <= 1e-6);
    CHECK(upper.report.warning.empty());
}

TEST_CASE("what is asked to stop is given up on many points too") {
    auto const T = uniform(interval{0.0, 1.0}, 1000);
    std::stop_source source;
    source.request_stop();
    CHECK_THROWS_WITH_AS(
        (void)solve(middle_of(pendulum, T), T, boundary_values{0.0, 1.0}, no_force{}, detail::straight_line{}, source.get_token()),
        "the equation between the ends of T was given up on request", error::no_convergence);
}

} // namespace many_points_tests
