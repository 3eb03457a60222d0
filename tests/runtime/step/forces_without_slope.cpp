// SPDX-License-Identifier: BSL-1.0
// Where a force is a number and its derivative is not, as that of |q|^1.5 at 0: the motion is that of the equation all the same, for every
// kind of state. The reference finds the equation's root by bisection.
#include <doctest/doctest.h>

#include <cmath>

#include "hilger/hilger.hpp"

namespace forces_without_slope_tests {

using namespace hilger;

namespace {

constexpr double h = 0.1;
constexpr int steps = 5;

/// q after some mid-point steps of q'' = F(q, v) from (q, p), by bisection for the velocity.
double by_bisection(auto const& F, double q, double p) {
    for (int i = 0; i < steps; ++i) {
        double below = -10, above = 10;
        for (int k = 0; k < 100; ++k) {
            double const v = (below + above) / 2;
            (p + h / 2 * F(q + h / 2 * v, v) - v > 0 ? below : above) = v;
        }
        p += h * F(q + h / 2 * above, above);
        q += h * above;
    }
    return q;
}
/// The same steps in vectors of all kinds, each of whose components moves alone and as the others.
void end_at(double expected, double q, double p, auto const& flow) {
    auto const check = [&](auto const& q0, auto const& p0) {
        CAPTURE(q0.size());
        auto const path = flow.along(uniform(0.0, h, steps), q0, p0);
        auto const end = record(path).states.back().q;
        CHECK((end.array() - expected).abs().maxCoeff() <= 1e-14);
        CHECK(largest_residual(path) <= 64 * epsilon<double>());
    };
    for (int const d : {1, 2, 5}) check(Eigen::VectorXd(Eigen::VectorXd::Constant(d, q)), Eigen::VectorXd(Eigen::VectorXd::Constant(d, p)));
    check(Eigen::Vector2d(q, q), Eigen::Vector2d(p, p));
    using six = Eigen::Matrix<double, 6, 1>;
    check(six(six::Constant(q)), six(six::Constant(p)));
}
/// For L = v^2/2 + sum of U(q_k).
constexpr auto alone = [](auto const& U) {
    return [U](auto const& q, auto const& v) {
        auto sum = v.squaredNorm() / 2 + 0 * q(0);
        for (int k = 0; k < q.size(); ++k) sum = sum + U(q(k));
        return sum;
    };
};
constexpr auto pulled = [](auto const& q) { return q - pow(abs(q), 1.5); };
constexpr auto pulled_to_0 = [](auto const& q) { return -pow(q * q, 0.75); };
double slope_of_pulled(double q, double) { return 1 - 1.5 * std::copysign(std::sqrt(std::abs(q)), q); }
double slope_of_pulled_to_0(double q, double) { return -1.5 * std::copysign(std::sqrt(std::abs(q)), q); }

} // namespace

TEST_CASE("mid-point from where the force has no slope, and through there") {
    end_at(by_bisection(slope_of_pulled, 0, 0), 0, 0, embed(alone(pulled), mid_point));
    // The middle of the first guess is 0 exactly.
    double const beside = by_bisection(slope_of_pulled_to_0, -0.05, 1);
    end_at(beside, -0.05, 1, embed(alone(pulled_to_0), mid_point));
    auto const L = [](auto const& q, auto const& v) { return v * v / 2 + pulled(q); };
    auto const path = embed(L, mid_point).along(uniform(0.0, h, steps), 0.0, 0.0);
    CHECK(std::abs(record(path).states.back().q - by_bisection(slope_of_pulled, 0, 0)) <= 1e-14);
    CHECK(largest_residual(path) <= 64 * epsilon<double>());
}
TEST_CASE("order one needs no slope of a force") {
    double q = 0, p = 0;
    for (int i = 0; i < steps; ++i) {
        p += h * slope_of_pulled(q, 0);
        q += h * p;
    }
    end_at(q, 0, 0, embed(alone(pulled), order_one));
    auto const L = [](auto const& x, auto const& v) { return v * v / 2 + pulled(x); };
    CHECK(std::abs(record(embed(L, order_one).along(uniform(0.0, h, steps), 0.0, 0.0)).states.back().q - q) <= 1e-15);
}
TEST_CASE("a friction without a slope at rest") {
    auto const oscillator = [](auto const& q, auto const& v) { return v.squaredNorm() / 2 - q.squaredNorm() / 2; };
    auto const force = [](auto const& q, auto const& v) {
        auto f = (0 * v + 0 * q).eval();
        for (int k = 0; k < q.size(); ++k) f(k) = f(k) + 1 - sqrt(abs(v(k)));
        return f;
    };
    auto const F = [](double q, double v) { return 1 - q - std::sqrt(std::abs(v)); };
    end_at(by_bisection(F, 0, 0), 0, 0, embed(with_force(oscillator, force), mid_point));
}
TEST_CASE("derivatives by what a power of 0 does not depend on are zero, and not NaN") {
    auto const L = [](auto const& q, auto const& v) { return v.squaredNorm() / 2 - pow(abs(q(0)), 1.5) - q(0) * q(1) * q(1); };
    auto const e = expand(L, Eigen::Vector2d(0, 2), Eigen::Vector2d(0, 0));
    CHECK(e.by_q == Eigen::Vector2d(-4, 0));
    CHECK(e.vv == Eigen::Matrix2d::Identity());
    CHECK(e.qv == Eigen::Matrix2d::Zero());
    CHECK(e.qq(0, 1) == -4);
    CHECK(e.qq(1, 1) == 0);
    CHECK(not std::isfinite(e.qq(0, 0)));
    CHECK(e.qq(0, 0) < 0);
}

} // namespace forces_without_slope_tests
