// SPDX-License-Identifier: BSL-1.0
// Fractional differences as operators: their values, semigroup, adjoints with boundary form, and what they refuse.
#include <cmath>

#include <doctest/doctest.h>

#include "hilger/calculus.hpp"
#include "hilger/multiprecision.hpp"
#include "support/orders.hpp"
#include "support/values.hpp"

namespace fractional_operators_tests {

using namespace hilger;

namespace {

template <class Op, class F, class G>
void check_by_parts(Op const& op, F const& f, G const& g) {
    auto const parts = by_parts(op, f, g);
    CHECK(parts.left == parts.interior + parts.boundary);
    CHECK_FALSE(parts.left == parts.interior);
}
auto const T = uniform(Q(0), Q(1), 6);
auto const f = function_on(T, [](Q const& t) { return Q(t * t * t - 4 * t + 3); });
auto const g = function_on(T, [](Q const& t) { return Q(5 / (t + 2) - t); });

} // namespace

TEST_CASE("values are the sums of their definition, at every point") {
    auto const w = first_weights<grunwald_letnikov>(Q(1, 3), 7);
    auto const G = first_weights<bdf<2>>(Q(1, 3), 7);
    auto const minus = Delta_minus_alpha<1, 3>[f];
    auto const plus = Delta_plus_alpha<1, 3>[f];
    auto const run_time = Delta_minus(Q(1, 3))[f];
    for (hilger::index_type k = 0; k <= 6; ++k) {
        Q left(0), right(0);
        for (hilger::index_type n = 0; n <= k; ++n) left += w[static_cast<std::size_t>(n)] * f[k - n];
        for (hilger::index_type n = 0; n <= 6 - k; ++n) right += w[static_cast<std::size_t>(n)] * f[k + n];
        CHECK(minus[k] == left);
        CHECK(plus[k] == right);
        CHECK(run_time[k] == left);
    }
    // G^alpha of Galucio, Deue, Dubois (2), with h = 1/8
    auto const coarse = uniform(0.0, 0.125, 6);
    auto const x = function_on(coarse, [](double t) { return std::sin(t) + 1; });
    auto const y = minus_alpha<bdf<2>, 1, 3>[x];
    for (hilger::index_type k = 0; k <= 6; ++k) {
        double sum = 0;
        for (hilger::index_type n = 0; n <= k; ++n) sum += static_cast<double>(G[static_cast<std::size_t>(n)]) * x[k - n];
        CHECK(std::abs(y[k] - std::pow(1.5 / 0.125, 1.0 / 3) * sum) <= 16 * epsilon<double>() * std::abs(y[k]));
    }
}

TEST_CASE("orders add up; whole orders are local and need the row k = 0") {
    static_assert(Delta_minus_alpha<1, 4> * Delta_minus_alpha<1, 4> == Delta_minus_alpha<1, 2>);
    static_assert(
        std::same_as<decltype(Delta_minus_alpha<1, 2> * Delta_minus_alpha<1, 2>), std::remove_const_t<decltype(Delta_minus_alpha<1, 1>)>>);
    static_assert(minus_alpha<bdf<2>, 1, 3> * minus_alpha<bdf<2>, 2, 3> == minus_alpha<bdf<2>, 1, 1>);
    static_assert(not(Delta_minus_alpha<1, 3> == Delta_minus_alpha<1, 2>));
    static_assert(not(Delta_minus_alpha<1, 2> == minus_alpha<bdf<2>, 1, 2>));
    static_assert(not(Delta_minus_alpha<1, 2> == Delta_plus_alpha<1, 2>));
    auto const twice = Delta_minus_alpha<1, 2>[tabulate(Delta_minus_alpha<1, 2>[f])];
    auto const second = (Delta_minus_alpha<2, 3> * Delta_minus_alpha<2, 3> * Delta_minus_alpha<2, 3>)[f];
    auto const local = Delta_minus[f];
    auto const twice_local = Delta_minus[Delta_minus[f]];
    CHECK(twice[0] == f[0]);
    for (hilger::index_type k = 1; k <= 6; ++k) CHECK(twice[k] == local[k]); // Jimenez, Ober-Bloebaum (22)
    for (hilger::index_type k = 2; k <= 6; ++k) CHECK(second[k] == twice_local[k]);
    auto const run_time = (Delta_minus(Q(1, 4)) * Delta_minus_alpha<1, 4>)[f];
    auto const half = Delta_minus_alpha<1, 2>[f];
    for (hilger::index_type k = 0; k <= 6; ++k) CHECK(run_time[k] == half[k]);
    static_assert(Delta_minus(1) == Delta_minus_alpha<1, 1>);
    // The mirror image at alpha = 1 is -Delta_plus: Bourdin et al. (10)
    auto const mirror = Delta_plus_alpha<1, 1>[f];
    for (hilger::index_type k = 0; k < 6; ++k) CHECK(mirror[k] == -Delta_plus[f][k]);
}

TEST_CASE("integration by parts, with and without boundary values") {
    static_assert(adjoint(Delta_minus_alpha<1, 3>) == Delta_plus_alpha<1, 3>);
    static_assert(adjoint(adjoint(minus_alpha<bdf<3>, 1, 2>)) == minus_alpha<bdf<3>, 1, 2>);
    static_assert(adjoint(Delta_minus_alpha<1, 3> * Delta_minus_alpha<1, 3>) == Delta_plus_alpha<2, 3>);
    check_by_parts(Delta_minus_alpha<1, 3>, f, g);
    check_by_parts(Delta_plus_alpha<3, 4>, f, g);
    check_by_parts(Delta_minus_alpha<1, 1>, f, g);
    check_by_parts(Q(3, 5) * Delta_minus_alpha<1, 2> * Delta_minus_alpha<1, 3>, f, g);
    check_by_parts(Delta_plus_alpha<1, 2> * Delta_minus_alpha<1, 3>, f, g);
    check_by_parts(caputo_minus_alpha<1, 2>, f, g);
    // Lemma 2 of Bourdin et al.: variations that vanish at both ends; and the boundary form by itself
    auto const w = f * function_on(T, [](Q const& t) { return Q(t * (6 - t)); });
    auto const parts = by_parts(Delta_minus_alpha<2, 5>, w, g);
    CHECK(parts.boundary == 0);
    CHECK(parts.left == parts.interior);
    CHECK(boundary_form(Delta_minus_alpha<2, 5>, f, g) == f[6] * g[6] - f[0] * g[0]);
    // Vectors, and a step that is not 1
    auto const S = uniform(float50(1), float50(1) / 8, 9);
    auto const x = function_on(S, [](float50 const& t) { return Eigen::Matrix<float50, 2, 1>(t * t, 1 - t); });
    auto const y = function_on(S, [](float50 const& t) { return Eigen::Matrix<float50, 2, 1>(t, 1 / t); });
    auto const of_vectors = by_parts(minus_alpha<bdf<2>, 1, 2>, x, y);
    CHECK(abs(of_vectors.left - of_vectors.interior - of_vectors.boundary) <= 64 * epsilon<float50>() * abs(of_vectors.left));
}

TEST_CASE("of Riemann and Liouville's kind, and of Caputo's") {
    auto const constant = function_on(T, [](Q const&) { return Q(7); });
    auto const of_constant = caputo_minus_alpha<1, 2>[constant];
    for (hilger::index_type k = 0; k <= 6; ++k) CHECK(of_constant[k] == 0);
    CHECK((Delta_minus_alpha<1, 2>[constant][3]) == 7 * (1 - Q(1, 2) - Q(1, 8) - Q(1, 16)));
    // D^alpha t = t^(1 - alpha) / Gamma(2 - alpha): order 1 of Gruenwald-Letnikov, order 2 of G^alpha away from the start
    auto const error = [](auto const& op, int n) {
        auto const line = function_on(uniform(interval<float50>{0, 1}, n), [](float50 const& t) { return float50(t * t * t); });
        float50 const alpha(float50(1) / 2), exact = 6 / tgamma(float50(4 - alpha));
        return float50(op[line][n] - exact);
    };
    auto const order = [&](auto const& op) { return testing::order_of(error(op, 128), error(op, 256)); };
    CHECK(std::abs(order(Delta_minus_alpha<1, 2>) - 1) < 0.02);
    CHECK(std::abs(order(minus_alpha<bdf<2>, 1, 2>) - 2) < 0.02);
}

TEST_CASE("orders above 1 and below 0") {
    auto const third = Delta_minus_alpha<7, 3>[f];
    auto const twice = Delta_minus_alpha<1, 1>[tabulate(Delta_minus_alpha<4, 3>[f])];
    auto const sums = Delta_minus_alpha<-1, 1>[f];
    auto const back = Delta_minus_alpha<1, 3>[tabulate(Delta_minus_alpha<-1, 3>[f])];
    auto const run_time = (Delta_minus(Q(5, 2)) * Delta_minus(Q(-3, 2)))[f];
    Q sum(0);
    for (hilger::index_type k = 0; k <= 6; ++k) {
        sum += f[k];
        CHECK(third[k] == twice[k]);
        CHECK(sums[k] == sum);
        CHECK(back[k] == f[k]);
        CHECK(run_time[k] == Delta_minus_alpha<1, 1>[f][k]);
    }
    static_assert(Delta_minus_alpha<1, 2> * Delta_minus_alpha<-1, 2> == identity_T);
    static_assert(uniformly(minus_alpha<bdf<2>, 1, 3> * minus_alpha<bdf<2>, -1, 3>) == identity_T);
    static_assert(adjoint(Delta_minus_alpha<-3, 2>) == Delta_plus_alpha<-3, 2>);
    check_by_parts(Delta_minus_alpha<-1, 2>, f, g);
    check_by_parts(Delta_minus_alpha<5, 2>, f, g);
    auto const halves = function_on(uniform(Q(0), Q(1, 2), 4), [](Q const& t) { return t; });
    CHECK((Delta_minus_alpha<-1, 1>[halves][2]) == Q(3, 4));
    CHECK((Delta_minus_alpha<3, 1>[halves][2]) == -4); // halves is 0 before t_0
}

TEST_CASE("orders out of range are refused") {
    CHECK_THROWS_WITH_AS((void)Delta_minus(100.5), "the order of a fractional difference lies in [-100, 100], and this one is 100.5",
                         error::invalid_parameter);
    CHECK_THROWS_AS((void)Delta_plus(-101.0), error::invalid_parameter);
    CHECK_THROWS_AS((void)Delta_plus(2), error::invalid_parameter);
    CHECK_THROWS_AS((void)Delta_plus(std::nan("")), error::invalid_parameter);
    CHECK_THROWS_AS((void)(Delta_minus(75.0) * Delta_minus(75.0)), error::invalid_parameter);
    auto const coarse = uniform(Q(0), Q(1, 2), 4);
    auto const x = function_on(coarse, [](Q const& t) { return t; });
    CHECK_THROWS_WITH_AS((void)(Delta_minus_alpha<1, 2>[x][2]),
                         "in an exact scalar a fractional difference of order 1/2 takes steps of length 1, and this one is 1/2",
                         error::invalid_parameter);
    CHECK((Delta_minus_alpha<1, 1>[x][2]) == 1);
}

} // namespace fractional_operators_tests
