// SPDX-License-Identifier: BSL-1.0
// Equations solved between two ends: the derived equation is the judge, and what initial values lead to.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace ends_tests {

using namespace hilger;

namespace {

constexpr unknown q;
constexpr unknown<"q", subdivided<2>> y;
constexpr lagrangian pendulum{[](auto const& x, auto const& v) { return v * v / 2 - (1 - cos(x)); }};
constexpr lagrangian quadratic{[](auto const& t, auto const& x, auto const& v) { return v * v / 2 + x * v / 3 - (1 + t) * x * x / 2; }};
constexpr lagrangian in_space{
    [](auto const& x, auto const& v) { return v.dot(v) / 2 + v(0) * x(1) / 3 - x.dot(x) / 2 - x(0) * x(0) * x(1) * x(1) / 4; }};

template <class R>
Q largest(R const& residual) {
    Q most(0);
    for (Q const& r : residual) most = std::max(most, Q(abs(r)));
    return most;
}
/// In rationals the equation holds, and the ends are those.
template <class T, class Action>
void holds_exactly(T const& scale, Action const& S) {
    auto const EL = variation(S);
    auto const x = solve(EL, scale, {.q0 = Q(1, 2), .qN = Q(-2, 3)});
    CHECK(x.get(0) == Q(1, 2));
    CHECK(x.get(x.size() - 1) == Q(-2, 3));
    CHECK(largest(EL.residual(x)) == 0);

    auto const force = [](auto const& t, auto const& z, auto const& v) { return t * z / 5 - v / 3 + 1; };
    auto const with_force = solve(EL, scale, {.q0 = Q(1, 2), .qN = Q(-2, 3)}, force);
    CHECK(with_force.get(x.size() - 1) == Q(-2, 3));
    CHECK(largest(EL.residual(with_force, force)) == 0);
    CHECK(largest(EL.residual(with_force)) > Q(1, 100));
}
template <class T>
void holds_exactly_on(T const& scale) {
    holds_exactly(scale, integral(quadratic(q, Delta_plus[q]), scale));
    holds_exactly(scale, nabla_integral(quadratic(q, Delta_minus[q]), scale));
    holds_exactly(scale, integral(quadratic(extend[q], Delta_o_plus[extend[q]]), half(scale)));
    constexpr polynomial_value<2, lobatto, 3> value; // Simpson's rule, whose nodes are rational
    constexpr polynomial_slope<2, lobatto, 3> slope;
    holds_exactly(scale, integral(quadratic(value[y], slope[y]), at_nodes<lobatto, 3>(scale)));
}

} // namespace

TEST_CASE("in rational numbers the equation holds exactly, inside the steps too") {
    holds_exactly_on(uniform(Q(0), Q(1, 7), 6));
    holds_exactly_on(time_scale<Q>{Q(0), Q(1, 7), Q(1, 3), Q(1, 2), Q(4, 5)});
}

TEST_CASE("what initial values lead to is found again from its ends") {
    auto const T = uniform(0.0, 0.05, 40);
    auto const EL = variation(integral(pendulum(extend[q], Delta_o_plus[extend[q]]), half(T)));
    auto const x = solve(EL, T, {.q0 = 0.3, .v0 = 1.2});
    auto const again = solve(EL, T, {.q0 = x[0], .qN = x[40]});
    for (index_type i = 0; i < T.size(); ++i) CHECK(std::abs(again[i] - x[i]) <= 4096 * epsilon<double>());

    auto const in_plane = variation(integral(in_space(q, Delta_plus[q]), T));
    auto const found_again = [&](auto const& q0, auto const& v0) {
        auto const z = solve(in_plane, T, initial_velocity{q0, v0});
        auto const back = solve(in_plane, T, boundary_values{z[0], z[40]});
        for (index_type i = 0; i < T.size(); ++i) CHECK((back[i] - z[i]).norm() <= 4096 * epsilon<double>());
    };
    found_again(Eigen::Vector2d(0.3, -0.2), Eigen::Vector2d(0.5, 0.4));
    found_again(Eigen::VectorXd(Eigen::Vector3d(0.3, -0.2, 1)), Eigen::VectorXd(Eigen::Vector3d(0.5, 0.4, -1)));
    CHECK(solve(in_plane, T, {.q0 = {0.3, -0.2}, .qN = {0.5, 0.4}})[40] == Eigen::Vector2d(0.5, 0.4));

    // against a drag too
    auto const drag = [](auto const&, auto const& v) { return -(v.norm() * v) / 5; };
    auto const dragged = embed(with_force(in_space, drag), order_one);
    auto const found_with_drag = [&](auto const& q0, auto const& v0) {
        auto const path = record(dragged.along(T, initial_velocity{q0, v0}));
        auto const back = solve(in_plane, T, boundary_values{path.states[0].q, path.states[40].q}, drag);
        for (index_type i = 0; i < T.size(); ++i) CHECK((back[i] - path.states[i].q).norm() <= 4096 * epsilon<double>());
    };
    found_with_drag(Eigen::Vector2d(0.3, -0.2), Eigen::Vector2d(0.5, 0.4));
    found_with_drag(Eigen::VectorXd(Eigen::Vector3d(0.3, -0.2, 1)), Eigen::VectorXd(Eigen::Vector3d(0.5, 0.4, -1)));
    CHECK(solve(in_plane, T, {.q0 = {0.3, -0.2}, .qN = {0.5, 0.4}}, drag)[40] == Eigen::Vector2d(0.5, 0.4));
}

TEST_CASE("a straight line that whole corrections lead away from") {
    for (index_type const n : {100, 1000}) {
        auto const T = uniform(interval{0.0, 10.0}, n);
        auto const EL = variation(integral(pendulum(extend[q], Delta_o_plus[extend[q]]), half(T)));
        for (double const end : {-0.5, 1.2, 7.5}) {
            auto const x = solve(EL, T, {.q0 = 1.0, .qN = end});
            CHECK(x[0] == 1.0);
            CHECK(x[n] == end);
            double most = 0;
            for (index_type i = 0; i <= n; ++i) most = std::max(most, std::abs(x[i]));
            // the rounding of a second difference, and of an elimination with as large entries
            CHECK(largest_residual(EL, x) <= 16 * epsilon<double>() * most / (T.step(0) * T.step(0)));
        }
    }
}

TEST_CASE("the straight line is one in time, on points that are not equally far apart too") {
    // slower than light it is the solution; between points by their numbers it would be faster in the steps of 1/100
    constexpr lagrangian relativistic{[](auto const&, auto const& v) { return -sqrt(1 - v * v); }};
    time_scale<double> const T{0.0, 0.05, 0.13, 0.2, 0.21, 0.3, 0.45, 0.5, 0.51, 0.7};
    auto const check = [&](auto const& EL, auto const& times) {
        auto const x = solve(EL, T, {.q0 = 0.25, .qN = 0.75});
        for (index_type i = 0; i < x.size(); ++i) CHECK(std::abs(x[i] - (0.25 + times[i] / 1.4)) <= 8 * epsilon<double>());
        CHECK(largest_residual(EL, x) <= 64 * epsilon<double>() / 0.01);
    };
    check(variation(integral(relativistic(q, Delta_plus[q]), T)), std::vector<double>(T.begin(), T.end()));
    std::vector<double> with_middles;
    for (index_type i = 0; i < T.steps(); ++i) with_middles.insert(with_middles.end(), {T.point(i), T.point(i) + T.step(i) / 2});
    with_middles.push_back(0.7);
    check(variation(
              integral(relativistic(polynomial_value<2, lobatto, 3>{}[y], polynomial_slope<2, lobatto, 3>{}[y]), at_nodes<lobatto, 3>(T))),
          with_middles);
}

TEST_CASE("of several solutions the one near a first guess") {
    auto const T = uniform(interval{0.0, 10.0}, 100);
    auto const EL = variation(integral(pendulum(extend[q], Delta_o_plus[extend[q]]), half(T)));
    // The ends of a motion are those of others too.
    auto const swinging = solve(EL, T, {.q0 = 1.0, .v0 = 0.0});
    boundary_values<double> const ends{1.0, swinging[100]};
    auto const near = [](auto const& x, auto const& y) {
        double most = 0;
        for (index_type i = 0; i < x.size(); ++i) most = std::max(most, std::abs(x[i] - y[i]));
        return most;
    };
    auto const guess = function_on(T, [](double t) { return 1.05 * std::cos(0.95 * t); });
    CHECK(near(solve(EL, T, ends, no_force{}, guess), swinging) <= 1e-11);
    auto const thrown = solve(EL, T, ends, no_force{}, function_on(T, [](double t) { return 2 * std::sin(0.5 * t); }));
    CHECK(thrown[100] == swinging[100]);
    CHECK(largest_residual(EL, thrown) <= 1e-11);
    CHECK(near(thrown, swinging) > 1);
    auto const in_braces = solve(EL, T, {.q0 = 1.0, .qN = swinging[100]}, no_force{}, swinging);
    CHECK(near(in_braces, swinging) <= 1e-11);

    // with points inside the steps, and with vectors
    auto const inner = equation_of(embed(pendulum, galerkin<3, lobatto>), T);
    auto const at_all = solve(inner, T, {.q0 = 1.0, .v0 = 0.0});
    CHECK(at_all.size() > T.size());
    CHECK(near(solve(inner, T, boundary_values{1.0, at_all[at_all.size() - 1]}, no_force{}, guess), at_all) <= 1e-11);
    auto const in_plane = equation_of(embed(in_space, order_one), T);
    Eigen::Vector2d const first(0.3, -0.2), last(0.5, 0.4);
    auto const line = function_on(T, [&](double t) { return Eigen::Vector2d(first + t / 10 * (last - first)); });
    auto const by_line = solve(in_plane, T, boundary_values{first, last}, no_force{}, line),
               by_itself = solve(in_plane, T, boundary_values{first, last});
    for (index_type i = 0; i < T.size(); ++i) CHECK((by_line[i] - by_itself[i]).norm() <= 1e-11);

    CHECK_THROWS_WITH_AS((void)solve(EL, T, ends, no_force{}, function_on(uniform(0.0, 0.1, 50), [](double t) { return t; })),
                         doctest::Contains("a first guess is a function on T = {0, 0.1"), error::mismatch);
}

TEST_CASE("what is asked to stop is given up, and what is not asked is the same") {
    auto const T = uniform(0.0, 0.1, 10);
    auto const EL = variation(integral(pendulum(q, Delta_plus[q]), T));
    auto const two_sided = variation(nabla_integral(pendulum(q, Delta_minus_alpha<3, 4>[q]), T));
    boundary_values<double> const ends{0.25, 1.0};
    auto const line = function_on(T, [](double t) { return 0.25 + 0.75 * t; });
    std::stop_source source;
    auto const stop = source.get_token();
    auto const x = solve(EL, T, ends, no_force{}, line), y = solve(EL, T, ends, no_force{}, line, stop);
    for (index_type i = 0; i < T.size(); ++i) CHECK(x[i] == y[i]);
    CHECK(solve(two_sided, T, ends, boundary_options{.stop = stop}).q[5] == solve(two_sided, T, ends)[5]);
    source.request_stop();
    CHECK_THROWS_WITH_AS((void)solve(EL, T, ends, no_force{}, line, stop), "the equation between the ends of T was given up on request",
                         error::no_convergence);
    CHECK_THROWS_WITH_AS((void)solve(two_sided, T, ends, boundary_options{.stop = stop}),
                         "a boundary value problem was given up on request", error::no_convergence);
}

TEST_CASE("the order between ends is that of the step") {
    // x'' = -x, x(0) = 0, x(1) = sin 1
    auto const error = [](index_type n) {
        auto const T = uniform(interval{float50(0), float50(1)}, n);
        constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
        auto const x = solve(variation(integral(L(extend[q], Delta_o_plus[extend[q]]), half(T))), T, {.q0 = 0, .qN = sin(float50(1))});
        return float50(abs(x[n / 2] - sin(float50(1) / 2)));
    };
    CHECK(std::abs(static_cast<double>(log(error(32) / error(64)) / log(float50(2))) - 2) <= 0.02);
}

TEST_CASE("the two-sided equation of fractional order, and one step") {
    auto const T = uniform(0.0, 0.1, 10);
    auto const two_sided = variation(nabla_integral(pendulum(q, Delta_minus_alpha<3, 4>[q]), T));
    auto const x = solve(two_sided, T, {.q0 = 0.25, .qN = 1.0});
    auto const y = solve(two_sided, T, {.q0 = 0.25, .qN = 1.0}, boundary_options{}).q;
    for (index_type i = 0; i < T.size(); ++i) CHECK(x[i] == y[i]);
    auto const one = uniform(0.0, 0.5, 1);
    auto const z = solve(variation(integral(pendulum(q, Delta_plus[q]), one)), one, {.q0 = 0.25, .qN = 1.0});
    CHECK(z[0] == 0.25);
    CHECK(z[1] == 1.0);
    auto const whole = solve(variation(integral(pendulum(q, Delta_plus[q]), T)), T, boundary_values{0, 1}); // numbers as they are meant
    CHECK(whole[10] == 1.0);
    CHECK(0.3 < whole[5]);
    CHECK(whole[5] < 0.6);
}

TEST_CASE("ends that determine nothing, do not fit or are no numbers") {
    // q_2 - (2 - h^2 omega^2) q_1 + q_0 = 0 with h^2 omega^2 = 2
    constexpr lagrangian resonant{[](auto const& x, auto const& v) { return v * v / 2 - x * x; }};
    auto const T = uniform(Q(0), Q(1), 2);
    CHECK_THROWS_WITH_AS((void)solve(variation(integral(resonant(q, Delta_plus[q]), T)), T, {.q0 = 1, .qN = 1}),
                         doctest::Contains("the two ends must determine what lies between them"), error::singular);
    auto const D = uniform(0.0, 0.1, 10);
    auto const EL = variation(integral(in_space(q, Delta_plus[q]), D));
    Eigen::VectorXd const two = Eigen::VectorXd::Ones(2), three = Eigen::VectorXd::Ones(3);
    CHECK_THROWS_WITH_AS((void)solve(EL, D, boundary_values{two, three}), doctest::Contains("the boundary values"), error::mismatch);
    CHECK_THROWS_AS((void)solve(EL, D, boundary_values{two, Eigen::VectorXd(two / 0.0)}), error::not_finite);
}

} // namespace ends_tests
