// SPDX-License-Identifier: BSL-1.0
// Every embedding has its order: fitted in 50 digits on a linear, a nonlinear and a non-separable problem.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "support/orders.hpp"
#include "support/three_problems.hpp"

namespace embeddings_tests {

using namespace hilger;

using testing::problem_kind, testing::problem_of, testing::three_problems;

namespace {

using point = state<float50, float50>;
template <class Embedding>
point end_of(problem_kind kind, Embedding const& how, int steps) {
    return testing::at_one(embed(problem_of(kind), how), steps);
}
/// The slope of log error against log h between N and 2N steps; the reference has order 28.
template <class Embedding>
double order_on(problem_kind kind, Embedding const& how, int steps) {
    static std::array<point, 3> const references{end_of(problem_kind::linear, galerkin<14, gauss>, 20),
                                                 end_of(problem_kind::nonlinear, galerkin<14, gauss>, 20),
                                                 end_of(problem_kind::non_separable, galerkin<14, gauss>, 20)};
    point const& reference = references[static_cast<std::size_t>(kind)];
    auto const error = [&](int n) {
        point const x = end_of(kind, how, n);
        return float50(abs(x.q - reference.q) + abs(x.p - reference.p));
    };
    return testing::order_of(error(steps), error(2 * steps));
}
/// The coarser number of steps for each of the problems: enough to be near the limit, and not so many that 50 digits end.
template <class Embedding>
void check_order(Embedding const& how, double order, std::array<int, 3> const& counts) {
    for (auto const kind : three_problems) {
        CAPTURE(how.name);
        CAPTURE(static_cast<int>(kind));
        CAPTURE(order);
        double const found = order_on(kind, how, counts[static_cast<std::size_t>(kind)]);
        CHECK(found > order - 0.02);
        CHECK(found < order + 0.02);
    }
}

} // namespace

TEST_CASE("order one and theta have order 1, mid-point 2") {
    check_order(order_one, 1, {200, 200, 200});
    check_order(order_one_left, 1, {200, 200, 200});
    check_order(theta<1, 3>, 1, {200, 200, 200});
    check_order(mid_point, 2, {40, 40, 40});
}

TEST_CASE("Galerkin with s Gauss nodes has order 2s") {
    check_order(galerkin<1, gauss>, 2, {40, 40, 40});
    check_order(galerkin<2, gauss>, 4, {20, 20, 20});
    check_order(galerkin<3, gauss>, 6, {16, 16, 16});
    check_order(galerkin<4, gauss>, 8, {16, 16, 16});
    check_order(galerkin<5, gauss>, 10, {12, 12, 12});
    check_order(galerkin<8, gauss>, 16, {8, 20, 32});
}

TEST_CASE("Galerkin with s Lobatto nodes has order 2s - 2") {
    check_order(galerkin<2, lobatto>, 2, {40, 40, 40});
    check_order(galerkin<3, lobatto>, 4, {20, 20, 20});
    check_order(galerkin<4, lobatto>, 6, {16, 16, 16});
    check_order(galerkin<5, lobatto>, 8, {16, 16, 16});
    check_order(galerkin<8, lobatto>, 14, {8, 24, 64});
}

} // namespace embeddings_tests
