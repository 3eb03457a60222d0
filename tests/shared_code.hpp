// SPDX-License-Identifier: BSL-1.0
// What most files of the tests and of the program instantiate alike: none of this runs. clang instantiates it where the precompiled header
// is made, and compiles it once (see precompiled.cmake). A line is worth its place where it saves more functions than it makes.
#pragma once

#include "../src/compiled_once.hpp"

#include <iostream>
#include <vector>

#include <Eigen/Dense>
#include <doctest/doctest.h>

#include "support/orders.hpp"
#include "support/systems.hpp"
#include "support/values.hpp"

namespace hilger::testing::shared_code {

template <class Path>
void walk(Path const& path) {
    auto i = path.begin();
    auto x = *i;
    for (; not(i == std::default_sentinel); ++i) x = *i;
    CHECK(x.q == x.p);
    std::vector<decltype(x.q)> positions;
    for (auto const& y : path) positions.push_back(y.q);
}

template <class V, class L, class E>
void steps(L const& lagrangian, E const& how) {
    using S = hilger::scalar_of<V>;
    V q{}, p{};
    auto const T = uniform(S(0), S(1), 100);
    auto const flow = embed(lagrangian, how);
    walk(flow.along(T, q, p));
    if constexpr (std::same_as<V, double>) {
        CHECK(symplecticity_error(jacobian_of_step(flow, state<S, V>{0, q, p}, S(1))) < 1);
        CHECK(drift_along(flow.along(T, q, p), energy(lagrangian)).largest < 1);
    }
}
template <class V, class L>
void schemes(L const& lagrangian) {
    steps<V>(lagrangian, order_one);
    steps<V>(lagrangian, mid_point);
    steps<V>(lagrangian, galerkin<2, gauss>);
}

template <class Scale, class V>
void operators(Scale const& T, V const& a) {
    auto const f = function_on(T, std::vector<V>{a, a});
    CHECK(values(f) == values(sigma[f]));
    CHECK(values(rho[f]) == values(Delta_plus[f]));
    CHECK(values(Delta_minus[f]) == values(pi_inverse[f]));
    CHECK(values((Delta_minus * Delta_plus)[f]) == values((sigma * sigma)[f]));
    CHECK(values((Delta_plus * Delta_minus)[f]) == values((rho * rho)[f]));
    CHECK(values(extend[f]) == values((pi_inverse * Delta_plus)[f]));
    CHECK(values(extend_lambda<1, 3>[f]) == values((pi_lambda_inverse<1, 3> * Delta_plus)[f]));
    CHECK(values((fraction<2, 3>{} * sigma + rho)[f]) == points(T));
    CHECK(values(f + 2 * f) == values(f - f));
    CHECK(points(half(T)) == "");
}

/// What expressions of vectors tests and engines form.
template <class V, class S = hilger::scalar_of<V>>
void vectors(S const& h) {
    V a{}, b{};
    V x = a + b, y = a - b;
    x = h * a + b;
    x += h * a;
    x = a + h * b;
    x -= a;
    x = (a + b) / h;
    x = (a - b) / h;
    x = a * h;
    x = -a;
    x *= h;
    x = a / h;
    S s = x.dot(y) + x.squaredNorm() + x(0) + x[0] + x.sum();
    s += x.cwiseAbs().maxCoeff();
    CHECK(a == b);
    CHECK(s < h);
    std::vector<V> many{a, b};
    many.push_back(x);
    many.emplace_back(std::move(y));
    std::vector<V> const others = many;
    CHECK(others == many);
    std::optional<V> maybe = a;
    maybe = b;
    if constexpr (std::same_as<S, double>) {
        CHECK((a - b).norm() < h * a.norm());
        CHECK((a - b).cwiseAbs().maxCoeff() < h);
        std::cout << a;
    }
}

template <class L>
void equations(L const& lagrangian) {
    constexpr unknown q;
    auto const T = uniform(0.0, 1.0, 100);
    auto const equation_of = [&](auto const& action) {
        auto const EL = variation(action);
        std::cout << EL << latex(EL);
        CHECK(EL.residual(solve(EL, T, {.q0 = 1.0, .v0 = 1.0}))[1] == 1.0);
    };
    equation_of(integral(lagrangian(q, Delta_plus[q]), T));
    equation_of(nabla_integral(lagrangian(q, Delta_minus[q]), T));
    equation_of(integral(lagrangian((q + sigma[q]) / 2, Delta_plus[q]), T));
}

inline void all() {
    auto const in_space = [](auto const& q, auto const& v) { return (v.dot(v) - q.dot(q)) / 2 + q.dot(q) * v.dot(v); };
    schemes<double>(pendulum);
    schemes<double>(bead);
    schemes<Q>(oscillator);
    schemes<float50>(bead);
    steps<float50>(pendulum, order_one);
    schemes<Eigen::Vector2d>(in_space);
    schemes<Eigen::Vector3d>(in_space);
    schemes<Eigen::VectorXd>(in_space);
    steps<Eigen::Vector2d>(kepler, order_one);
    steps<Eigen::Vector3d>(kepler, order_one);
    steps<Eigen::VectorXd>(kepler, order_one);
    steps<Eigen::Matrix<double, 6, 1>>(kepler, order_one);
    steps<Eigen::Matrix<double, 6, 1>>(in_space, mid_point);
    steps<Eigen::Matrix<float50, 2, 1>>(kepler, order_one);
    steps<Eigen::Matrix<float50, 2, 1>>(in_space, mid_point);
    walk(stoermer_verlet(pendulum).along(uniform(0.0, 1.0, 100), 1.0, 1.0));
    auto const with_memory = [](auto const& damped, auto const& x) { walk(embed(damped, mid_point).along(uniform(0.0, 1.0, 100), x, x)); };
    with_memory(with_fractional_damping(pendulum, 0.1, fraction<1, 2>{}), 1.0);
    with_memory(with_fractional_damping(pendulum, 0.1, 0.5, exponentials{1e-10, 1000}), 1.0);
    with_memory(with_fractional_damping(kepler, Eigen::Vector2d(), fraction<1, 2>{}), Eigen::Vector2d());
    with_memory(with_fractional_damping(kepler, Eigen::VectorXd(), fraction<1, 2>{}), Eigen::VectorXd());

    vectors<Eigen::VectorXd>(1.0);
    vectors<Eigen::Vector2d>(1.0);
    vectors<Eigen::Vector3d>(1.0);
    vectors<Eigen::Matrix<double, 6, 1>>(1.0);
    vectors<Eigen::Matrix<Q, -1, 1>>(Q(1));
    vectors<Eigen::Matrix<Q, 2, 1>>(Q(1));

    operators(steps_1_2_4(), Q(3));
    operators(uniform(0.0, 0.5, 2), 1.0);
    operators(uniform(Q(0), Q(2), 2), Q(1));
    operators(time_scale<double>{0.0, 1.0}, 1.0);
    equations(oscillator);

    CHECK(printed(float50(3)) == printed(3.0));
    CHECK(printed(Eigen::Vector2d()) == printed(Eigen::VectorXd()));
    CHECK(Q(2, 3) == Q(3));
    CHECK(Q(2, 3) < 3);
    CHECK(1.0 < doctest::Approx(3));
    CHECK(float50(1) < float50(2));
    CHECK(float50(1) < 2);
    CHECK(sqrt(sin(float50(1)) + cos(float50(1)) + exp(float50(1)) + log(float50(1)) + pow(float50(2), float50(3))) == 0);
}

} // namespace hilger::testing::shared_code
