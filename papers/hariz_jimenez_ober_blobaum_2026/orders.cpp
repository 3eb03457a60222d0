// SPDX-License-Identifier: BSL-1.0
// Hariz, Jimenez and Ober-Bloebaum: orders with memory. D^mu at the stages is right to the order min(p, q + 1 - mu), q the stage order,
// s - 1 of Lobatto IIIC and s of Radau IIA; the equation integrates it twice, so that solutions have min(p, q + 3 - mu) where they are
// smooth. On equal steps the start of the solutions of B and C decides, whatever the method.
#include <cmath>

#include <doctest/doctest.h>

#include "stage_schemes.hpp"

namespace hariz_orders_tests {

using namespace hilger;
using namespace hilger::papers;

namespace {
template <int Stages>
auto lobatto_of(forced_oscillator const& p) {
    return lobatto_flow<Stages>(p.mechanics(), p.rho, p.mu);
}
template <int Stages>
auto radau_of(forced_oscillator const& p) {
    return radau_flow<Stages>(p.mechanics(), p.rho, p.mu);
}
} // namespace

TEST_CASE("a smooth solution, t^7, on equal steps: min(p, q + 3 - mu)") {
    for (double const mu : {0.5, 1.5}) {
        forced_oscillator const smooth{7, 1, mu};
        CAPTURE(mu);
        CHECK(std::abs(order_of(smooth, lobatto_of<2>(smooth), 1, 64) - smooth_order(2, 1, mu)) < 0.05);
        CHECK(std::abs(order_of(smooth, lobatto_of<3>(smooth), 1, 64) - smooth_order(4, 2, mu)) < 0.05);
        CHECK(std::abs(order_of(smooth, lobatto_of<4>(smooth), 1, 32) - smooth_order(6, 3, mu)) < 0.3);
        CHECK(std::abs(order_of(smooth, radau_of<2>(smooth), 1, 64) - smooth_order(3, 2, mu)) < 0.05);
        CHECK(std::abs(order_of(smooth, radau_of<3>(smooth), 1, 32) - smooth_order(5, 3, mu)) < 0.1);
        CHECK(std::abs(order_of(smooth, radau_of<4>(smooth), 1, 16) - smooth_order(7, 4, mu)) < 0.15);
    }
}

TEST_CASE("problems B and C on equal steps: the start of the force, t^{5/2} and t^{1/2}, for three and four stages of either method") {
    auto const check = [](auto const& p, double order) {
        CHECK(std::abs(order_of(p, lobatto_of<3>(p), 1, 64) - order) < 0.07);
        CHECK(std::abs(order_of(p, lobatto_of<4>(p), 1, 32) - order) < 0.05);
        CHECK(std::abs(order_of(p, radau_of<3>(p), 1, 32) - order) < 0.05);
        CHECK(std::abs(order_of(p, radau_of<4>(p), 1, 32) - order) < 0.05);
    };
    check(problem_b, 3.5);
    check(problem_c, 1.5);
    check(forced_oscillator{3, 1, 1.5}, 2.5);
    CHECK(std::abs(order_of(problem_b, lobatto_of<2>(problem_b), 1, 64) - 2) < 0.05);
}

TEST_CASE("problem B on graded T: 2s - 2 at the stages of Lobatto IIIC, and about 2s - 1 at those of Radau IIA") {
    CHECK(order_of(problem_b, lobatto_of<3>(problem_b), 2, 64) > 3.7);
    CHECK(order_of(problem_b, lobatto_of<3>(problem_b), 2, 64) < 4.1);
    CHECK(std::abs(order_of(problem_b, lobatto_of<4>(problem_b), 2, 16) - 6) < 0.1);
    CHECK(order_of(problem_b, radau_of<3>(problem_b), 2.5, 16) >= 4.7);
    CHECK(order_of(problem_b, radau_of<4>(problem_b), 2.5, 8) >= 6.3);
    // 64 steps, where 256 equal ones of the preprint have 2e-11
    auto const preprint = lobatto_flow<3>(problem_b.mechanics(), problem_b.rho, problem_b.mu); // Galerkin and D^½, both at Lobatto's nodes
    auto const ours = radau_flow<4>(problem_b.mechanics(), problem_b.rho, problem_b.mu);       // both at Radau's
    double const error = largest_error_of(problem_b, ours, graded(0.0, 1.0, 64, 2.5));         // 1e-14
    CHECK(error <= 1e-13);
    CHECK(error < largest_error_of(problem_b, preprint, graded(0.0, 1.0, 256, 2.5)));
}

TEST_CASE("problem C on graded T: Radau IIA has 4 and 6 with three and four stages, an order above Lobatto IIIC") {
    CHECK(order_of(problem_c, radau_of<3>(problem_c), 3, 8) >= 4.0);
    CHECK(order_of(problem_c, radau_of<4>(problem_c), 4, 8) >= 6);
    double const lobatto_3 = order_of(problem_c, lobatto_of<3>(problem_c), 3, 32);
    CHECK(lobatto_3 > 3.2);
    CHECK(lobatto_3 < 3.6);
    CHECK(order_of(problem_c, lobatto_of<2>(problem_c), 3, 32) < 2.1);
}

} // namespace hariz_orders_tests
