// SPDX-License-Identifier: BSL-1.0
// The numbers of Galerkin steps: as near to the true ones as the scalar has numbers, and they satisfy the order conditions.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace galerkin_table_tests {

using namespace hilger;

namespace {

/// The largest distance of a list of numbers from the same list in 50 digits, in relative epsilons.
template <class S, class A, class B>
double distance_between(A const& a, B const& b) {
    if constexpr (requires { a.size(); }) {
        double worst = 0;
        for (std::size_t k = 0; k < a.size(); ++k) worst = std::max(worst, distance_between<S>(a[k], b[k]));
        return worst;
    } else
        return b == 0 ? (a == 0 ? 0.0 : 1e9) : static_cast<double>(float50(abs(float50(a) / b - 1) / epsilon<S>()));
}
template <class S, int Stages, class Quadrature>
void is_rounded_once() {
    CAPTURE(Stages);
    CAPTURE(Quadrature::name);
    auto const& a = detail::galerkin_table<S, Stages, Quadrature>::here();
    auto const& b = detail::galerkin_table<float50, Stages, Quadrature>::here();
    CHECK(distance_between<S>(a.whole.node, b.whole.node) <= 1);
    CHECK(distance_between<S>(a.whole.weight, b.whole.weight) <= 1);
    CHECK(distance_between<S>(a.alpha, b.alpha) <= 1);
    CHECK(distance_between<S>(a.momentum, b.momentum) <= 1);
    CHECK(distance_between<S>(a.whole.twice, b.whole.twice) <= 1);
    CHECK(distance_between<S>(a.whole.reach, b.whole.reach) <= 1);
    CHECK(distance_between<S>(a.next_node, b.next_node) <= 1);
}
/// Both parts together, and whether the first has no more than ten digits behind the point.
template <class A, class B>
void are_parts_of(A const& leading, A const& rest, B const& all, double epsilon) {
    if constexpr (requires { all.size(); })
        for (std::size_t k = 0; k < all.size(); ++k) are_parts_of(leading[k], rest[k], all[k], epsilon);
    else {
        CHECK(abs(float50(leading) + float50(rest) - float50(all)) <= float50(epsilon) / 1024);
        CHECK(std::floor(leading * 1024) == leading * 1024);
    }
}
template <class S, int Stages, class Quadrature>
void is_known_in_two_parts() {
    auto const& a = detail::galerkin_table<S, Stages, Quadrature>::here();
    auto const& b = detail::galerkin_table<float50, Stages, Quadrature>::here().whole;
    double const eps = static_cast<double>(epsilon<S>());
    are_parts_of(a.leading.node, a.rest.node, b.node, eps);
    are_parts_of(a.leading.weight, a.rest.weight, b.weight, eps);
    are_parts_of(a.leading.reach, a.rest.reach, b.reach, eps);
    are_parts_of(a.leading.twice, a.rest.twice, b.twice, eps);
}

} // namespace

TEST_CASE("coefficients are within an epsilon of themselves in 50 digits") {
    is_rounded_once<double, 2, gauss>();
    is_rounded_once<double, 6, gauss>();
    is_rounded_once<double, 12, gauss>();
    is_rounded_once<double, 2, lobatto>();
    is_rounded_once<double, 5, lobatto>();
    is_rounded_once<float, 8, gauss>();
    is_rounded_once<long double, 8, lobatto>();
}

TEST_CASE("two parts know a thousandth of an epsilon") {
    is_known_in_two_parts<double, 2, gauss>();
    is_known_in_two_parts<double, 8, gauss>();
    is_known_in_two_parts<float, 4, gauss>();
    is_known_in_two_parts<long double, 3, lobatto>();
}

TEST_CASE("those of two Gauss nodes are Hammer and Hollingsworth's, those of three Lobatto nodes Simpson's") {
    auto const& a = detail::galerkin_table<double, 2, gauss>::here();
    double const root = std::sqrt(3.0) / 6, eps = epsilon<double>();
    CHECK(std::abs(a.alpha[0][0] - 0.25) <= eps);
    CHECK(std::abs(a.alpha[0][1] - (0.25 - root)) <= eps);
    CHECK(std::abs(a.alpha[1][0] - (0.25 + root)) <= eps);
    CHECK(std::abs(a.whole.node[0] - (0.5 - root)) <= eps);
    auto const& b = detail::galerkin_table<double, 3, lobatto>::here();
    CHECK((b.whole.weight[0] == 1.0 / 6 and b.whole.weight[1] == 2.0 / 3 and b.whole.weight[2] == 1.0 / 6));
}

// With c^m for c to the power m: B(2s) sum b_k c_k^(m-1) = 1/m; C(s) sum_j a_kj c_j^(m-1) = c_k^m / m; D(s) sum_k b_k c_k^(m-1) a_kj =
// b_j (1 - c_j^m) / m (Hairer, Lubich, Wanner, Geometric Numerical Integration, II.1.3); symplectic: b_k a_kj + b_j a_jk = b_k b_j.
TEST_CASE_TEMPLATE("the simplifying assumptions of Gauss methods hold to rounding", S, float, double) {
    constexpr int s = 8;
    auto const& T = detail::galerkin_table<S, s, gauss>::here();
    // Sums of s products of numbers below 1, their entries rounded: s + 2 roundings each at the most.
    S const rounding = S(s + 2) * epsilon<S>();
    for (int m = 1; m <= 2 * s; ++m) {
        S sum(0);
        for (std::size_t k = 0; k < s; ++k) sum += T.whole.weight[k] * std::pow(T.whole.node[k], S(m - 1));
        CHECK(std::abs(sum - S(1) / S(m)) <= rounding);
    }
    for (std::size_t k = 0; k < s; ++k) {
        for (int m = 1; m <= s; ++m) {
            S c(0), d(0);
            for (std::size_t j = 0; j < s; ++j) {
                c += T.alpha[k][j] * std::pow(T.whole.node[j], S(m - 1));
                d += T.whole.weight[j] * std::pow(T.whole.node[j], S(m - 1)) * T.alpha[j][k];
            }
            CHECK(std::abs(c - std::pow(T.whole.node[k], S(m)) / S(m)) <= rounding);
            CHECK(std::abs(d - T.whole.weight[k] * (S(1) - std::pow(T.whole.node[k], S(m))) / S(m)) <= rounding);
        }
        for (std::size_t j = 0; j < s; ++j) {
            S const product = T.whole.weight[k] * T.whole.weight[j];
            CHECK(std::abs(T.whole.weight[k] * T.alpha[k][j] + T.whole.weight[j] * T.alpha[j][k] - product) <=
                  S(4) * epsilon<S>() * product);
            CHECK(T.momentum[k][j] == T.alpha[k][j]);
        }
    }
}

TEST_CASE("what is read one step further is exact for polynomials") {
    auto const& T = detail::galerkin_table<float50, 5, lobatto>::here();
    for (std::size_t k = 0; k < T.N; ++k) {
        float50 sum = 0;
        for (std::size_t j = 0; j < T.N; ++j) sum += T.next_node[k][j] * pow(T.whole.node[j], 4);
        CHECK(abs(sum - pow(float50(1 + T.whole.node[k]), 4)) < 1000 * epsilon<float50>());
    }
}

TEST_CASE("exact scalars have exact nodes, or are told that these are irrational") {
    auto const simpson = lobatto::on_unit_interval<Q>(3);
    CHECK(simpson.node == std::vector<Q>{0, Q(1, 2), 1});
    CHECK(simpson.weight == std::vector<Q>{Q(1, 6), Q(2, 3), Q(1, 6)});
    CHECK_THROWS_WITH_AS(gauss::on_unit_interval<Q>(2), "these nodes are irrational: take a scalar that is not exact",
                         error::invalid_parameter const&);
}

} // namespace galerkin_table_tests
