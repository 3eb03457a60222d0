// SPDX-License-Identifier: BSL-1.0
// Section 1 and the printed L_d of section 3 of F. Jimenez and S. Ober-Bloebaum (2019): the variational integrators (9) to (11), theorem 1
// for them, and the order of the differences (15).
#include <doctest/doctest.h>

#include "local_truncation.hpp"

namespace jimenez_preliminaries_tests {

using namespace hilger;
using namespace hilger::papers;

namespace {

constexpr lagrangian cubic{[](auto const& x, auto const& v) { return v * v / 2 - x * x * x; }};

/// (11) with U = x^2/2 along the flow of an embedding, in the rationals, and (9), the discrete Euler-Lagrange equation.
template <class Embedding>
void is_11(Embedding const& how, Q const& gamma) {
    Q const h(2, 7);
    auto const T = uniform(Q(0), h, 5);
    std::vector<Q> x, v;
    for (auto const& z : embed(spring, how).along(T, Q(3, 2), Q(-1, 3))) {
        x.push_back(z.q);
        v.push_back(z.p);
    }
    auto const between = [&](std::size_t k) { return Q(gamma * x[k] + (1 - gamma) * x[k + 1]); };
    for (std::size_t k = 0; k < 5; ++k) {
        CHECK(x[k + 1] == x[k] + h * v[k] - h * h * gamma * between(k));
        CHECK(v[k + 1] == v[k] - h * between(k));
        if (k > 0) CHECK((x[k + 1] - 2 * x[k] + x[k - 1]) / (h * h) == -gamma * between(k) - (1 - gamma) * between(k - 1));
    }
}

} // namespace

TEST_CASE("(9) to (11): embeddings with lambda = 1 - gamma have these steps and this equation, exactly") {
    is_11(order_one, Q(1));
    is_11(theta<1, 4>, Q(3, 4));
    is_11(mid_point, Q(1, 2));
    is_11(theta<3, 4>, Q(1, 4));
}

TEST_CASE("theorem 1: local truncation of order 2 for gamma = 1/2 and of order 1 for the others, against (5)") {
    auto const of_spring = [](point const& z, float50 const& h) { return harmonic(z, h, 0); };
    auto const of_bob = [](point const& z, float50 const& h) { return pendulum(z, h, 0); };
    auto const check = [&](auto const& how, double order) {
        for (double const p : truncation_orders(embed(spring, how), of_spring)) CHECK(std::abs(p - order) < 0.02);
        for (double const p : truncation_orders(embed(bob, how), of_bob)) CHECK(std::abs(p - order) < 0.02);
    };
    check(mid_point, 2);
    check(order_one, 1);
    check(theta<1, 4>, 1);
}

TEST_CASE("after (21): (10) takes (x_{k+1} - x_k)^2 / 2h - h U; without the square its momenta are not velocities") {
    Q const h(2, 7), x(3, 2), y(-1, 5);
    auto const corrected = [&](auto const& a, auto const& b) { return (b - a) * (b - a) / (2 * h) + h * cubic((a + b) / 2, 0 * a); };
    auto const printed = [&](auto const& a, auto const& b) { return (b - a) / (2 * h) + h * cubic((a + b) / 2, 0 * a); };
    Q const middle = (x + y) / 2, slope = 3 * middle * middle; // U = x^3
    CHECK(-gradient_first(corrected, x, y) == (y - x) / h + h / 2 * slope);
    CHECK(gradient_second(corrected, x, y) == (y - x) / h - h / 2 * slope);
    CHECK(-gradient_first(printed, x, y) != (y - x) / h + h / 2 * slope);
    CHECK(gradient_second(printed, x, y) != (y - x) / h - h / 2 * slope);
}

TEST_CASE("(15) is consistent: at t = 1 its error is of order one for x(0) = 0, and (14): the half derivative of t taken twice is 1") {
    // D_-^alpha t^n = n! t^(n - alpha) / Gamma(n + 1 - alpha)
    for (double const alpha : {0.25, 0.5, 0.75}) {
        std::vector<double> errors;
        for (int const N : {256, 512, 1024}) {
            auto const T = uniform(interval{0.0, 1.0}, N);
            auto const d = Delta_minus(alpha)[function_on(T, [](double t) { return t; })];
            errors.push_back(std::abs(d[N] - 1 / std::tgamma(2 - alpha)));
        }
        CHECK(std::abs(fitted_slope(errors) - 1) < 0.02);
    }
    auto const T = uniform(Q(0), Q(1, 9), 9);
    auto const x = function_on(T, [](Q const& t) { return t; });
    for (hilger::index_type k = 1; k <= 9; ++k) CHECK((Delta_minus_alpha<1, 2> * Delta_minus_alpha<1, 2>)[x][k] == 1);
}

} // namespace jimenez_preliminaries_tests
