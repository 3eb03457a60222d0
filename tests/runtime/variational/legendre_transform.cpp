// SPDX-License-Identifier: BSL-1.0
// What trajectories do not show: a wrong second derivative, with which Newton's iteration converges all the same and only later, and the
// momentum of embeddings that do not reproduce constants, which does not come from the equation that is solved.
#include <cmath>

#include <doctest/doctest.h>

#include "hilger/hilger.hpp"

namespace legendre_transform_tests {

using namespace hilger;

namespace {

/// All derivatives of the Lagrangian of H at (q, v) against those of L, numbers near 1: what is left is rounding.
template <class H, class L, class V>
void check_transform(H const& h, L const& l, V const& q, V const& v) {
    double const rounding = 32 * epsilon<double>();
    auto const found = expand(lagrangian_of(h), q, v), expected = expand(l, q, v);
    CHECK(magnitude(V(found.by_q - expected.by_q)) <= rounding);
    CHECK(magnitude(V(found.by_v - expected.by_v)) <= rounding);
    CHECK(magnitude(evaluated(found.qq - expected.qq)) <= rounding);
    CHECK(magnitude(evaluated(found.qv - expected.qv)) <= rounding);
    CHECK(magnitude(evaluated(found.vv - expected.vv)) <= rounding);
    CHECK(std::abs(lagrangian_of(h)(q, v) - l(q, v)) <= rounding);
}

} // namespace

TEST_CASE("L_qq = H_qp H_pp^-1 H_pq - H_qq, L_qv = -H_qp H_pp^-1, L_vv = H_pp^-1: numbers") {
    check_transform([](auto const& p, auto const& q) { return (p - q * q) * (p - q * q) / (2 * (1 + q)) + q * q * q; },
                    [](auto const& q, auto const& v) { return (1 + q) * v * v / 2 + q * q * v - q * q * q; }, 1.0 / 3, 0.4);
}

TEST_CASE("and vectors, where the mixed derivatives are not symmetric") {
    auto const H = [](auto const& p, auto const& q) {
        auto const a = p(0) - q(1), b = p(1) - 2 * q(0) * q(1);
        return a * a / (2 * (1 + q(0) * q(0))) + b * b / 2 + q(0) * q(1) * q(1);
    };
    auto const L = [](auto const& q, auto const& v) {
        return (1 + q(0) * q(0)) * v(0) * v(0) / 2 + q(1) * v(0) + v(1) * v(1) / 2 + 2 * q(0) * q(1) * v(1) - q(0) * q(1) * q(1);
    };
    check_transform(H, L, Eigen::Vector2d(1.0 / 3, -0.5), Eigen::Vector2d(0.4, 3.0 / 7));
}

TEST_CASE("of H(t, p, q): L(t, q, v), and the energy of a state is H") {
    auto const H = [](double t, auto const& p, auto const& q) { return p * p / (2 * (1 + t)) + (1 + t) * q * q / 2; };
    auto const L = lagrangian_of(H);
    double const t = 0.5, q = 0.75, v = 1.25;
    CHECK(std::abs(L(t, q, v) - (1.5 * v * v / 2 - 1.5 * q * q / 2)) <= 8 * epsilon<double>());
    for (auto const& x : embed(L, mid_point).along(uniform(0.0, 0.125, 8), 1.0, 0.5))
        CHECK(std::abs(energy(L)(x) - H(x.t, x.p, x.q)) <= 16 * epsilon<double>());
}

TEST_CASE("p_i = -d_1 L_h and p_{i+1} = d_2 L_h, also where the position of a constant is not the constant") {
    constexpr auto stretched =
        make_embedding<step_weight>(fraction<3, 2>{} * mid_point.position, mid_point.velocity, "stretched", inconsistent);
    auto const L = [](auto const& q, auto const& v) { return v * v / 2 + v * q / 3 - q * q / 2; };
    double const h = 0.25;
    state<double, double> const x{0.0, 1.0, 0.5};
    auto const y = embed(L, stretched).step(x, h);
    // L_h(x, y) = h L(a, v) with a = 3/4 (x + y) and v = (y - x) / h, in numbers near 1
    double const a = 0.75 * (x.q + y.q), v = (y.q - x.q) / h, by_q = v / 3 - a, by_v = v + a / 3;
    CHECK(std::abs(x.p - (by_v - h * 0.75 * by_q)) <= 16 / h * epsilon<double>());
    CHECK(std::abs(y.p - (by_v + h * 0.75 * by_q)) <= 16 / h * epsilon<double>());
    CHECK(std::abs(y.p - x.p) > 0.1);
}

TEST_CASE("a Hamiltonian whose velocities are bounded steps as its Lagrangian does, where guesses go beyond them too") {
    auto const H = [](auto const& p, auto const& x) { return sqrt(1 + p * p) + x * x * x * x; };
    auto const L = [](auto const& x, auto const& v) { return -sqrt(1 - v * v) - x * x * x * x; };
    for (double const h : {0.1, 0.05}) {
        auto const T = uniform(0.0, h, static_cast<index_type>(std::lround(10 / h)));
        auto const of_H = record(embed(lagrangian_of(H), mid_point).along(T, 1.0, 3.0)).states.back();
        auto const of_L = record(embed(L, mid_point).along(T, 1.0, 3.0)).states.back();
        CHECK(std::abs(of_H.q - of_L.q) <= 1e-11);
        CHECK(std::abs(of_H.p - of_L.p) <= 1e-10);
    }
    CHECK_THROWS_AS((void)lagrangian_of(H).momentum(0.0, 1.5), error::no_convergence);
}

TEST_CASE("where H has no second derivative at p = 0, or none that is a number, its momenta are those of its velocities all the same") {
    auto const root = [](auto const& p, auto const& x) { return 2 * pow(p, 1.5) / 3 + x * x / 2; }; // v = sqrt(p)
    CHECK(lagrangian_of(root).momentum(0.5, 0.9) == doctest::Approx(0.81).epsilon(4 * epsilon<double>()));
    CHECK(lagrangian_of(root).momentum(0.5, 0.0) == 0);
    auto const is_the_mid_point_rule = [](auto const& H, auto const& velocity) {
        state<double, double> x{0, 0.5, 0.9};
        for (auto const& y : embed(lagrangian_of(H), mid_point).along(uniform(0.0, 0.1, 3), x.q, x.p)) {
            if (y.t == 0) continue;
            CHECK(std::abs(y.q - x.q - 0.1 * velocity((x.p + y.p) / 2)) <= 16 * epsilon<double>());
            CHECK(std::abs(y.p - x.p + 0.1 * (x.q + y.q) / 2) <= 16 * epsilon<double>());
            x = y;
        }
        CHECK(x.t > 0.25);
    };
    is_the_mid_point_rule(root, [](double p) { return std::sqrt(p); });
    is_the_mid_point_rule([](auto const& p, auto const& x) { return p * p * p / 3 + x * x / 2; }, [](double p) { return p * p; });
    is_the_mid_point_rule([](auto const& p, auto const& x) { return p * log(p) - p + x * x / 2; }, [](double p) { return std::log(p); });
    is_the_mid_point_rule([](auto const& p, auto const& x) { return 2 * sqrt(p) + x * x / 2; }, [](double p) { return 1 / std::sqrt(p); });
    auto const of_minus = [](auto const& p, auto const& x) { return p - p * log(-p) + x * x / 2; }; // v = -log(-p)
    CHECK(lagrangian_of(of_minus).momentum(0.5, -std::log(2.0)) == doctest::Approx(-2).epsilon(4 * epsilon<double>()));
    auto const L = [](auto const& x, auto const& v) { return 2 * pow(abs(v), 1.5) / 3 - x * x / 2; }; // p = sqrt|v| sgn v
    CHECK(velocity_of(L, 0.5, 0.9) == doctest::Approx(0.81).epsilon(4 * epsilon<double>()));
    Eigen::VectorXd const rest = Eigen::VectorXd::Zero(5), p = Eigen::VectorXd::Constant(5, 0.9);
    auto const many = [](auto const& x, auto const& v) {
        auto sum = -x.dot(x) / 2;
        for (int k = 0; k < v.size(); ++k) sum = sum + 2 * pow(abs(v(k)), 1.5) / 3;
        return sum;
    };
    CHECK((velocity_of(many, rest, p) - Eigen::VectorXd::Constant(5, 0.81)).norm() <= 16 * epsilon<double>());
}

TEST_CASE("momenta far from 0 and from their velocities are found, and order one steps with them from rest") {
    auto const of_log = [](auto const& p, auto const& x) { return p * log(p) - p + x * x / 2; }; // L = exp(v) - x^2/2
    for (double const v : {-3.0, -1.0, 0.0, 0.5, 4.0})                                           // neither 0 nor v is near a momentum
        CHECK(lagrangian_of(of_log)(0.5, v) == doctest::Approx(std::exp(v) - 0.125).epsilon(16 * epsilon<double>()));
    double q = 0.5, p = 1;
    for (auto const& y : embed(lagrangian_of(of_log), order_one).along(uniform(0.0, 0.1, 3), q, p)) {
        CHECK(std::abs(y.q - q) + std::abs(y.p - p) <= 64 * epsilon<double>());
        p -= 0.1 * q;
        q += 0.1 * std::log(p);
    }
}

TEST_CASE("a Hamiltonian may branch as a Lagrangian may, without std:: before max") {
    auto const H = [](auto const& p, auto const& x) { return p * p / 2 + 5 * max(x, 0.0) * max(x, 0.0) + x * x / 2; };
    auto const L = [](auto const& x, auto const& v) { return v * v / 2 - 5 * max(x, 0.0) * max(x, 0.0) - x * x / 2; };
    auto const T = uniform(0.0, 0.1, 40);
    auto const of_H = record(embed(lagrangian_of(H), mid_point).along(T, 1.0, 0.3)).states.back();
    auto const of_L = record(embed(L, mid_point).along(T, 1.0, 0.3)).states.back();
    CHECK(std::abs(of_H.q - of_L.q) <= 1e-13);
    CHECK(std::abs(of_H.p - of_L.p) <= 1e-13);
}

TEST_CASE("compositions of a Hamiltonian of numbers, and of vectors") {
    auto const H = [](auto const& p, auto const& x) { return p * p / 2 + x * x * x * x / 4; };
    auto const of_vectors = [](auto const& p, auto const& x) { return p.dot(p) / 2 + x(0) * x(0) * x(0) * x(0) / 4 + x(1) * x(1); };
    auto const L = [](auto const& x, auto const& v) { return v * v / 2 - x * x * x * x / 4; };
    auto const T = uniform(0.0, 0.1, 30);
    auto const end = [&](auto const& flow, auto const& q0, auto const& p0) { return record(flow.along(T, q0, p0)).states.back(); };
    auto const of_H = end(stoermer_verlet(lagrangian_of(H)), 1.0, 0.3), of_L = end(stoermer_verlet(L), 1.0, 0.3);
    CHECK(std::abs(of_H.q - of_L.q) <= 1e-14);
    CHECK(std::abs(of_H.p - of_L.p) <= 1e-14);
    auto const composed = [&](auto const& l) { return compose_with_adjoint(blanes_moan<4>, embed(l, order_one)); };
    auto const fourth = end(composed(lagrangian_of(H)), 1.0, 0.3);
    CHECK(std::abs(fourth.q - end(composed(L), 1.0, 0.3).q) <= 1e-14);
    auto const plane = end(stoermer_verlet(lagrangian_of(of_vectors)), Eigen::Vector2d(1, 0.5), Eigen::Vector2d(0.3, 0));
    CHECK(std::abs(plane.q(0) - of_L.q) <= 1e-14);
}

} // namespace legendre_transform_tests
