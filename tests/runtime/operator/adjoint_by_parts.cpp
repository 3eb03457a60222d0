// SPDX-License-Identifier: BSL-1.0
// Integration by parts in exact rationals: <A f, g> = <f, adjoint(A) g> + boundary_form(A, f, g), with nothing vanishing at the ends. The
// three parts are computed in three different ways, so they agree only if all are right.
#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "support/values.hpp"

namespace adjoint_by_parts_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// A value for each point, without pattern.
template <class Scale>
auto arbitrary(Scale const& scale, int seed) {
    return tabulate(function_on(scale, [&scale, seed](auto const& t) {
        auto const i = static_cast<int>(scale.number_of(t));
        return Q((7 * i * i + 5 * seed * i + 3 * seed) % 23 - 9, 1 + (3 * i + seed) % 5);
    }));
}

template <class Base, class Root>
auto all_of(Root const& T) {
    return derived_scale<Root, domain<Base>>(T, {});
}

template <class A, class Root>
void check_by_parts(A const& a, Root const& T) {
    INFO(std::string(A::name().text().view()));
    for (int seed = 1; seed < 4; ++seed) {
        auto const f = arbitrary(all_of<typename A::from>(T), seed);
        auto const g = arbitrary(all_of<typename A::to>(T), seed + 4);
        auto const parts = by_parts(a, f, g);
        CHECK(parts.left == parts.interior + parts.boundary);
    }
}

template <class A, class Root>
void check_by_parts_inside(A const& a, Root const& T) {
    INFO(std::string(A::name().text().view()));
    auto const f = arbitrary(all_of<typename A::from>(T), 2);
    auto const g = arbitrary(all_of<typename A::to>(T), 5);
    auto const one = by_parts(a, restrict_to(f, interior(f.scale())), g);
    CHECK(one.left == one.interior + one.boundary);
    auto const both = by_parts(a, restrict_to(f, without_first(f.scale())), restrict_to(g, without_first(g.scale())));
    CHECK(both.left == both.interior + both.boundary);
}

template <class Root, class... As>
void check_each(Root const& T, As const&... a) {
    (check_by_parts(a, T), ...);
}
template <class Root, class... As>
void check_each_inside(Root const& T, As const&... a) {
    (check_by_parts_inside(a, T), ...);
}

auto const given = time_scale<Q>{Q(0), Q(1), Q(3), Q(7), Q(15, 2), Q(9), Q(37, 4)};

} // namespace

TEST_CASE("the sum on one side is the sum on the other and the end terms") {
    check_each(given, sigma, rho_h, Delta_plus, Delta_minus, Delta_o_plus, extend, on_T, on_half, pi_half, pi_inverse, step_mean,
               antiderivative_h);
    check_each(given, adjoint(antiderivative_h), adjoint(extend), extend_lambda<1, 3>, identity_T, sigma + rho, fraction<2, 3>{} * sigma);
    check_each(uniform(Q(1), Q(1, 3), 4), Delta_h_minus, mean_h_minus, step_mean, Delta_minus * Delta_plus, rho_o);
}

TEST_CASE("also where the weights change inside a composition or a sum") {
    check_each(given, Delta_plus * Delta_plus, sigma + identity_T, on_half * Delta_o_plus * extend, sigma_o * extend,
               identity_T - Delta_minus);
    // from a sum that counts an end point into one that does not: its term joins the end terms
    check_each(given, sigma * identity_T, rho * identity_on<nodes, nabla_weight>{}, sigma * identity_T + rho);
    // b counts in the nabla sum of the first summand and not in the Delta sum of the second, whose values there join the end terms too
    check_each(given, Delta_minus + identity_T);
    check_each(steps_1_2_4(), reweight<nodes, delta_weight, nabla_weight>{}, identity_on<nodes, nabla_weight, delta_weight>{},
               mean_o * extend);
}

TEST_CASE("and where the functions are known on a part of their scales") {
    check_each_inside(given, sigma, Delta_plus, rho_o, extend, on_T, on_half, pi_half, pi_inverse, step_mean);
    check_each_inside(given, Delta_plus * Delta_plus, sigma + identity_T, on_half * Delta_o_plus * extend);
}

TEST_CASE("and where a few steps leave the adjoint no point") {
    check_each(uniform(Q(0), Q(1, 2), 3), Delta_plus * Delta_plus, Delta_plus * Delta_plus * Delta_plus, sigma * Delta_plus + sigma * sigma,
               fraction<2, 3>{} * (Delta_plus * Delta_plus), Delta_plus - Delta_plus * rho * Delta_plus);
    check_each(uniform(Q(0), Q(1, 2), 1), Delta_plus, sigma, Delta_minus, identity_T, on_half * extend);
}

TEST_CASE("the formulas of Cresson-Safi, with the end terms written out") {
    auto const T = steps_1_2_4();
    auto const f = function_on(T, std::vector<Q>{1, 2, 6, -2}), g = function_on(T, std::vector<Q>{3, -1, 5, 4});
    // (9), as corrected: the second integral is the nabla integral
    CHECK(integral(Delta_plus[f] * g, T) == boundary(f * g) - nabla_integral(f * Delta_minus[g], T));
    CHECK(integral(Delta_plus[f] * g, T) == boundary(f * g) - integral(sigma[f] * Delta_plus[g], T));
    CHECK(nabla_integral(Delta_minus[f] * g, T) == boundary(f * g) - integral(f * Delta_plus[g], T));
    // lemma 2, on T_o
    auto const k = extend[f], l = extend[g];
    CHECK(integral(Delta_o_plus[k] * l, circ(T)) == boundary(k * l) - integral(sigma_o[k] * Delta_o_plus[l], circ(T)));
    // lemma 3 with the boundary factor h/2, on a uniform scale: sum over T_half of f_o g is the sum over T of f times the mean of g
    auto const U = uniform(Q(0), Q(1, 3), 3);
    auto const x = function_on(U, std::vector<Q>{1, 2, 6, -2});
    auto const y = function_on(half(U), std::vector<Q>{4, 1, 7});
    Q const h(1, 3);
    CHECK(integral(on_half[extend[x]] * y, half(U)) ==
          weighted_sum<delta_weight>(restrict_to(x, interior(U)) * pi_half[mean_h_minus[y]]) + h / 2 * (x[0] * y[0] + x[3] * y[2]));
    CHECK(boundary_form(on_half * extend, x, y) == h / 2 * (x[0] * y[0] + x[3] * y[2]));
    CHECK(boundary_form(Delta_plus, f, restrict_to(g, without_last(T))) == -2 * 5 - 1 * 3); // f(b) g(rho(b)) - f(a) g(a)
}

TEST_CASE("where the functions vanish at the ends nothing is left but the adjoint") {
    auto const T = time_scale<Q>{Q(0), Q(1), Q(3), Q(7), Q(15, 2)};
    auto const f = function_on(T, std::vector<Q>{0, 2, 6, -2, 0}), g = function_on(T, std::vector<Q>{3, -1, 5, 4, 8});
    CHECK(boundary_form(Delta_plus, f, restrict_to(g, without_last(T))) == 0);
    CHECK(boundary_form(sigma, f, restrict_to(g, without_last(T))) == 0);
    CHECK(boundary_form(on_half * extend, f, function_on(half(T), std::vector<Q>{1, 2, 3, 4})) == 0);
    CHECK(boundary_form(on_half * extend, g, function_on(half(T), std::vector<Q>{1, 2, 3, 4})) != 0);
    auto const parts = by_parts(Delta_plus, f, g);
    CHECK(parts.left == parts.interior);
}

TEST_CASE("curves in the plane integrate by parts with the Euclidean product") {
    auto const T = time_scale<double>{0.0, 1.0, 3.0, 7.0};
    auto const u = function_on(T, [](double t) { return Eigen::Vector2d(t, t * t); });
    auto const v = function_on(T, [](double t) { return Eigen::Vector2d(1 - t, 2.0); });
    auto const parts = by_parts(Delta_plus, u, v);
    CHECK(parts.left == doctest::Approx(parts.interior + parts.boundary).epsilon(1e-14));
    CHECK(parts.left == integral(dot(Delta_plus[u], v), T));
}

} // namespace adjoint_by_parts_tests
