// SPDX-License-Identifier: BSL-1.0
// Only what a scene requires is computed: steps in the plane, masses in space, and steps with several nodes. Beside each test stands what
// would break it.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "support/requirements.hpp"
#include "support/systems.hpp"

namespace requirements_vectors_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

auto const T = uniform(0.0, 0.05, 40);

} // namespace

TEST_CASE("a mass for each component is divided by, and not factorized") {
    // Broken by a dense factorization of the diagonal matrix that d2L/dv2 is under order one.
    counted const x = counted::variable(3), y = counted::variable(5), z = counted::variable(7);
    std::array<counted, 9> mass{2, 0, 0, 0, 4, 0, 0, 0, 8}, full{x, 1, 0, 1, y, 0, 0, 0, z};
    auto const counts_of = [](std::array<counted, 9>& K, std::array<counted, 3> r) {
        auto& record = record_of_operations::of_this_thread();
        record.begin();
        CHECK(detail::small_solve<counted, 3, 9>(K, r));
        record.stop_counting();
        for (counted const& component : r) component.need();
        return std::pair(record.end(), r);
    };
    auto [n, r] = counts_of(mass, {x, y, z});
    CHECK(n.arithmetic == 3);
    CHECK(r[0].value() == 3.0 / 2);
    CHECK(r[1].value() == 5.0 / 4);
    CHECK(r[2].value() == 7.0 / 8);
    auto const [m, s] = counts_of(full, {x + 1, y + 1, z});
    CHECK(m.arithmetic > 9);
    for (counted const& component : s) CHECK(std::abs(component.value() - 1) <= 16 * epsilon<double>());
    std::array<counted, 9> none{2, 0, 0, 0, 0, 0, 0, 0, 8};
    std::array<counted, 3> of_it{x, y, z};
    CHECK_FALSE(detail::small_solve<counted, 3, 9>(none, of_it));
}

TEST_CASE("mid-point in the plane: the symmetric second derivatives once, one root for all of them") {
    // Broken by derivatives that are made from the start again for each component, by a round that is not needed.
    auto const kepler = [](auto const& q, auto const& v) { return v.dot(v) / 2 + 1 / q.norm(); };
    requirements const plane = requirements_of(embed(kepler, mid_point).along(T, Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)));
    CHECK(plane.growth_in_bytes == 0);
    CHECK(plane.functions <= 1.5); // a root a round
    CHECK(plane.arithmetic <= 150 * plane.functions);
    CHECK(plane.memory_bytes == 8 * (2 * 7 + 5));
}

TEST_CASE("Stoermer-Verlet of a formula that is traced: one force a step, and nothing solved") {
    // Broken by half steps that are made in turns, by a force that is not kept.
    auto const kepler = [](auto const& q, auto const& v) { return v.dot(v) / 2 + 1 / q.norm(); };
    Eigen::VectorXd const q = Eigen::Vector2d(1, 0), p = Eigen::Vector2d(0, 1);
    requirements const r = requirements_of(stoermer_verlet(kepler).along(T, q, p));
    CHECK(r.growth_in_bytes == 0);
    CHECK(r.functions == 1); // the root of one force
    CHECK(r.arithmetic <= 30);
}

TEST_CASE("Galerkin: forces at the nodes, and no second derivative of them") {
    // Broken by Newton where the forces contract, by a round that is not needed.
    requirements const r = requirements_of(embed(pendulum, galerkin<2, gauss>).along(T, 1.0, 0.5));
    CHECK(r.growth_in_bytes == 0);
    CHECK(r.cosines == 0);
    CHECK(r.sines >= 4);
    CHECK(r.sines <= 2 * 5);
    CHECK(r.functions == r.sines);
}

} // namespace requirements_vectors_tests
