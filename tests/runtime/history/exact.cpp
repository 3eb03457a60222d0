// SPDX-License-Identifier: BSL-1.0
// Histories of exact rationals are equal to the sum as it is written, with ==.
#include <doctest/doctest.h>

#include "histories.hpp"

namespace history_exact_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {
template <class G, class Policy>
void equal_at_every_point(Policy const& policy, Q const& alpha, hilger::index_type N) {
    auto const x = random_values<Q>(N);
    auto const expected = sums_as_written<G>(alpha, x);
    auto engine = make_history<G>(policy, alpha, Q(0));
    for (hilger::index_type m = 1; m <= N; ++m) {
        engine.push(x[static_cast<std::size_t>(m - 1)]);
        CHECK(engine.past() == expected[static_cast<std::size_t>(m - 1)]);
    }
}
} // namespace

TEST_CASE("direct and blocks") {
    for (Q const& alpha : {Q(1, 2), Q(-1, 3), Q(1), Q(7, 4)})
        for (hilger::index_type const N : {1, 2, 3, 70}) {
            equal_at_every_point<grunwald_letnikov>(direct{}, alpha, N);
            equal_at_every_point<bdf<2>>(blocks{}, alpha, N);
            equal_at_every_point<trapezoid>(direct{}, alpha, N);
        }
}

TEST_CASE("vectors of rationals") {
    using vector = Eigen::Matrix<Q, 3, 1>;
    auto const x = random_values<vector>(40);
    auto const expected = sums_as_written<bdf<2>>(Q(1, 2), x);
    auto engine = make_history<bdf<2>>(direct{}, Q(1, 2), x[0]);
    for (hilger::index_type m = 1; m <= 40; ++m) {
        auto const k = static_cast<std::size_t>(m - 1);
        engine.push(x[k]);
        CHECK(engine.past() == expected[k]);
    }
}

TEST_CASE("a whole order is a finite difference: exponentials of order 1 and 2 keep their few values and no modes") {
    auto engine = make_history<grunwald_letnikov>(exponentials{}, 2.0, 0.0);
    CHECK(engine.modes() == 0);
    double a = 0, b = 0;
    for (double const x : {3.0, -1.0, 4.0, 0.5, 8.0}) {
        CHECK(engine.past() == -2 * a + b);
        engine.push(x);
        b = a;
        a = x;
    }
    auto of_order_0 = make_history<bdf<2>>(exponentials{}, 0.0, 0.0);
    of_order_0.push(5);
    CHECK(of_order_0.past() == 0);
    auto g1 = make_history<bdf<2>>(exponentials{}, 1.0, 0.0); // (1 - z)(1 - z/3)
    g1.push(3);
    g1.push(6);
    CHECK(g1.past() == doctest::Approx(-8 + 1).epsilon(1e-15));
    g1.push(0);
    g1.push(0);
    CHECK(g1.past() == 0);
}

} // namespace history_exact_tests
