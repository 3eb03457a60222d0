// SPDX-License-Identifier: BSL-1.0
// The newest weight of a mean damping is part of the equation of the step in every engine: small states and large, Lagrangians that say
// how they are put together, explicit steps and Newton's method all make one curve, and its equation holds.
#include <doctest/doctest.h>

#include "orders.hpp"
#include "support/systems.hpp"

namespace fractional_engines_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

constexpr auto one_of_many = [](auto const& x, auto const& v) { return v.dot(v) + cos(x(0)); };
constexpr auto alone = [](auto const& x, auto const& v) { return v * v + cos(x); };
constexpr auto hanging = [](auto const& x) {
    using std::cos;
    return -cos(x(0));
};
using vector = Eigen::VectorXd;

template <class L, class E>
std::vector<double> curve(L const& l, E const& how, double rho, double h) {
    auto const damped = with_fractional_damping(l, {{rho, 0.5}, {rho / 4, 1.0}});
    auto const T = uniform(0.0, h, 40);
    std::vector<double> all;
    if constexpr (std::same_as<L, std::remove_cvref_t<decltype(alone)>>)
        for (auto const& x : embed(damped, how).along(T, 1.0, 0.5)) all.insert(all.end(), {x.q, x.p});
    else
        for (auto const& x : embed(damped, how).along(T, vector(vector::Constant(1, 1.0)), vector(vector::Constant(1, 0.5))))
            all.insert(all.end(), {x.q(0), x.p(0)});
    return all;
}
double apart(std::vector<double> const& a, std::vector<double> const& b) {
    double most = 0;
    for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
    return most;
}
template <class E>
void is_one_curve(E const& how) {
    auto const full = mechanical(Eigen::MatrixXd(Eigen::MatrixXd::Constant(1, 1, 2.0)), hanging);
    auto const diagonal = mechanical(vector(vector::Constant(1, 2.0)), hanging);
    auto const number = mechanical(2.0, hanging);
    for (auto const& at : {std::array{0.3, 0.05}, std::array{50.0, 0.05}, std::array{0.5, 1.2}}) {
        double const rho = at[0], h = at[1];
        CAPTURE(rho);
        CAPTURE(h);
        auto const expected = curve(alone, how, rho, h);
        double const rounding = 4096 * epsilon<double>();
        CHECK(apart(curve(one_of_many, how, rho, h), expected) < rounding);
        CHECK(apart(curve(full, how, rho, h), expected) < rounding);
        CHECK(apart(curve(diagonal, how, rho, h), expected) < rounding);
        CHECK(apart(curve(number, how, rho, h), expected) < rounding);
    }
}

} // namespace

TEST_CASE("mid-point") { is_one_curve(mid_point); }
TEST_CASE("order one, from the right and from the left") {
    is_one_curve(order_one);
    is_one_curve(order_one_left);
}
TEST_CASE("Galerkin, by iteration of forces and by Newton's method") { is_one_curve(galerkin<2, gauss>); }

TEST_CASE("half of the impulse is at each end, whatever the embedding") {
    // M v = p_i + h/2 F + h a_0 f(A), p_{i+1} = M v + h/2 F + h a_1 f(A), A = a_0 q_i + a_1 q_{i+1}
    double const h = 0.25, rho = 3, beta = 0.5, theta_of_mean = (1 + beta) / 2;
    auto const holds = [&](auto const& how, double a1) {
        std::vector<double> x, p;
        auto const flow = embed(with_fractional_damping(alone, rho, fraction<1, 2>{}), how);
        for (auto const& at : flow.along(uniform(0.0, h, 30), 1.0, 0.5)) x.push_back(at.q), p.push_back(at.p);
        auto const w = first_weights<grunwald_letnikov>(beta, 31);
        auto const difference = [&](std::size_t k) {
            double sum = 0;
            for (std::size_t n = 0; n <= k; ++n) sum += w[n] * (x[k - n] - 1.0);
            return sum / std::pow(h, beta);
        };
        for (std::size_t k = 0; k + 1 < x.size(); ++k) {
            double const F = -rho * (theta_of_mean * difference(k + 1) + (1 - theta_of_mean) * difference(k));
            double const mv = 2 * (x[k + 1] - x[k]) / h, f = -std::sin((1 - a1) * x[k] + a1 * x[k + 1]);
            CHECK(std::abs(p[k] + h / 2 * F + h * (1 - a1) * f - mv) < 256 * epsilon<double>());
            CHECK(std::abs(p[k + 1] - h / 2 * F - h * a1 * f - mv) < 256 * epsilon<double>());
        }
    };
    holds(mid_point, 0.5);
    holds(order_one, 0);
    holds(order_one_left, 1);
    holds(theta<1, 4>, 0.25);
}

} // namespace fractional_engines_tests
