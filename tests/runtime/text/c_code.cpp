// SPDX-License-Identifier: BSL-1.0
// Generated C, compiled by cc with every warning an error, loaded, and run against the flow it is generated from.
#include "compiled_c.hpp"

namespace c_code_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

using vector8 = Eigen::Matrix<double, 8, 1>;

constexpr auto pendulum = [](auto const& x, auto const& v) { return v * v / 2 - (1 - cos(x)); };
constexpr auto kepler = [](auto const& q, auto const& v) { return v.dot(v) / 2 + 1 / q.norm(); };
constexpr auto double_pendulum = [](auto const& q, auto const& v) {
    return v(0) * v(0) + v(1) * v(1) / 2 + v(0) * v(1) * cos(q(0) - q(1)) + 2 * cos(q(0)) + cos(q(1));
};
/// A chain of eight, each pushing the next: every pair is coupled through the mass too.
constexpr auto chain = [](auto const& q, auto const& v) {
    auto L = v.dot(v) / 2 + v.sum() * v.sum() * exp(-q.dot(q)) / 16;
    for (int k = 0; k + 1 < 8; ++k) L -= exp(q(k) - q(k + 1));
    return L;
};
/// The second is of the size 1e-8, and nonlinear there.
constexpr auto one_large_one_small = [](auto const& q, auto const& v) {
    auto const y = 1e8 * q(1);
    return v(0) * v(0) / 2 + v(1) * v(1) * (1 + y * y) / 2 - q(0) * q(0) * q(0) * q(0) / 4 - q(1) * q(1) * (2 + y * y) / 4;
};
constexpr auto massless = [](auto const& x, auto const& v) { return x * v; };
constexpr auto rigid = [](auto const& q, auto const& v) { return (v(0) + v(1)) * (v(0) + v(1)) / 2 + q(0) * q(1); };
constexpr auto cubic = [](auto const& x, auto const& v) { return v * v / 2 + 10 * x * x * x / 3; };
constexpr auto driven = [](auto const& t, auto const& x, auto const& v) {
    return v * v * (2 + cos(t)) / 2 - x * x * x * x / 4 + x * sin(t);
};
constexpr auto friction = [](auto const& x, auto const& v) { return -v * (1 + x * x) / 10; };
constexpr auto one_sided = [](auto const& x, auto const& v) {
    return v * v / 2 - 4 * x * max(x, 0.0) - abs(x) * x * x / 3 - erf(x) * x / 8 - hypot(x, 3.0) - cbrt(2 + x * x) - log1p(x * x) -
           pow(2.0, -x * x);
};
constexpr auto free_particle = [](auto const&, auto const& v) { return v * v / 2; };
using driven_with_friction = problem<std::remove_const_t<decltype(driven)>, std::remove_const_t<decltype(friction)>>;

std::string all_the_code() {
    return c_code(embed(pendulum, mid_point), "pendulum") + c_code(embed(pendulum, order_one), "pendulum_right") +
           c_code(embed(pendulum, order_one_left), "pendulum_left") + c_code<vector>(embed(kepler, mid_point), "kepler") +
           c_code<vector>(embed(kepler, order_one), "kepler_right") + c_code<vector>(embed(double_pendulum, mid_point), "double_pendulum") +
           c_code<vector>(embed(double_pendulum, order_one), "double_pendulum_right") +
           c_code<vector>(embed(double_pendulum, order_one_left), "double_pendulum_left") +
           c_code<vector>(embed(double_pendulum, theta<1, 3>), "double_pendulum_third") +
           c_code<vector8>(embed(chain, mid_point), "chain") + c_code(embed(massless, mid_point), "massless") +
           c_code<vector>(embed(rigid, mid_point), "rigid") + c_code(embed(cubic, mid_point), "cubic") +
           c_code(embed(driven_with_friction{driven, friction}, theta<1, 3>), "driven") + c_code(embed(one_sided, mid_point), "one_sided") +
           c_code(embed(one_sided, order_one_left), "one_sided_left") + c_code(embed(free_particle, mid_point), "free_particle") +
           c_code<vector>(embed(one_large_one_small, mid_point), "one_large_one_small") + detail::c_solve("three", 3) +
           "int three(double K[3][3], double x[3]);\n" + "int three(double K[3][3], double x[3]) { return three_solve(K, x); }\n";
}

compiled const& generated() {
    static compiled const c(all_the_code());
    return c;
}
template <class V, class Flow>
double distance_after_1000_steps(std::string const& name, Flow const& flow, V const& q, V const& p, double h) {
    return testing::distance_after_1000_steps(generated(), name, flow, q, p, h);
}

} // namespace

TEST_CASE("1000 steps of the C are those of the flow") {
    if (not there_is_a_c_compiler()) return;
    double const bound = 32; // sqrt(1000)
    CHECK(distance_after_1000_steps("pendulum", embed(pendulum, mid_point), 1.0, 0.5, 0.05) < bound);
    CHECK(distance_after_1000_steps("pendulum_right", embed(pendulum, order_one), 1.0, 0.5, 0.05) < bound);
    CHECK(distance_after_1000_steps("pendulum_left", embed(pendulum, order_one_left), 1.0, 0.5, 0.05) < bound);
    vector const q(0.4, 0), p(0, 2), a(0.5, -0.25), b(0.125, 0.25); // e = 0.6; small swings, which are not chaotic
    CHECK(distance_after_1000_steps("kepler", embed(kepler, mid_point), q, p, 0.02) < bound);
    CHECK(distance_after_1000_steps("kepler_right", embed(kepler, order_one), q, p, 0.02) < bound);
    CHECK(distance_after_1000_steps("double_pendulum", embed(double_pendulum, mid_point), a, b, 0.05) < bound);
    CHECK(distance_after_1000_steps("double_pendulum_right", embed(double_pendulum, order_one), a, b, 0.05) < bound);
    CHECK(distance_after_1000_steps("double_pendulum_left", embed(double_pendulum, order_one_left), a, b, 0.05) < bound);
    CHECK(distance_after_1000_steps("double_pendulum_third", embed(double_pendulum, theta<1, 3>), a, b, 0.05) < bound);
    CHECK(distance_after_1000_steps("one_sided", embed(one_sided, mid_point), 1.0, 0.5, 0.2) < bound);
    CHECK(distance_after_1000_steps("one_sided_left", embed(one_sided, order_one_left), 1.0, 0.5, 0.05) < bound);
    CHECK(distance_after_1000_steps("free_particle", embed(free_particle, mid_point), 1.0, 0.5, 0.05) < bound);
}

TEST_CASE("small components beside large ones keep their digits in C") {
    if (not there_is_a_c_compiler()) return;
    auto const flow = embed(one_large_one_small, mid_point);
    auto* const step = generated().get<step_of>("one_large_one_small_step");
    vector q(1, 0.5e-8), p(0.25, 1e-8), v(0.25, 1e-8);
    double worst = 0;
    for (auto const& at : path_of(flow, q, p, 0.1, 100)) {
        worst = std::max(worst, std::abs(q(1) - at.q(1)));
        REQUIRE(step(0.1, data(q), data(p), data(v)) == 0);
    }
    CHECK(worst <= 16 * 100 * epsilon<double>() * 1e-8);
}

TEST_CASE("L, dL/dv and the discrete Euler-Lagrange equation in C are those of the library") {
    if (not there_is_a_c_compiler()) return;
    auto const flow = embed(double_pendulum, theta<1, 3>);
    std::string const name = "double_pendulum_third";
    vector const q0(0.5, -0.25), q1(0.53, -0.2), q2(0.51, -0.17), v(0.75, -1.5);
    vector p, r;
    double const h = 0.05, rounding = 64 * epsilon<double>() / h; // differences of positions are divided by h
    CHECK(generated().get<lagrangian_in_c>(name + "_lagrangian")(q0.data(), v.data()) ==
          doctest::Approx(double_pendulum(q0, v)).epsilon(1e-15));
    generated().get<momentum_of_>(name + "_momentum")(q0.data(), v.data(), p.data());
    CHECK(extent(vector(p - flow.momentum(0.0, q0, v))) <= 4 * epsilon<double>());

    generated().get<residual_of>(name + "_residual")(h, q0.data(), q1.data(), q2.data(), r.data());
    auto const end = flow.step(state<double, vector>{0, q0, flow.momentum_between(0.0, q0, q1, h)}, h);
    CHECK(extent((end.q - q1)) <= rounding);
    CHECK(extent((r - (end.p - flow.momentum_between(h, q1, q2, h)))) <= rounding);
    CHECK(extent(r) > 0.1); // these three are no solution

    auto const path = path_of(flow, q0, vector(0.125, 0.25), h, 2);
    generated().get<residual_of>(name + "_residual")(h, path[0].q.data(), path[1].q.data(), path[2].q.data(), r.data());
    CHECK(extent(r) <= rounding);
}

TEST_CASE("more degrees of freedom: the steps of the C solve the C's own equation") {
    if (not there_is_a_c_compiler()) return;
    auto* const step = generated().get<step_of>("chain_step");
    double const h = 0.05;
    vector8 q = vector8::LinSpaced(-0.5, 0.75), p = vector8::LinSpaced(1, -1), v = p, r;
    std::vector<vector8> path;
    for (int k = 0; k < 20; ++k) {
        path.push_back(q);
        REQUIRE(step(h, q.data(), p.data(), v.data()) == 0);
    }
    for (std::size_t k = 0; k + 2 < path.size(); ++k) {
        generated().get<residual_of>("chain_residual")(h, path[k].data(), path[k + 1].data(), path[k + 2].data(), r.data());
        CHECK(extent(r) <= 16 * epsilon<double>() / h);
    }
    CHECK(extent(path[19] - path[0]) > 0.1);
}

TEST_CASE("the elimination in C exchanges rows, and sees what is singular") {
    if (not there_is_a_c_compiler()) return;
    auto* const solve_three = generated().get<int(double(*)[3], double*)>("three");
    double K[3][3] = {{0, 2, 1}, {1, 0, 0}, {4, 1, 0}}, x[3] = {7, 1, 6};
    CHECK(solve_three(K, x) == 1);
    CHECK(x[0] == 1);
    CHECK(x[1] == 2);
    CHECK(x[2] == 3);
    double flat[3][3] = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}, y[3] = {1, 1, 1}; // determinant 0
    CHECK(solve_three(flat, y) == 0);
}

TEST_CASE("time and forces are passed on") {
    if (not there_is_a_c_compiler()) return;
    auto const flow = embed(driven_with_friction{driven, friction}, theta<1, 3>);
    auto* const step = generated().get<int(double, double, double*, double*, double*)>("driven_step");
    auto* const residual = generated().get<void(double, double, double const*, double const*, double const*, double*)>("driven_residual");
    double q = 1, p = 0.5, v = 0, h = 0.05, worst = 0;
    std::vector<double> ts, qs;
    for (auto const& at : flow.along(uniform(1.0, h, 100), q, p)) {
        worst = std::max({worst, std::abs(at.q - q), std::abs(at.p - p)});
        ts.push_back(at.t);
        qs.push_back(at.q);
        REQUIRE(step(at.t, h, &q, &p, &v) == 0);
    }
    CHECK(worst <= 100 * epsilon<double>());
    for (std::size_t i = 0; i + 2 < qs.size(); ++i) {
        double r = 1;
        residual(ts[i], h, &qs[i], &qs[i + 1], &qs[i + 2], &r);
        CHECK(std::abs(r) <= 16 * epsilon<double>() / h);
    }
}

TEST_CASE("a step that cannot be made says why, and leaves the state as it was") {
    if (not there_is_a_c_compiler()) return;
    auto const stops = [](std::string const& name, int code, auto q, auto p, auto v, double h) {
        auto const q0 = q, p0 = p, v0 = v;
        CHECK(generated().get<step_of>(name + "_step")(h, data(q), data(p), data(v)) == code);
        CHECK(q == q0);
        CHECK(v == v0);
        CHECK((p == p0 or not is_finite(p)));
    };
    constexpr int singular = 1, no_convergence = 2, not_finite = 3;
    stops("massless", singular, 1.0, 0.0, 0.5, 0.1);
    stops("rigid", singular, vector(0, 0), vector(1, 0), vector(0, 0), 0.0);
    stops("cubic", no_convergence, 1.0, 0.0, 0.0, 1.0); // y - 1 = 5 ((1 + y)/2)^2 has no real solution
    stops("pendulum", not_finite, 1.0, std::nan(""), 0.0, 0.1);
    stops("kepler", not_finite, vector(0, 0), vector(0, 0), vector(0, 0), 0.1);
}

TEST_CASE("the C says what it is") {
    std::string const code = c_code(embed(pendulum, mid_point), "pendulum");
    auto const says = [&](char const* what) { return code.find(what) != std::string::npos; };
    CHECK(code.find("/* pendulum: L(q, v) = v²/2 − (1 − cos(q))\n * under the embedding \"mid-point\".") == 0);
    CHECK(says("[∂L/∂q(⋆)]½,₋ − Δ½,₋[∂L/∂v(⋆)] = 0"));
    CHECK(says("Δ½,₋[p∘] = [−∂H/∂q(p∘, q∘)]½,₋"));
    CHECK(says("position 0.5·(q_i + q_{i+1}), velocity (q_{i+1} − q_i)/h"));
    CHECK(says("        const double x = 0.5 * (q0[0] + q1[0]);\n        const double v = (q1[0] - q0[0]) / h;\n"
               "        r[0] = v + -0.5 * (sin(x) * h);\n"));
    CHECK(says("        r[0] += -0.5 * (sin(x) * h) - v;\n"));
    CHECK(says("return v[0] * v[0] / 2.0 - (1.0 - cos(q[0]));\n"));
    CHECK_THROWS_WITH_AS((void)c_code(embed(pendulum, mid_point), "2 pendulums"),
                         "C names are letters, digits and _, and this one is \"2 pendulums\"", error::invalid_parameter);
}

} // namespace c_code_tests
