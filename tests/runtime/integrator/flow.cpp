// SPDX-License-Identifier: BSL-1.0
// The flow of an embedded Lagrangian: it solves its equation, is symplectic, has its order, keeps what it should, and says what
// went wrong.
#include <cmath>

#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "support/orders.hpp"
#include "support/systems.hpp"

namespace flow_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// In 50 digits, between 100 and 200 steps.
template <class L, class Embedding>
double order_on(L const& lagrangian, Embedding const& how) {
    return fitted_order(embed(lagrangian, how), 100, extrapolated_at_one(embed(lagrangian, mid_point), 800));
}

/// M^T J M - J for the map (q, p) -> (q', p') in one degree of freedom is det M - 1; derivatives by central differences whose error is far
/// below the tolerance.
template <class Flow>
float100 area_error(Flow const& flow, float100 const& h) {
    using state_type = state<float100, float100>;
    float100 const e("1e-30");
    auto const step = [&](float100 const& q, float100 const& p) { return flow.step(state_type{0, q, p}, h); };
    float100 const q0(1), p0 = float100(1) / 2;
    auto const a = step(q0 + e, p0), b = step(q0 - e, p0), c = step(q0, p0 + e), d = step(q0, p0 - e);
    float100 const det = (a.q - b.q) * (c.p - d.p) - (c.q - d.q) * (a.p - b.p);
    return abs(det / (4 * e * e) - 1);
}

} // namespace

TEST_CASE("a flow solves its discrete Euler-Lagrange equation to rounding") {
    constexpr unknown q;
    constexpr auto q_o = extend[q];
    auto const T = uniform(0.0, 0.1, 1000);
    auto const EL = variation(integral(pendulum(q_o, Delta_o_plus[q_o]), half(T)));
    auto const x = solve(EL, T, {.q0 = 1.0, .v0 = 0.25});
    // The residual divides values by h^2: its rounding is a few epsilons of |q| / h^2.
    for (double const r : EL.residual(x)) CHECK(std::abs(r) <= 16 * epsilon<double>() * 2.0 / 0.01);
    CHECK(x[0] == 1.0);
    CHECK(x.size() == 1001);

    time_scale<double> const U{0, 0.1, 0.15, 0.3, 0.5, 0.55, 0.8};
    auto const uneven = variation(integral(bead(q_o, Delta_o_plus[q_o]), half(U)));
    auto const y = solve(uneven, U, {.q0 = 1.0, .v0 = 0.25});
    for (double const r : uneven.residual(y)) CHECK(std::abs(r) <= 16 * epsilon<double>() * 2.0 / (0.05 * 0.05));
}

TEST_CASE("orders, fitted in 50 digits") {
    CHECK(order_on(pendulum, mid_point) == doctest::Approx(2).epsilon(0.01));
    CHECK(order_on(pendulum, order_one) == doctest::Approx(1).epsilon(0.02));
    CHECK(order_on(pendulum, order_one_left) == doctest::Approx(1).epsilon(0.02));
    CHECK(order_on(pendulum, theta<1, 3>) == doctest::Approx(1).epsilon(0.02));
    CHECK(order_on(bead, mid_point) == doctest::Approx(2).epsilon(0.01));
    CHECK(order_on(oscillator, mid_point) == doctest::Approx(2).epsilon(0.01));
}

TEST_CASE("every flow preserves area") {
    float100 const h = float100(1) / 10, tolerance("1e-55"); // the differences' own error is 1e-60
    CHECK(area_error(embed(pendulum, mid_point), h) < tolerance);
    CHECK(area_error(embed(pendulum, order_one), h) < tolerance);
    CHECK(area_error(embed(pendulum, order_one_left), h) < tolerance);
    CHECK(area_error(embed(bead, mid_point), h) < tolerance);
    CHECK(area_error(embed(bead, order_one), h) < tolerance);
    CHECK(area_error(embed(bead, theta<1, 3>), h) < tolerance);
}

TEST_CASE("quadratic Lagrangians step exactly in the rationals, and mid-point keeps their energy exactly") {
    hamiltonian const H(oscillator);
    Q const E0 = H(Q(1, 2), Q(1));
    int steps = 0;
    for (auto const& [t, q, p] : embed(oscillator, mid_point).along(uniform(Q(0), Q(1, 5), 12), Q(1), Q(1, 2))) {
        CHECK(H(p, q) == E0);
        CHECK(t == Q(steps, 5));
        ++steps;
    }
    CHECK(steps == 13);
}

TEST_CASE("p_o = dL/dv(q_o, Delta_o_plus[q_o]): definition 12 satisfies the momentum constraint (82), exactly") {
    auto const T = uniform(Q(0), Q(1, 5), 8);
    std::vector<Q> qs, ps;
    for (auto const& at : embed(oscillator, mid_point).along(T, Q(1), Q(1, 2))) {
        qs.push_back(at.q);
        ps.push_back(at.p);
    }
    auto const q = function_on(T, qs), p = function_on(T, ps);
    auto const at = on_half[extend[q]];
    auto const v = on_half[Delta_o_plus[extend[q]]];
    auto const p_o = on_half[extend[p]];
    hamiltonian const H(oscillator);
    for (hilger::index_type i = 0; i < 8; ++i) {
        CHECK(p_o[i] == gradient_second(oscillator, at[i], v[i])); // (82)
        CHECK(v[i] == H.by_momentum(p_o[i], at[i]));               // the second line of (94), on all of T_half
        CHECK(p[i + 1] == gradient_second(oscillator, at[i], v[i]) + Q(1, 10) * gradient_first(oscillator, at[i], v[i])); // (89)
    }
    CHECK(p[0] == gradient_second(oscillator, at[0], v[0]) - Q(1, 10) * gradient_first(oscillator, at[0], v[0])); // (90)
    auto const left = Delta_h_minus[p_o];
    auto const force = apply_pointwise([&](Q const& x, Q const& y) { return Q(-H.by_position(x, y)); }, p_o, at);
    for (hilger::index_type i = 1; i < 8; ++i) CHECK(left[i] == mean_h_minus[force][i]); // the first line of (94), on T_half^-
}

TEST_CASE("mid-point is its own inverse with -h; order one right and left are inverse to each other") {
    state<float50, float50> const start{0, 1, float50(1) / 2};
    float50 const h = float50(1) / 10, tolerance("1e-47");
    auto const returns = [&](auto const& there, auto const& back) {
        auto const end = back.step(there.step(start, h), float50(-h));
        return abs(end.q - start.q) + abs(end.p - start.p) < tolerance;
    };
    CHECK(returns(embed(bead, mid_point), embed(bead, mid_point)));
    CHECK(returns(embed(pendulum, mid_point), embed(pendulum, mid_point)));
    CHECK(returns(embed(bead, order_one), embed(bead, order_one_left)));
    CHECK_FALSE(returns(embed(bead, order_one), embed(bead, order_one)));
}

TEST_CASE("angular momentum of Kepler's ellipse is kept to rounding") {
    using vector = Eigen::Vector2d;
    lagrangian const kepler{[](auto const& x, auto const& v) {
        using std::sqrt;
        return v.dot(v) / 2 + 1 / sqrt(x.dot(x));
    }};
    auto const worst = [&](auto const& how) {
        double most = 0;
        for (auto const& [t, q, p] : embed(kepler, how).along(uniform(0.0, 0.02, 1000), vector(0.4, 0), vector(0, 2)))
            most = std::max(most, std::abs(q(0) * p(1) - q(1) * p(0) - 0.8));
        return most;
    };
    CHECK(worst(mid_point) < 1000 * epsilon<double>());
    CHECK(worst(order_one) < 1000 * epsilon<double>());
}

TEST_CASE("forces add up") {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
    auto const friction = [](auto const&, auto const& v) { return -v / 5; };
    auto const push = [](auto const& t, auto const& x, auto const&) { return t / 3 - x / 7; };
    auto const both = [](auto const& t, auto const& x, auto const& v) { return -v / 5 + (t / 3 - x / 7); };
    auto const T = uniform(Q(0), Q(1, 5), 6);
    auto const at_once = record(embed(with_force(L, both), mid_point).along(T, Q(1), Q(0)));
    auto const in_turn = record(embed(with_force(with_force(L, friction), push), mid_point).along(T, Q(1), Q(0)));
    for (std::size_t i = 0; i < at_once.states.size(); ++i) CHECK(at_once.states[i] == in_turn.states[i]);

    auto const in_space = [](auto const& x, auto const& v) { return v.squaredNorm() / 2 - x.squaredNorm() / 2; };
    auto const drag = [](auto const&, auto const& v) { return -v / 5; }; // an expression
    auto const wind = [](auto const& t, auto const& x, auto const&) { return (cos(t) / 3) * x; };
    auto const all = [](auto const& t, auto const& x, auto const& v) { return -v / 5 + (cos(t) / 3) * x; };
    auto const agree = [&](auto const& x, auto const& p) {
        auto const path = embed(with_force(with_force(in_space, drag), wind), mid_point).along(uniform(0.0, 0.1, 20), x, p);
        auto const one = embed(with_force(in_space, all), mid_point).along(uniform(0.0, 0.1, 20), x, p);
        double most = 0;
        auto other = one.begin();
        for (auto const& y : path) most = std::max(most, (y.q - (*other).q).norm()), ++other;
        CHECK(most <= 1e-14);
        CHECK(largest_residual(path) <= 64 * epsilon<double>() / 0.1);
    };
    agree(Eigen::Vector2d(1, 0.5), Eigen::Vector2d(0, 0.3));
    agree(Eigen::VectorXd(Eigen::VectorXd::LinSpaced(6, 0.1, 0.9)), Eigen::VectorXd(Eigen::VectorXd::LinSpaced(6, 0.3, -0.2)));
    auto const of_two = [](auto const&, auto const& v) { return v.head(2).eval(); };
    Eigen::VectorXd const three = Eigen::VectorXd::Ones(3);
    CHECK_THROWS_AS(
        (void)record(embed(with_force(with_force(in_space, drag), of_two), mid_point).along(uniform(0.0, 0.1, 2), three, three)),
        error::mismatch);
}

TEST_CASE("families of points that are not equal steps apart, of a uniform T, are walked as the points that they are") {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
    auto const same = [&](auto const& points) {
        std::vector<Q> given;
        for (Q const& t : points) given.push_back(t);
        auto const walked = record(embed(L, mid_point).along(points, Q(1), Q(0)));
        auto const again = record(embed(L, mid_point).along(time_scale<Q>(given), Q(1), Q(0)));
        REQUIRE(walked.states.size() == again.states.size());
        for (std::size_t i = 0; i < given.size(); ++i) CHECK(walked.states[i] == again.states[i]);
    };
    auto const T = uniform(Q(0), Q(1, 2), 4);
    same(circ<1, 3>(T));
    same(subdivide<3>(T));
    same(at_lambda<1, 3>(T));
    // Gauss' nodes are not rational
    auto const at_gauss = embed(L, mid_point).along(at_nodes<gauss, 2>(uniform(0.0, 0.5, 4)), 1.0, 0.0);
    CHECK(largest_residual(at_gauss) <= 64 * epsilon<double>() / 0.2);
    double end = 0;
    for (auto const& x : at_gauss) end = x.q;
    CHECK(std::abs(end - std::cos(2 - 2 * (0.5 - std::sqrt(3.0) / 6) / 2)) < 0.02);
}

TEST_CASE("what goes wrong is said, and the trajectory so far is kept") {
    auto const T = uniform(0.0, 0.1, 10);
    double const infinity = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH_AS((void)embed(pendulum, mid_point).along(T, std::nan(""), 0.0),
                         "the initial position and momentum are finite numbers, and these contain NaN or infinity", error::not_finite);
    CHECK_THROWS_AS((void)embed(pendulum, mid_point).along(T, 0.0, infinity), error::not_finite);
    auto const relativistic = embed(lagrangian{[](auto const&, auto const& v) { return -sqrt(1 - v * v); }}, mid_point);
    for (double const faster : {1.0, 1.5})
        CHECK_THROWS_WITH_AS((void)relativistic.along(T, initial_velocity{0.0, faster}),
                             "the momentum dL/dv at the initial position and velocity is NaN or infinity, and they are finite: L has none "
                             "there",
                             error::not_finite);

    lagrangian const massless{[](auto const& x, auto const& v) { return x * v; }};
    auto const walk = [&](auto const& L, auto const& scale, double q0, double p0) {
        for (auto const& at : embed(L, mid_point).along(scale, q0, p0)) (void)at;
    };
    CHECK_THROWS_AS(walk(massless, T, 1.0, 0.0), error::singular);

    // Falls into the singularity of log: the states before are right and kept.
    lagrangian const falling{[](auto const& x, auto const& v) {
        using std::sqrt;
        return v * v / 2 - 1 / sqrt(x);
    }};
    try {
        walk(falling, uniform(0.0, 0.5, 100), 1.0, -4.0);
        FAIL("a particle that runs into its singularity must be reported");
    } catch (interrupted<double, double> const& stopped) {
        CHECK(is_finite(stopped.last.q));
        CHECK(is_finite(stopped.last.p));
        CHECK(stopped.last.t < 50);
    }
    // y - 1 = 5 ((1 + y)/2)^2 has no real solution.
    lagrangian const cubic{[](auto const& x, auto const& v) { return v * v / 2 + 10 * x * x * x / 3; }};
    try {
        walk(cubic, uniform(0.0, 1.0, 3), 1.0, 0.0);
        FAIL("an equation without a solution must be reported");
    } catch (error::no_convergence const& e) {
        CHECK(std::string(e.what()).find("the step from t = 0 with h = 1 failed: the step p = -d_1 L_h(q, y) did not converge. A smaller "
                                         "step h brings the guess closer") == 0);
        CHECK(dynamic_cast<interrupted<double, double> const&>(e).last.q == 1.0);
    }
    CHECK_THROWS_AS((void)embed(cubic, mid_point).step(state<Q, Q>{0, 1, 0}, Q(1, 10)), error::no_convergence);
}

} // namespace flow_tests
