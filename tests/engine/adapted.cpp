// SPDX-License-Identifier: BSL-1.0
// Walks in adapted steps end within their tolerance, for small and dynamic states, with forces and over kinks; what they are not for is
// refused.
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "stated.hpp"

namespace adapted_tests {

using namespace hilger;
using testing::stated;
using vector = Eigen::VectorXd;

namespace {

/// The distance of the end of a walk over [0, b] from a position.
double error_of(engine::problem const& what, char const* method, double b, vector const& q0, vector const& v0, double tolerance,
                vector const& end) {
    return (engine::walk_in_adapted_steps(what, method, 0, b, q0, v0)(tolerance) - end).cwiseAbs().maxCoeff();
}

} // namespace

TEST_CASE("the end of Kepler's ellipse is within the tolerance, in two coordinates") {
    engine::problem const kepler = stated("dot(v, v)/2 + 1/norm(q)", 2);
    Eigen::Vector2d const q0(0.1, 0), v0(0, std::sqrt(19.0));
    for (char const* method : {"gauss-6", "gauss-8"})
        for (double const tolerance : {1e-4, 1e-7, 1e-10})
            CHECK(error_of(kepler, method, 2 * std::numbers::pi, q0, v0, tolerance, q0) <= 10 * tolerance);
}
TEST_CASE("one walk serves several tolerances, each like the first") {
    engine::problem const pendulum = stated("v[0]^2/2 + cos(q[0])", 1);
    vector const q0 = vector::Constant(1, 1.5), v0 = vector::Zero(1);
    auto const walk = engine::walk_in_adapted_steps(pendulum, "gauss-8", 0, 20, q0, v0);
    vector const rough = walk(1e-3), fine = walk(1e-12);
    CHECK(walk(1e-3) == rough);
    CHECK(rough != fine);
    CHECK(std::abs(rough(0) - fine(0)) <= 1e-2);
}
TEST_CASE("states of more coordinates and forces are of dynamic size") {
    engine::problem const oscillators = stated("(dot(v, v) - dot(q, q))/2", 5);
    vector const q0 = vector::LinSpaced(5, -1, 1), v0 = vector::Zero(5);
    for (char const* method : {"gauss-6", "gauss-8"})
        CHECK(error_of(oscillators, method, 7, q0, v0, 1e-9, vector(q0 * std::cos(7.0))) <= 1e-8);
    vector const one = vector::Ones(1);
    engine::problem const resisted = stated("v[0]^2/2", 1, {"1 - v[0]"}); // v = 1 + 2 exp(-t)
    vector const end = vector::Constant(1, 6 - 2 * std::exp(-3.0));
    CHECK(error_of(resisted, "gauss-8", 3, one, vector::Constant(1, 3), 1e-9, end) <= 1e-8);
}
TEST_CASE("a jump of the force in time ends a step") {
    engine::problem const pushed = stated("v[0]^2/2 + abs(t - 1)*q[0]", 1); // v(2) = 1, and q(2) = 2/3 + 1/3
    CHECK(error_of(pushed, "gauss-6", 2, vector::Zero(1), vector::Zero(1), 1e-3, vector::Ones(1)) <= 1e-13);
}
TEST_CASE("adapted steps are for gauss-6 and gauss-8, one Lagrangian in t and no memory") {
    vector const one = vector::Ones(1);
    engine::problem oscillator = stated("(v[0]^2 - q[0]^2)/2", 1);
    auto const walk = [&](char const* method) { return engine::walk_in_adapted_steps(oscillator, method, 0, 1, one, one); };
    CHECK_THROWS_WITH_AS((void)walk("gauss-4"), "the methods with adapted steps are gauss-6 and gauss-8, and not 'gauss-4'",
                         error::invalid_parameter);
    oscillator.damping.push_back({0.2, 0.5});
    CHECK_THROWS_WITH_AS((void)walk("gauss-8"), "adapted steps are for one Lagrangian in t and a force, without fractional damping",
                         error::invalid_parameter);
}

} // namespace adapted_tests
