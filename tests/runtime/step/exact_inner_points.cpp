// SPDX-License-Identifier: BSL-1.0
// Embeddings that read points inside their steps: their equations hold exactly in the rationals, their steps are symplectic, have their
// order, are undone by their adjoints, and go on when they were stopped.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "runtime/embedding/radau.hpp"
#include "runtime/step/embeddings_inside.hpp"
#include "runtime/step/exact_steps.hpp"
#include "runtime/trajectory/resuming.hpp"
#include "support/orders.hpp"

namespace exact_inner_points_tests {

using namespace hilger;
using namespace hilger::testing;

TEST_CASE("in the rationals the equation holds exactly, at the points of T and inside") {
    auto const T = uniform(Q(0), Q(1, 5), 4);
    CHECK(largest_residual(embed(driven, galerkin<3, lobatto>).along(T, Q(1), Q(1, 2))) == 0);
    CHECK(largest_residual(embed(driven, radau_galerkin).along(T, Q(1), Q(1, 2))) == 0);
    CHECK(largest_residual(embed(driven, two_mid_points).along(T, Q(1), Q(1, 2))) == 0);
    CHECK(largest_residual(embed(driven, trapezoid_galerkin).along(T, Q(1), Q(1, 2))) == 0);
    // and on uneven steps
    auto const uneven = time_scale(std::vector{Q(0), Q(1, 5), Q(1, 3), Q(1)});
    lagrangian const L = [](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; };
    constexpr unknown<"q", subdivided<2>> q;
    auto const EL = variation(integral(L(radau_galerkin.position[q], radau_galerkin.velocity[q]), at_nodes<own_radau, 2>(uneven)));
    auto const x = solve(EL, uneven, {.q0 = Q(1), .v0 = Q(0)});
    CHECK(x.size() == 7);
    CHECK(x.get(0) == 1);
    CHECK(x.get(1) != x.get(0));
    CHECK(largest_residual(EL, x) == 0);
}

TEST_CASE("adjoints undo steps of -h, and those of symmetric nodes are themselves") {
    CHECK(undoes(embed(driven, radau_galerkin)));
    CHECK(undoes(embed(driven, galerkin<2, radau>)));
    CHECK(undoes(embed(driven, two_mid_points)));
    CHECK(steps_as(adjoint(embed(driven, galerkin<3, lobatto>)), embed(driven, galerkin<3, lobatto>)));
    CHECK_FALSE(steps_as(adjoint(embed(driven, radau_galerkin)), embed(driven, radau_galerkin)));
    CHECK_FALSE(steps_as(adjoint(embed(driven, galerkin<2, radau>)), embed(driven, galerkin<2, radau>)));
}

TEST_CASE("steps are symplectic") {
    auto const one = [](auto const& e, auto const& q, auto const& p) {
        auto const J = jacobian_of_step(embed(general, e), state<float50, std::remove_cvref_t<decltype(q)>>{0, q, p}, float50(1) / 10);
        return symplecticity_error(J);
    };
    using V = Eigen::Matrix<float50, 2, 1>;
    V const q(float50(3) / 10, float50(1) / 5), p(float50(0), float50(1) / 10);
    // differences of steps in 50 digits
    CHECK(one(radau_galerkin, q, p) < 1e-20);
}

TEST_CASE("quadratic polynomials at two Radau nodes have order 3") {
    auto const end = [](auto const& how, int n) {
        auto const path = embed(swing, how).along(uniform(interval<float50>{0, 1}, n), float50(1), float50(0));
        auto last = *path.begin();
        for (auto const& x : path) last = x;
        return last.q;
    };
    float50 const reference = end(galerkin<6, gauss>, 20);
    CHECK(std::abs(order_of(float50(end(radau_galerkin, 40) - reference), float50(end(radau_galerkin, 80) - reference)) - 3) < 0.02);
}

TEST_CASE("runs that are stopped and read back go on as they would have") {
    CHECK(differences(pendulum_path<double>(embed(swing, radau_galerkin), 30), 7) == 0);
    CHECK(differences(pendulum_path<double>(embed(with_force(swing, friction), galerkin<3, gauss>), 30), 11) == 0);
    CHECK(differences(pendulum_path<double>(embed(swing, by_tableau(galerkin<2, gauss>), compensated), 30), 12) == 0);
}

} // namespace exact_inner_points_tests
