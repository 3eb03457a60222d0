// SPDX-License-Identifier: BSL-1.0
// The inverse of the Legendre map where velocities end, or masses are nothing at rest, is found from v = 0 all the same; and so walks
// begin.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace legendre_tests {

using namespace hilger;

namespace {
constexpr auto relativistic = [](auto const& q, auto const& v) { return -sqrt(1 - v * v) + 0 * q; };
constexpr auto relativistic_in_space = [](auto const& q, auto const& v) { return -sqrt(1 - v.squaredNorm()) + 0 * q(0); };
constexpr auto quartic = [](auto const& q, auto const& v) { return v * v * v * v / 4 - q * q / 2; };
} // namespace

TEST_CASE("no velocity reaches 1, and every momentum has one") {
    for (double const p : {0.5, 1.5, 3.0, -20.0, 1e3}) {
        CAPTURE(p);
        double const v = p / std::sqrt(1 + p * p);
        // p' = (1 - v^2)^(-3/2) is large where v is near 1, and so p determines v well
        CHECK(std::abs(velocity_of(relativistic, 0.0, p) - v) <= 4 * epsilon<double>());
    }
    using S = float50;
    CHECK(abs(velocity_of(relativistic, S(0), S(2)) - 2 / sqrt(S(5))) <= 4 * epsilon<S>());
    Eigen::VectorXd const p = Eigen::VectorXd::LinSpaced(6, 1, 3), rest = Eigen::VectorXd::Zero(6);
    Eigen::VectorXd const v = p / std::sqrt(1 + p.squaredNorm());
    CHECK((velocity_of(relativistic_in_space, rest, p) - v).norm() <= 16 * epsilon<double>());
}
TEST_CASE("a walk begins with a momentum beyond 1") {
    for (auto const& x : embed(relativistic, mid_point).along(uniform(0.0, 0.25, 8), 0.0, 3.0)) {
        CHECK(x.p == doctest::Approx(3).epsilon(1e-14));
        CHECK(std::abs(x.q - x.t * 3 / std::sqrt(10.0)) <= 64 * epsilon<double>());
    }
}
TEST_CASE("where the mass at rest is nothing") {
    CHECK(velocity_of(quartic, 0.0, 8.0) == doctest::Approx(2).epsilon(1e-15));
    CHECK(velocity_of(quartic, 0.0, -1.0) == doctest::Approx(-1).epsilon(1e-15));
    CHECK_THROWS_AS((void)velocity_of(quartic, 0.0, 0.0), error::singular);
    auto const path = embed(quartic, mid_point).along(uniform(0.0, 0.0625, 8), 0.0, 8.0);
    CHECK(largest_residual(path) <= 1024 * epsilon<double>());
    auto const linear = [](auto const& q, auto const& v) { return q * v; };
    CHECK_THROWS_AS((void)velocity_of(linear, 1.0, 2.0), error::singular);
}
TEST_CASE("from where the mass is so small that whole corrections leap") {
    auto const bounded = [](auto const& q, auto const& v) { return log(cosh(v)) + 0 * q; };
    for (double const guess : {-3.0, 2.0, 3.0})
        CHECK(std::abs(velocity_of(bounded, 0.0, 0.1, guess) - std::atanh(0.1)) <= epsilon<double>());
}
TEST_CASE("where there is no velocity") {
    auto const bounded = [](auto const& q, auto const& v) { return sqrt(1 + v * v) + 0 * q; };
    CHECK_THROWS_AS((void)velocity_of(bounded, 0.0, 2.0), error::exception);
}

} // namespace legendre_tests
