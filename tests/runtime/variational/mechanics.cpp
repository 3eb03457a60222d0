// SPDX-License-Identifier: BSL-1.0
// What can be stepped: Lagrangians with time, with magnetic terms, with a mass that depends on the position, of any dimension;
// Hamiltonians; forces; derivatives given by hand; structured systems. Each way to say one thing gives the same trajectory.
#include <cmath>

#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "support/orders.hpp"
#include "support/systems.hpp"

namespace mechanics_tests {

using namespace hilger;

namespace {

using vector2 = Eigen::Vector2d;

/// Two pendulums of length and mass one, g = 1; q are the angles.
constexpr lagrangian double_pendulum{[](auto const& q, auto const& v) {
    return v(0) * v(0) + v(1) * v(1) / 2 + v(0) * v(1) * cos(q(0) - q(1)) + 2 * cos(q(0)) + cos(q(1));
}};
/// A charge in a constant magnetic field across the plane and a harmonic trap.
constexpr lagrangian charge{[](auto const& q, auto const& v) { return v.dot(v) / 2 + (q(0) * v(1) - q(1) * v(0)) - q.dot(q) / 8; }};

template <class S, class V>
double distance(state<S, V> const& x, state<S, V> const& y) {
    return static_cast<double>(magnitude(V(x.q - y.q)) + magnitude(V(x.p - y.p)));
}
template <class Path>
auto end_of(Path const& path) {
    auto i = path.begin();
    auto last = *i;
    for (; not(i == std::default_sentinel); ++i) last = *i;
    return last;
}

} // namespace

TEST_CASE("fixed and dynamic vectors step alike") {
    auto const T = uniform(0.0, 0.05, 100);
    vector2 const q(1.0, 0.5), p(0.2, -0.1);
    Eigen::VectorXd const qx(q), px(p);
    auto const check = [&](auto const& L, auto const& how) {
        auto const x = end_of(embed(L, how).along(T, q, p));
        auto const y = end_of(embed(L, how).along(T, qx, px));
        CHECK((x.q - y.q).norm() < 1e-12);
        CHECK((x.p - y.p).norm() < 1e-12);
        CHECK((x.q - q).norm() > 0.1);
    };
    check(double_pendulum, mid_point);
    check(double_pendulum, galerkin<2, gauss>);
}

TEST_CASE("nine components: derivatives are put together from parts") {
    using vector9 = Eigen::Matrix<double, 9, 1>;
    // neither separable nor symmetric in its components
    auto const L = [](auto const& q, auto const& v) {
        auto sum = v.dot(v) / 2 - q.dot(q) / 2;
        for (int k = 0; k < 9; ++k) sum = sum + v(k) * (q((k + 4) % 9) * q((k + 2) % 9) + v((k + 5) % 9) / 4) / (5 + k);
        return sum;
    };
    vector9 q, v;
    for (int k = 0; k < 9; ++k) q(k) = 0.3 * k - 1, v(k) = 0.7 - 0.2 * k;
    auto const e = expand(L, q, v);
    // against dense central differences of the exact gradients
    double const h = 1e-6;
    for (int k = 0; k < 9; ++k) {
        vector9 step = vector9::Zero();
        step(k) = h;
        vector9 const qq = (gradient_first(L, vector9(q + step), v) - gradient_first(L, vector9(q - step), v)) / (2 * h);
        vector9 const qv = (gradient_first(L, q, vector9(v + step)) - gradient_first(L, q, vector9(v - step))) / (2 * h);
        vector9 const vv = (gradient_second(L, q, vector9(v + step)) - gradient_second(L, q, vector9(v - step))) / (2 * h);
        CHECK((e.qq.col(k) - qq).norm() < 1e-8);
        CHECK((e.qv.col(k) - qv).norm() < 1e-8);
        CHECK((e.vv.col(k) - vv).norm() < 1e-8);
    }
    CHECK((e.by_q - gradient_first(L, q, v)).norm() < 1e-14);
    CHECK((e.by_v - gradient_second(L, q, v)).norm() < 1e-14);
}

TEST_CASE("a Hamiltonian steps as its Lagrangian does") {
    auto const T = uniform(0.0, 0.05, 100);
    // p = (v_0 - q_1, v_1 + q_0) for the charge
    auto const H = [](auto const& p, auto const& q) {
        auto const a = p(0) + q(1), b = p(1) - q(0);
        return (a * a + b * b) / 2 + q.dot(q) / 8;
    };
    vector2 const q(1.0, 0.5), p(0.2, -0.1);
    CHECK(distance(end_of(embed(lagrangian_of(H), mid_point).along(T, q, p)), end_of(embed(charge, mid_point).along(T, q, p))) < 1e-12);
    // quartic in p: no closed form for the velocity
    auto const steep = [](auto const& r, auto const& x) { return r * r / 2 + r * r * r * r / 4 + x * x / 2; };
    auto const L = lagrangian_of(steep);
    double const v = 3 + 27;
    CHECK(L.momentum(0.5, v) == doctest::Approx(3).epsilon(1e-14));
    CHECK(momentum_of(L, 0.5, v) == doctest::Approx(3).epsilon(1e-14));
    hamiltonian const back(L); // H from L from H
    CHECK(back(3.0, 0.5) == doctest::Approx(steep(3.0, 0.5)).epsilon(1e-13));
    // and it conserves the energy to the order of the method
    double worst = 0;
    for (auto const& [t, x, r] : embed(L, mid_point).along(uniform(0.0, 0.01, 1000), 1.0, 0.5))
        worst = std::max(worst, std::abs(steep(r, x) - steep(0.5, 1.0)));
    CHECK(worst < 1e-4);
}

TEST_CASE("time in the Lagrangian or the Hamiltonian: order 2 on a driven oscillator, in 50 digits") {
    // q'' = -q + cos(2t), q(0) = 1, q'(0) = 0: q = (4 cos t - cos 2t) / 3
    auto const driven = [](auto const& t, auto const& q, auto const& v) { return v * v / 2 - q * q / 2 + q * cos(float50(2 * t)); };
    auto const H = [](auto const& t, auto const& p, auto const& q) { return p * p / 2 + q * q / 2 - q * cos(float50(2 * t)); };
    auto const order = [](auto const& flow, int n) {
        auto const error = [&](int number) {
            auto const x = end_of(flow.along(uniform(interval<float50>{0, 1}, number), float50(1), float50(0)));
            return abs(float50(x.q - (4 * cos(float50(1)) - cos(float50(2))) / 3)) +
                   abs(float50(x.p + (4 * sin(float50(1)) - 2 * sin(float50(2))) / 3));
        };
        return testing::order_of(float50(error(n)), float50(error(2 * n)));
    };
    CHECK(std::abs(order(embed(driven, mid_point), 40) - 2) < 0.02);
    CHECK(std::abs(order(embed(lagrangian_of(H), mid_point), 40) - 2) < 0.02);
    CHECK(std::abs(order(embed(driven, galerkin<2, gauss>), 40) - 4) < 0.02);
    CHECK(std::abs(order(embed(driven, order_one), 100) - 1) < 0.02);
}

TEST_CASE("Lagrange-d'Alembert: the forced mid-point embedding has order 2 with damping and driving") {
    // q'' = -q - q'/5 + sin t
    auto const force = [](auto const& t, auto const&, auto const& v) { return -v / 5 + sin(t); };
    auto const forced = with_force([](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; }, force);
    auto const end = [&](auto const& how, int n) {
        return end_of(embed(forced, how).along(uniform(interval<float50>{0, 1}, n), float50(1), float50(1) / 2));
    };
    auto const reference = end(galerkin<6, gauss>, 20);
    auto const order = [&](auto const& how, int n) {
        auto const a = end(how, n), b = end(how, 2 * n);
        return testing::order_of(float50(a.q - reference.q), float50(b.q - reference.q));
    };
    CHECK(std::abs(order(mid_point, 80) - 2) < 0.02);
    CHECK(std::abs(order(order_one, 200) - 1) < 0.02);
    CHECK(std::abs(order(galerkin<2, gauss>, 20) - 4) < 0.02);
    // the reference itself: the damped, driven oscillator in closed form
    float50 const w = sqrt(float50(99)) / 10, e = exp(float50(-1) / 10);
    // particular solution -5 cos t; the rest starts from q = 6, q' = 1/2
    float50 const exact = -5 * cos(float50(1)) + e * (6 * cos(w) + (float50(1) / 2 + float50(6) / 10) / w * sin(w));
    CHECK(abs(float50(reference.q - exact)) < float50("1e-15"));
}

TEST_CASE("the discrete Euler-Lagrange equation of a driven, damped system is solved by its flow") {
    constexpr unknown q;
    constexpr auto q_o = extend[q];
    auto const driven = [](auto const& t, auto const& x, auto const& v) { return v * v / 2 - x * x / 2 + x * t * t / 3; };
    auto const friction = [](auto const& t, auto const& x, auto const& v) { return -v * x * t / 7; };
    auto const check = [&](auto const& T) {
        auto const EL = variation(integral(lagrangian(driven)(q_o, Delta_o_plus[q_o]), half(T)));
        auto const steps = make_embedding<hilger::step_weight>(mid_point.position, mid_point.velocity, "mid-point");
        std::vector<double> forced, free;
        for (auto const& x : embed(with_force(driven, friction), steps).along(T, 1.0, 0.5)) forced.push_back(x.q);
        for (auto const& x : embed(driven, steps).along(T, 1.0, 0.5)) free.push_back(x.q);
        // residuals divide values near 1 by h^2
        for (double const r : EL.residual(function_on(T, forced), friction)) CHECK(std::abs(r) < 32 * epsilon<double>() / 0.0025);
        for (double const r : EL.residual(function_on(T, free))) CHECK(std::abs(r) < 32 * epsilon<double>() / 0.0025);
        CHECK(std::abs(EL.residual(function_on(T, forced))[3]) > 1e-3);
    };
    check(uniform(0.5, 0.1, 20));
    check(time_scale<double>{0.5, 0.6, 0.65, 0.8, 1.0, 1.3});
}

TEST_CASE("forces on vectors: a force that is -grad U is U") {
    auto const free = [](auto const&, auto const& v) { return v.dot(v) / 2; };
    auto const spring = [](auto const& q, auto const&) { return (-q).eval(); };
    auto const trapped = [](auto const& q, auto const& v) { return v.dot(v) / 2 - q.dot(q) / 2; };
    auto const T = uniform(0.0, 0.1, 100);
    vector2 const q(1.0, 0.0), p(0.3, 0.4);
    CHECK(distance(end_of(embed(with_force(free, spring), mid_point).along(T, q, p)), end_of(embed(trapped, mid_point).along(T, q, p))) <
          1e-13);
}

namespace {
/// A pendulum with its derivatives written by hand.
struct by_hand {
    double operator()(double q, double v) const { return v * v / 2 + std::cos(q); }
    [[nodiscard]] expansion<double> expand(double q, double v) const {
        return {-std::sin(q), v, -std::cos(q), 0.0, 1.0, {dependence::no_polynomial, 2, false}};
    }
};
} // namespace

TEST_CASE("the user's own derivatives are used") {
    auto const T = uniform(0.0, 0.1, 100);
    auto const check = [&](auto const& how) {
        CHECK(distance(end_of(embed(by_hand{}, how).along(T, 1.0, 0.5)), end_of(embed(testing::pendulum, how).along(T, 1.0, 0.5))) < 1e-13);
    };
    check(mid_point);
    check(order_one);
    check(galerkin<2, gauss>);
}

TEST_CASE("a trajectory starts from position and velocity, or from two positions") {
    auto const T = uniform(0.0, 0.05, 10);
    auto const flow = embed(double_pendulum, mid_point);
    vector2 const q(1.0, 0.5), p(0.2, -0.1);
    auto const whole = flow.along(T, q, p);
    auto second = whole.begin();
    ++second;
    auto const a = end_of(flow.along(T, initial_positions<vector2>{q, second->q}));
    CHECK(distance(a, end_of(whole)) < 1e-12);
    vector2 const v = velocity_of(double_pendulum, q, p);
    CHECK(distance(end_of(flow.along(T, initial_velocity<vector2>{q, v})), end_of(whole)) < 1e-13);
}

TEST_CASE("a Newton iteration that fails says where, and with what it ended") {
    auto const cubic = [](auto const& q, auto const& v) { return v * v / 2 + 10 * q * q * q / 3; };
    try {
        end_of(embed(cubic, mid_point).along(uniform(0.0, 1.0, 3), 1.0, 0.0));
        FAIL("y - 1 = 5 ((1 + y)/2)^2 has no real solution");
    } catch (error::no_convergence const& failure) {
        CHECK(dynamic_cast<interrupted<double, double> const&>(failure).last.q == 1.0);
        try {
            std::rethrow_if_nested(failure);
            FAIL("the iterate and its residual are kept");
        } catch (newton_failure<double> const& cause) {
            CHECK(std::isfinite(cause.iterate));
            CHECK(cause.residual != 0);
        }
    }
}

TEST_CASE("a failed step of a vector keeps its components apart") {
    // The first component moves freely, the second has no mid-point step from here.
    auto const L = [](auto const& q, auto const& v) { return v.dot(v) / 2 + 10 * q(1) * q(1) * q(1) / 3; };
    vector2 const q(3, 1), p(0.25, 0);
    auto const stopped = [&](auto const& flow) {
        try {
            end_of(flow.along(uniform(2.0, 1.0, 3), q, p));
            FAIL("there is no such step");
        } catch (error::no_convergence const& failure) {
            CHECK(std::string(failure.what()).find("the step from t = 2 with h = 1 failed: ") == 0);
            auto const& last = dynamic_cast<interrupted<double, vector2> const&>(failure).last;
            CHECK(last == state<double, vector2>{2, q, p});
            try {
                std::rethrow_if_nested(failure);
                FAIL("the iterate and its residual are kept");
            } catch (newton_failure<vector2> const& cause) {
                CHECK(cause.iterate(0) == doctest::Approx(0.25));
                CHECK(std::abs(cause.residual(0)) < 1e-12);
                CHECK(std::abs(cause.residual(1)) > 1e-3);
            }
        }
    };
    stopped(embed(L, mid_point));
    stopped(embed(L, mid_point, compensated));
    // The same from one step on its own, which knows of no trajectory.
    CHECK_THROWS_AS((void)embed(L, mid_point).step(state<double, vector2>{2, q, p}, 1.0), newton_failure<vector2>);
}

TEST_CASE("bad states are refused in one sentence") {
    auto const T = uniform(0.0, 0.1, 10);
    Eigen::VectorXd const three = Eigen::VectorXd::Ones(3), two = Eigen::VectorXd::Ones(2);
    auto const free = [](auto const& q, auto const& v) { return v.dot(v) / 2 - q.dot(q); };
    CHECK_THROWS_WITH_AS((void)embed(free, mid_point).along(T, three, two),
                         "the initial position and momentum have one dimension, and these have 3 and 2", error::mismatch);
    // d2L/dv2 = diag(1, 0), and nothing else holds the second component
    auto const lame = [](auto const& q, auto const& v) { return v(0) * v(0) / 2 - q(0) * q(0); };
    CHECK_THROWS_AS(end_of(embed(lame, mid_point).along(T, vector2(1, 1), vector2(0, 0))), error::singular);
    CHECK_THROWS_AS(end_of(embed(lame, order_one).along(T, vector2(1, 1), vector2(0, 0))), error::singular);
}

} // namespace mechanics_tests
