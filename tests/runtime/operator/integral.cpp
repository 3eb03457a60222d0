// SPDX-License-Identifier: BSL-1.0
// Antiderivatives, integrals over a whole scale and between two points in either order, and weighted sums, against sums done by hand on a
// scale with the steps 1, 2, 4.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>

#include "support/values.hpp"

namespace operator_integral_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {
auto const T = steps_1_2_4();
auto const f = function_on(T, std::vector<Q>{1, 2, 6, -2});
auto const g = function_on(half(T), std::vector<Q>{4, 1, 7});
auto const k = function_on(circ(T), std::vector<Q>{0, 3, 1, 5, -1, 2, 4});
} // namespace

TEST_CASE("antiderivatives start at 0 in a and gain a step times a value at each point") {
    CHECK(values(antiderivative[f]) == "T: 0, 1, 5, 29");       // 1*1, + 2*2, + 4*6
    CHECK(values(antiderivative_nabla[f]) == "T: 0, 2, 14, 6"); // 1*2, + 2*6, - 4*2
    CHECK(values(antiderivative_h[g]) == "T: 0, 4, 6, 34");     // 1*4, + 2*1, + 4*7
    CHECK(values(antiderivative_at<fraction<1, 3>>{}[function_on(at_lambda<1, 3>(T), std::vector<Q>{4, 1, 7})]) == "T: 0, 4, 6, 34");
    CHECK(values(antiderivative[Delta_plus[f]]) == "T: 0, 1, 5, -3"); // f - f(a)
    CHECK(values(antiderivative_nabla[Delta_minus[f]]) == "T: 0, 1, 5, -3");
    CHECK(values(Delta_plus[antiderivative[f]]) == "T^{+}: 1, 2, 6");
    CHECK(values(Delta_minus[antiderivative_nabla[f]]) == "T^{-}: 2, 6, -2");
    CHECK(values(antiderivative[Delta_plus[Delta_plus[f]]]) == "T^{+}: 0, 1, -3"); // as far as the integrand reaches
    CHECK(values(antiderivative_h[mean_h_plus[g]]) == "T^{+}: 0, 5/2, 21/2");
}

TEST_CASE("a table of an antiderivative has its values to the last bit, and takes the values of f once") {
    CHECK(values(tabulate(antiderivative[f])) == values(antiderivative[f]));
    CHECK(values(tabulate(antiderivative_nabla[f])) == values(antiderivative_nabla[f]));
    CHECK(values(tabulate(antiderivative_h[mean_h_plus[g]])) == values(antiderivative_h[mean_h_plus[g]]));
    CHECK(values(tabulate(antiderivative[Delta_plus[Delta_plus[f]]])) == values(antiderivative[Delta_plus[Delta_plus[f]]]));
    int taken = 0;
    auto const counted = function_on(uniform(0.0, 0.1, 1000), [&taken](double t) {
        ++taken;
        return 1 / (3 + t);
    });
    auto const table = tabulate(antiderivative[counted]);
    CHECK(taken <= 1001); // one of them for the zero of its kind
    bool same = true;
    for (index_type i = 0; i <= 1000; ++i) same = same and table[i] == antiderivative[counted][i];
    CHECK(same);
    CHECK(tabulate(antiderivative[function_on(uniform(0.0, 1.0, 3), [](double t) { return t; })])[3] == 3);
}

TEST_CASE("the tail integral sums what comes after a mid-point") {
    CHECK(values(adjoint(antiderivative_h)[f]) == "T_half: 6, 4, -8");                                // 1*2 + 2*6 - 4*2, ...
    CHECK(values(adjoint(antiderivative_h)[restrict_to(f, without_first(T))]) == "T_half: 6, 4, -8"); // f(a) does not count
    CHECK(values(adjoint(antiderivative_h)[restrict_to(f, without_last(T))]) == "T_half: 14, 12, 0"); // nor does what is not there
    CHECK(values(adjoint(antiderivative_h)[restrict_to(f, interior(T))]) == "T_half: 14, 12, 0");
}

TEST_CASE("integrals over a whole scale") {
    CHECK(integral(f, T) == 29);
    CHECK(integral(restrict_to(f, without_last(T)), T) == 29); // the value at b does not count
    CHECK(nabla_integral(f, T) == 6);
    CHECK(nabla_integral(restrict_to(f, without_first(T)), T) == 6);
    CHECK(integral(g, half(T)) == 34);
    CHECK(integral(k, half(T)) == 21); // 1*3 + 2*5 + 4*2: only the values at the mid-points count
    CHECK(integral(k, circ(T)) == Q(19, 2));
    CHECK(nabla_integral(k, circ(T)) == 18);
    CHECK(integral(function_on(at_lambda<1, 3>(T), std::vector<Q>{4, 1, 7}), at_lambda<1, 3>(T)) == 34);
    CHECK(integral(extend_lambda<1, 3>[f], at_lambda<1, 3>(T)) == Q(64, 3)); // 4/3 + 2 (10/3) + 4 (10/3)
    CHECK(integral(extend_at(Q(1, 3))[f], at_lambda(T, Q(1, 3))) == Q(64, 3));
    CHECK(integral(function_on(at_lambda<0, 1>(T), std::vector<Q>{1, 2, 6}), at_lambda<0, 1>(T)) == 29);
    CHECK(integral(Delta_plus[f], T) == boundary(f));
    CHECK(nabla_integral(Delta_minus[f], T) == boundary(f));
    CHECK(integral(on_half[Delta_o_plus[extend[f]]], half(T)) == boundary(f));
    CHECK(integral(Delta_o_plus[k], circ(T)) == boundary(k));
}

TEST_CASE("the integral of 1 is the length, on every kind of scale") {
    auto const one = [](Q const&) { return 1; };
    auto const check = [&](auto const& S) {
        Q const length = S.max() - S.min();
        CHECK(integral(function_on(S, one), S) == length);
        CHECK(nabla_integral(function_on(S, one), S) == length);
        CHECK(integral(function_on(half(S), one), half(S)) == length);
        CHECK(integral(function_on(circ(S), one), half(S)) == length);
        CHECK(integral(function_on(circ(S), one), circ(S)) == length);
        CHECK(nabla_integral(function_on(circ<2, 7>(S), one), circ<2, 7>(S)) == length);
        CHECK(integral(function_on(at_lambda(S, Q(2, 7)), one), at_lambda(S, Q(2, 7))) == length);
        CHECK(integral(function_on(S, one), S.min(), S.max()) == length);
    };
    check(T), check(uniform(Q(-1), Q(1, 3), 7)), check(uniform(Q(0), Q(1), 1)), check(powers(Q(2), -3, 3)),
        check(uniform(Q(0), Q(1, 7), 2));
}

TEST_CASE("integrals between two points, in either order") {
    CHECK(integral(f, 1, 7) == 28);
    CHECK(integral(f, 7, 1) == -28);
    CHECK(integral(f, 0, 1) == 1);
    CHECK(integral(f, 3, 3) == 0);
    CHECK(integral(f, 7, 7) == 0); // also at b, where f mu is nothing
    CHECK(nabla_integral(f, 1, 7) == 4);
    CHECK(nabla_integral(f, 7, 1) == -4);
    CHECK(nabla_integral(f, 0, 1) == 2);
    CHECK(nabla_integral(f, 0, 0) == 0);
    CHECK(integral(g, 0, 3) == 6); // bounds are points of T, the values are at the mid-points
    CHECK(integral(g, 3, 0) == -6);
    CHECK(integral(g, 7, 0) == -34);
    CHECK(integral(k, Q(1, 2), 2) == Q(5, 2)); // on T_o the bounds are points of T_o
    CHECK(integral(k, 2, Q(1, 2)) == Q(-5, 2));
    CHECK(nabla_integral(k, Q(1, 2), 2) == Q(11, 2));
    CHECK(integral(Delta_plus[f], 1, 7) == f(7) - f(1));
    CHECK(nabla_integral(Delta_minus[f], 7, 1) == f(1) - f(7));
    for (auto const& r : T)
        for (auto const& s : T)
            for (auto const& t : T) CHECK(integral(f, r, s) + integral(f, s, t) == integral(f, r, t));
}

TEST_CASE("bounds that are no points are errors") {
    CHECK_THROWS_WITH_AS((void)integral(f, 0, 2), "2 is not a point of T = {0, 1, 3, 7} (4 points)", error::outside_domain);
    CHECK_THROWS_AS((void)integral(f, -1, 3), error::outside_domain);
    CHECK_THROWS_AS((void)nabla_integral(f, 0, 8), error::outside_domain);
    CHECK_THROWS_AS((void)integral(g, 0, 2), error::outside_domain); // a mid-point is no bound
    CHECK_THROWS_AS((void)integral(k, 0, Q(1, 4)), error::outside_domain);
}

TEST_CASE("a function is integrated over its own scale only") {
    auto const other = time_scale<Q>{Q(0), Q(1), Q(3), Q(8)};
    CHECK_THROWS_WITH_AS(
        (void)integral(f, other),
        "a function is used on its own scale: it lives on T = {0, 1, 3, 7} (4 points), and is needed on T = {0, 1, 3, 8} (4 points)",
        error::mismatch);
    CHECK_THROWS_AS((void)integral(g, half(other)), error::mismatch);
    CHECK_THROWS_AS((void)nabla_integral(f, other), error::mismatch);
    CHECK(integral(f, steps_1_2_4()) == 29); // the same points given twice are the same scale
}

TEST_CASE("weighted sums: Delta, nabla, mean, steps and split weights") {
    CHECK(weighted_sum<delta_weight>(f) == 29);
    CHECK(weighted_sum<nabla_weight>(f) == 6);
    CHECK(weighted_sum<mean_weight<fraction<1, 2>>>(f) == Q(35, 2)); // the trapezoid rule
    CHECK(weighted_sum<mean_weight<fraction<1, 3>>>(f) == Q(64, 3)); // (2/3) 29 + (1/3) 6
    CHECK(weighted_sum<step_weight>(g) == 34);
    CHECK(weighted_sum<split_weight<mean_weight<fraction<1, 2>>>>(k) == Q(55, 4)); // half of 13/2 on T and of 21 on T_half
    CHECK(weighted_sum<delta_weight>(restrict_to(f, interior(T))) == 28);
    CHECK(weighted_sum<delta_weight>(Delta_plus[Delta_plus[function_on(uniform(Q(0), Q(1), 1), std::vector<Q>{1, 2})]]) ==
          0);                                                    // over no points
    CHECK(inner_product<delta_weight>(f, f) == 153);             // 1 + 2*4 + 4*36
    CHECK(inner_product<nabla_weight>(f, Delta_minus[f]) == 42); // 1*2 + 2*12 + 4*4
}

TEST_CASE("the bracket f(b) - f(a) is taken at the ends of f's own domain") {
    CHECK(boundary(f) == -3);
    CHECK(boundary(g) == 3);
    CHECK(boundary(Delta_plus[f]) == -3);
    CHECK(boundary(restrict_to(f, without_first(T))) == -4);
    CHECK(boundary(restrict_to(f, interior(T))) == 4);
    CHECK_THROWS_AS(
        (void)boundary(restrict_to(function_on(uniform(Q(0), Q(1), 1), std::vector<Q>{1, 2}), interior(uniform(Q(0), Q(1), 1)))),
        error::outside_domain);
}

TEST_CASE("vector values integrate componentwise") {
    auto const S = uniform(0.0, 0.5, 4);
    auto const u = function_on(S, [](double t) { return Eigen::Vector2d(1.0, t); });
    CHECK(integral(u, S) == Eigen::Vector2d(2.0, 1.5));
    CHECK(nabla_integral(u, S) == Eigen::Vector2d(2.0, 2.5));
    CHECK(integral(extend[u], half(S)) == Eigen::Vector2d(2.0, 2.0));
    CHECK(integral(u, 1.5, 0.5) == Eigen::Vector2d(-1.0, -0.75));
    CHECK(antiderivative[u](1.0) == Eigen::Vector2d(1.0, 0.25));
    auto const v = function_on(S, [](double t) { return Eigen::VectorXd(Eigen::VectorXd::Constant(3, t)); });
    CHECK(integral(v, S) == Eigen::VectorXd::Constant(3, 1.5));
    CHECK(integral(v, 0.5, 0.5) == Eigen::VectorXd::Zero(3)); // nothing, of the right length
    CHECK(antiderivative[v][0] == Eigen::VectorXd::Zero(3));
    CHECK(boundary(v) == Eigen::VectorXd::Constant(3, 2.0));
    CHECK(weighted_sum<delta_weight>(
              Delta_plus[Delta_plus[function_on(uniform(0.0, 1.0, 1), [](double t) { return Eigen::Vector2d(t, t); })]]) ==
          Eigen::Vector2d(0.0, 0.0));
}

TEST_CASE("the mid-point rule is of order two, the left and the right rule of order one") {
    auto const error_of = [](auto rule, int n) { return std::abs(rule(uniform(interval{0.0, 1.0}, n)) - (std::exp(1.0) - 1)); };
    auto const e = [](double t) { return std::exp(t); };
    auto const left = [&](auto const& S) { return integral(function_on(S, e), S); };
    auto const right = [&](auto const& S) { return nabla_integral(function_on(S, e), S); };
    auto const middle = [&](auto const& S) { return integral(function_on(half(S), e), half(S)); };
    CHECK(std::log2(error_of(left, 500) / error_of(left, 1000)) == doctest::Approx(1).epsilon(0.01));
    CHECK(std::log2(error_of(right, 500) / error_of(right, 1000)) == doctest::Approx(1).epsilon(0.01));
    CHECK(std::log2(error_of(middle, 500) / error_of(middle, 1000)) == doctest::Approx(2).epsilon(0.01));
}

} // namespace operator_integral_tests
