// SPDX-License-Identifier: BSL-1.0
// Every operator on functions with values in R^d, of a fixed dimension and of one known at run time, equals the operator on each component. Eigen's
// expressions refer to their operands: run with the address sanitizer this is also the proof that none outlives them.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <string>

#include "values.hpp"

using namespace hilger;
using namespace hilger::testing;

namespace {

template <class Base, class Root>
auto all_of(Root const& T) {
    return derived_scale<Root, domain<Base>>(T, {});
}

/// Dyadic numbers, so that all of this is exact in double on scales with dyadic points.
double component(double t, int j) { return (j + 1) * t * t - j * t + 0.5 * j; }

template <class Vector, class A, class Root>
void check_componentwise(A const& a, Root const& T) {
    INFO(std::string(A::name().view()));
    auto const scale = all_of<typename A::from>(T);
    auto const u = function(scale, [](double t) {
        Vector x(3);
        for (int j = 0; j < 3; ++j) x[j] = component(t, j);
        return x;
    });
    auto const table = tabulate(u);
    auto const Au = a[u];
    auto const At = a[table];
    static_assert(std::same_as<value_of<decltype(Au)>, Vector>, "values are vectors, not expressions");
    for (int j = 0; j < 3; ++j) {
        auto const expected = a[function(scale, [j](double t) { return component(t, j); })];
        REQUIRE(Au.size() == expected.size());
        for (auto i = expected.first(); i <= expected.last(); ++i) {
            CHECK(Au[i][j] == doctest::Approx(expected[i]).epsilon(1e-14));
            CHECK(At[i][j] == Au[i][j]);
        }
    }
    // and in expressions, whose operands are gone when they are evaluated
    auto const expression = [&] { return 2 * a[u + u] - a[table] / 2 + (-a[u]); }();
    for (auto i = Au.first(); i <= Au.last(); ++i) CHECK((expression[i] - 2.5 * Au[i]).norm() < 1e-12);
}

template <class Vector, class Root>
void check_all(Root const& T) {
    auto const check = [&T](auto const&... a) { (check_componentwise<Vector>(a, T), ...); };
    check(sigma, rho, sigma_h, rho_h, sigma_o, rho_o, identity, identity_h, identity_o);
    check(Delta_plus, Delta_minus, Delta_h_plus, Delta_h_minus, Delta_o_plus, Delta_o_minus);
    check(extend, on_T, on_half, pi, pi_inverse, step_mean, mean_o, mean_h_minus, mean_h_plus, extend_lambda<1, 4>);
    check(antiderivative, antiderivative_nabla, antiderivative_h, adjoint(antiderivative_h), adjoint(extend), adjoint(on_T), adjoint(on_half));
    check(fraction<1, 2>{} * sigma, -Delta_plus, 3 * rho, sigma + rho, sigma - Delta_plus);
    check(Delta_minus * Delta_plus, Delta_plus * Delta_plus * Delta_plus, sigma * sigma, on_half * Delta_o_plus * extend, mean_o * extend);
    check(reweight<nodes, delta, nabla>{}, adjoint(Delta_plus * Delta_plus), step_mean * on_half * sigma_o * extend);
    check(extend_at(0.25), Delta_plus_on<joined<run_time<double>>> * extend_at(0.25), adjoint(extend_at(0.25)) * extend_at(0.25));
}

} // namespace

TEST_CASE("operators act on each component of a vector") {
    SUBCASE("of fixed dimension, on a uniform scale") { check_all<Eigen::Vector3d>(uniform(0.0, 0.5, 5)); }
    SUBCASE("of fixed dimension, on given points") { check_all<Eigen::Vector3d>(time_scale<double>{0.0, 1.0, 3.0, 7.0, 7.5}); }
    SUBCASE("of run-time dimension, on a uniform scale") { check_all<Eigen::VectorXd>(uniform(0.0, 0.5, 5)); }
    SUBCASE("of run-time dimension, on given points") { check_all<Eigen::VectorXd>(time_scale<double>{0.0, 1.0, 3.0, 7.0, 7.5}); }
}

TEST_CASE("vectors with exact components") {
    using vector = Eigen::Matrix<Q, 2, 1>;
    auto const T = steps_1_2_4();
    auto const u = function(T, [](Q const& t) { return vector(t, t * t); });
    CHECK(Delta_plus[u][1] == vector(Q(1), Q(4)));
    CHECK(Delta_minus[Delta_plus[u]][1] == vector(Q(0), Q(3)));
    CHECK(step_mean[on_half[extend[u]]][1] == vector(Q(3, 2), Q(7, 2)));
    CHECK(integral(dot(u, Delta_plus[u]), T) == Q(0) + 2 * (1 + 4) + 4 * (3 + 90));
}
