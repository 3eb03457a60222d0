// SPDX-License-Identifier: BSL-1.0
// Between two ends that the motions of one point come back to before, solutions are many, and the straight line leads whole corrections of
// Newton's method far away or nowhere.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"

namespace near_ends_tests {

using namespace hilger;

namespace {

using V2 = Eigen::Vector2d;
constexpr unknown q;

/// A double pendulum; its faster oscillation takes 1.09 in the units of time here.
struct double_pendulum {
    double g = 9.81;
    template <class X, class Y>
    auto operator()(X const& x, Y const& v) const {
        return v[0] * v[0] + v[1] * v[1] / 2 + v[0] * v[1] * cos(x[0] - x[1]) + g * (2 * cos(x[0]) + cos(x[1]));
    }
};
auto equation_on(auto const& T, double g) {
    lagrangian const L{double_pendulum{g}};
    return variation(integral(L(extend[q], Delta_o_plus[extend[q]]), half(T)));
}
template <class X, class Y>
double distance(X const& x, Y const& y) {
    double most = 0;
    for (index_type i = 0; i < x.size(); ++i) most = std::max(most, (x[i] - y[i]).template lpNorm<Eigen::Infinity>());
    return most;
}
/// By a weight that grows from none, from the straight line.
template <class T>
auto by_growing_weight(T const& scale, auto const& line, boundary_values<V2> const& ends) {
    auto x = function_on(scale, std::vector<V2>(line.begin(), line.end()));
    for (int k = 1; k <= 5; ++k) x = solve(equation_on(scale, 9.81 * k / 5), scale, ends, no_force{}, x);
    return x;
}
template <class T>
void is_found_near(T const& scale, std::initializer_list<std::pair<double, double>> all) {
    auto const EL = equation_on(scale, 9.81);
    double const end = scale.point(scale.steps());
    for (auto const& [first, last] : all) {
        double const a = first, b = last;
        CAPTURE(a);
        CAPTURE(b);
        boundary_values<V2> const ends{V2(a, b), V2(b / 4, -a / 2)};
        auto const line = function_on(scale, [&](double t) { return V2(ends.q0 + t / end * (ends.qN - ends.q0)); });
        auto const x = solve(EL, scale, ends);
        CHECK(largest_residual(EL, x) <= 1e-11);
        CHECK(distance(solve(EL, scale, ends, no_force{}, line), x) <= 1e-9); // who guesses it is led no worse
        CHECK(distance(x, line) <= distance(by_growing_weight(scale, line, ends), line) + 1e-9);
    }
}

} // namespace

TEST_CASE("a solution near the straight line is found, behind the time at which motions meet again") {
    is_found_near(uniform(0.0, 0.03, 20), {{-1.2, -1.1}, {-0.15, 0.17}});
    is_found_near(time_scale<double>{0.0, 0.02, 0.05, 0.09, 0.13, 0.16, 0.2, 0.24, 0.27, 0.31, 0.36, 0.4, 0.43, 0.47, 0.5, 0.55, 0.6},
                  {{0.6, 0.7}});
}

TEST_CASE("ends that Newton's method from the straight line leaves, or does not come to") {
    auto const T = uniform(0.0, 0.03, 20);
    auto const EL = equation_on(T, 9.81);
    auto const x = solve(EL, T, boundary_values{V2(-1.2, -1.1), V2(0, 0.7)});
    CHECK(std::abs(x[10][1] - 0.395) < 0.001); // by growing weight; whole corrections come to -2.60
    auto const of_any_size = solve(EL, T, boundary_values<Eigen::VectorXd>{V2(-1.2, -1.1), V2(0, 0.7)});
    CHECK(distance(of_any_size, x) <= 1e-10);
    auto const y = solve(EL, T, boundary_values{V2(-0.15, -0.27), V2(0.25, 0.17)});
    CHECK(largest_residual(EL, y) <= 1e-11);
}

TEST_CASE("behind the place where Newton's path turns back no zigzag far away is taken for a motion") {
    lagrangian const L{[](auto const& x, auto const& v) { return v * v / 2 - x * x * x * x; }};
    int refused = 0;
    for (double const length : {1.5, 2.0, 2.5, 3.0})
        for (index_type const steps : {40, 120}) {
            auto const T = uniform(interval{0.0, length}, steps);
            auto const EL = variation(integral(L(q, Delta_plus[q]), T));
            try {
                double most = 0;
                for (double const y : solve(EL, T, {.q0 = 0.0, .qN = -1.0})) most = std::max(most, std::abs(y));
                CHECK(most < 3); // shooting finds motions of 1.05 to 1.55, and 2.65, here; zigzags have 25 to 80
            } catch (error::no_convergence const&) {
                ++refused;
            }
        }
    CHECK(refused > 0);
    // from a guess near it the motion is found
    auto const T = uniform(interval{0.0, 1.5}, 120);
    auto const EL = variation(integral(L(extend[q], Delta_o_plus[extend[q]]), half(T)));
    auto const x = solve(EL, T, boundary_values{0.0, -1.0}, no_force{}, function_on(T, [](double t) { return 2.5 * std::sin(2.4 * t); }));
    CHECK(relative_residual(EL, x) <= 16);
}

TEST_CASE("at infinity, where derivatives vanish, nothing is solved") {
    lagrangian const L{[](auto const& x, auto const& v) { return v.squaredNorm() / (x(1) * x(1)) / 2; }};
    for (index_type const steps : {16, 20, 24}) { // half a circle, geodesic of the half-plane
        auto const T = uniform(interval{0.0, 1.0}, steps);
        auto const EL = variation(integral(L(extend[q], Delta_o_plus[extend[q]]), half(T)));
        try {
            for (V2 const& x : solve(EL, T, boundary_values{V2(-1, 0.2), V2(1, 0.2)})) CHECK(x.norm() < 1.1);
        } catch (error::no_convergence const&) {
            // from half a circle it is found
            auto const circle = function_on(T, [](double t) {
                double const s = std::asinh(5.0) * (2 * t - 1), R = std::sqrt(1.04);
                return V2(R * std::tanh(s), R / std::cosh(s));
            });
            CHECK(distance(solve(EL, T, boundary_values{V2(-1, 0.2), V2(1, 0.2)}, no_force{}, circle), circle) < 0.01);
        }
    }
}

TEST_CASE("a wall between two states, which may be anywhere, is solved to rounding") {
    auto const T = uniform(0.0, 1.0 / 100, 100);
    lagrangian const two_wells{[](auto const& x, auto const& v) { return v * v / 2 + 500 * (x * x - 1) * (x * x - 1); }};
    auto const EL = variation(integral(two_wells(extend[q], Delta_o_plus[extend[q]]), half(T)));
    // second differences round by epsilon / h^2, and forces by epsilon d2U/dq2
    CHECK(largest_residual(EL, solve(EL, T, {.q0 = -1.0, .qN = 1.0})) <= 16 * epsilon<double>() * (100 * 100 + 4000));
}

TEST_CASE("beside a distance of any size an angle has its own digits, and what has no solution is refused") {
    auto const T = uniform(interval{0.0, 1.0}, 50);
    auto const equation_of = [&](auto const& of_first) {
        lagrangian const L{[of_first](auto const& x, auto const& v) { return of_first(x[0], v[0]) + v[1] * v[1] / 2; }};
        return variation(integral(L(extend[q], Delta_o_plus[extend[q]]), half(T)));
    };
    auto const pendulum = equation_of([](auto const& x, auto const& v) { return v * v / 2 + 9 * cos(x); });
    auto const soap_film = equation_of([](auto const& x, auto const& v) { return x * sqrt(1 + v * v); }); // at most 0.66 of the rings
    auto const alone = solve(pendulum, T, boundary_values{V2(1, 0), V2(2, 1)});
    for (double const distance : {1e6, 1e12, 1e15}) {
        CAPTURE(distance);
        auto const x = solve(pendulum, T, boundary_values{V2(1, 0), V2(2, distance)});
        CHECK(relative_residual(pendulum, x) <= 4);
        for (index_type i = 0; i <= T.steps(); ++i) CHECK(std::abs(x[i][0] - alone[i][0]) <= 1e-11);
        CHECK_THROWS_AS(solve(soap_film, T, boundary_values{V2(0.5, 0), V2(0.5, distance)}), error::no_convergence);
    }
}

TEST_CASE("with a force, on the way too") {
    auto const T = uniform(0.0, 0.03, 20);
    auto const EL = equation_on(T, 9.81);
    auto const drag = [](auto const&, auto const& v) { return -0.1 * v; };
    auto const x = solve(EL, T, boundary_values{V2(-0.15, -0.27), V2(0.25, 0.17)}, drag);
    CHECK(largest_residual(EL, x, drag) <= 1e-11);
}

} // namespace near_ends_tests
