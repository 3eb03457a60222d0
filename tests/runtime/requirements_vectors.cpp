// SPDX-License-Identifier: BSL-1.0
// Only what a scene requires is computed: steps in the plane and in space, and steps with several nodes. Beside each test stands what would
// break it.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/integrator/requirements.hpp"

using namespace hilger;

namespace {

auto const T = uniform(0.0, 0.05, 40);

} // namespace

TEST_CASE("in space, with a mass: twelve operations for twelve numbers") {
    // Broken by a dense factorization of the diagonal matrix that d2L/dv2 is.
    auto const oscillator = [](auto const& q, auto const& v) { return 3 * v.dot(v) / 2 - q.dot(q) / 2; };
    Eigen::Vector3d const q(1, 2, 3), p(0, 1, 0);
    requirements const r = requirements_of(embed(oscillator, order_one).along(T, q, p));
    CHECK(r.newton_rounds == 0);
    CHECK(r.second_derivatives == 0);
    CHECK(r.solves == 0);
    CHECK(r.factorizations == 0);
    CHECK(r.growth_in_bytes == 0);
    CHECK(r.forces == 1);
    CHECK(r.functions == 0);
    CHECK(r.arithmetic == 3 * 5 + 3); // each: h q, p -, / 3, h v, q +; is v_0 + v_1 + v_2 finite?
}

TEST_CASE("mid-point in the plane: the symmetric second derivatives once, one root for all of them") {
    // Broken by derivatives that are made from the start again for each component, by a round that is not needed.
    auto const kepler = [](auto const& q, auto const& v) { return v.dot(v) / 2 + 1 / q.norm(); };
    requirements const plane = requirements_of(embed(kepler, midpoint).along(T, Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)));
    CHECK(plane.growth_in_bytes == 0);
    CHECK(plane.forces == plane.newton_rounds);
    CHECK(plane.newton_rounds <= 1.5);
    CHECK(plane.second_derivatives == 3 * plane.newton_rounds); // of four, two are one
    CHECK(plane.functions == plane.newton_rounds);
    CHECK(plane.memory_bytes == 8 * (2 * 7 + 5));
}

TEST_CASE("Galerkin: a force and its derivative at each node and round") {
    // Broken by derivatives that are evaluated apart from the forces.
    auto const pendulum = [](auto const& q, auto const& v) { return v * v / 2 + cos(q); };
    requirements const r = requirements_of(embed(pendulum, galerkin<2, gauss>).along(T, 1.0, 0.5));
    CHECK(r.growth_in_bytes == 0);
    CHECK(r.newton_rounds <= 4);
    CHECK(r.forces == 2 * r.newton_rounds);
    CHECK(r.second_derivatives == 2 * r.newton_rounds);
}
