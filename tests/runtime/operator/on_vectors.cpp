// SPDX-License-Identifier: BSL-1.0
// Every operator on functions with values in R^d, of a fixed dimension and of one known at run time, equals the operator on each component.
// Eigen's expressions refer to their operands: run with the address sanitizer this is also the proof that none outlives them.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <string>

#include "support/values.hpp"

namespace operator_on_vectors_tests {

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
    INFO(std::string(A::name().text().view()));
    auto const scale = all_of<typename A::from>(T);
    auto const u = function_on(scale, [](double t) {
        Vector x(3);
        for (int j = 0; j < 3; ++j) x[j] = component(t, j);
        return x;
    });
    auto const table = tabulate(u);
    auto const Au = a[u];
    auto const At = a[table];
    static_assert(std::same_as<value_of<decltype(Au)>, Vector>, "values are vectors, not expressions");
    for (int j = 0; j < 3; ++j) {
        auto const expected = a[function_on(scale, [j](double t) { return component(t, j); })];
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

template <class Vector, class Root, class... As>
void check_each(Root const& T, As const&... a) {
    (check_componentwise<Vector>(a, T), ...);
}

auto const given = time_scale<double>{0.0, 1.0, 3.0, 7.0, 7.5};

} // namespace

TEST_CASE("the primitives act on each component of a vector") {
    check_each<Eigen::VectorXd>(given, sigma, rho_h, Delta_plus, Delta_h_minus, Delta_o_plus, extend, extend_lambda<1, 4>, on_T, on_half,
                                pi_half, pi_inverse, step_mean, antiderivative_h, adjoint(antiderivative_h), adjoint(on_T), identity_T,
                                reweight<nodes, delta_weight, nabla_weight>{});
}

TEST_CASE("and so does what is made of them") {
    check_each<Eigen::VectorXd>(given, -Delta_plus, 3 * rho, sigma - Delta_plus, mean_o, antiderivative, adjoint(extend),
                                Delta_plus * Delta_plus * Delta_plus, on_half * Delta_o_plus * extend, adjoint(Delta_plus * Delta_plus),
                                adjoint(extend_at(0.25)) * extend_at(0.25));
}

TEST_CASE("vectors of fixed dimension") {
    check_each<Eigen::Vector3d>(uniform(0.0, 0.5, 5), Delta_plus, extend, step_mean, antiderivative_h, adjoint(on_half), mean_h_minus,
                                on_half * Delta_o_plus * extend, Delta_minus * Delta_plus);
}

TEST_CASE("vectors with exact components") {
    using vector = Eigen::Matrix<Q, 2, 1>;
    auto const T = steps_1_2_4();
    auto const u = function_on(T, [](Q const& t) { return vector(t, t * t); });
    CHECK(Delta_plus[u][1] == vector(Q(1), Q(4)));
    CHECK(Delta_minus[Delta_plus[u]][1] == vector(Q(0), Q(3)));
    CHECK(step_mean[on_half[extend[u]]][1] == vector(Q(3, 2), Q(7, 2)));
    CHECK(integral(dot(u, Delta_plus[u]), T) == Q(0) + 2 * (1 + 4) + 4 * (3 + 90));
}

} // namespace operator_on_vectors_tests
