// SPDX-License-Identifier: BSL-1.0
// L. Bourdin, J. Cresson, I. Greff, P. Inizan, "Variational integrator for fractional Euler-Lagrange equations" (2013), in exact rationals
// (h = 1, alpha rational): theorem 1 against the functional (12) that it is about, theorem 4 for a translation, and (28).
#include <doctest/doctest.h>

#include "hilger/boundary/solve.hpp"
#include "hilger/multiprecision.hpp"
#include "noether.hpp"
#include "support/two_sided.hpp"

namespace bourdin_theorems_tests {

using namespace hilger;
using papers::fractional_noether_residual;
using testing::two_sided;

namespace {
using plane = Eigen::Matrix<Q, 2, 1>;
constexpr auto rotation = [](auto const& x) { return plane(-x(1), x(0)); };
constexpr auto translation = [](auto const&) { return plane(Q(1), Q(1)); };
} // namespace

TEST_CASE("theorem 4: a translation is a symmetry of an L that knows the fractional difference of 1, and exactly") {
    auto const T = uniform(Q(0), Q(1), 8);
    Q const alpha(3, 5);
    auto const of_one = tabulate(Delta_minus(alpha)[function_on(T, [](Q) { return Q(1); })]);
    auto const lagrangian = [&](auto const& t, auto const& x, auto const& v) {
        auto const w = of_one(t);
        return ((v(0) - w * x(0)) * (v(0) - w * x(0)) + (v(1) - w * x(1)) * (v(1) - w * x(1))) / 2 + (x(0) - x(1)) * (x(0) - x(1));
    };
    auto const EL = two_sided(lagrangian, alpha, T);
    auto const solution = solve(EL, T, boundary_values{plane(Q(1), Q(1, 2)), plane(Q(-1, 3), Q(1))}, boundary_options{});
    CHECK(solution.residual == 0);
    for (Q const& r : fractional_noether_residual(EL, translation, solution.q)) CHECK(r == 0);
    for (Q const& r : fractional_noether_residual(EL, rotation, solution.q)) CHECK(r != 0);
}

TEST_CASE("(28): the discrete Leibniz formula, in the rationals") {
    auto const T = uniform(Q(-1), Q(2, 7), 6);
    auto const f = function_on(T, [](Q t) { return Q(1 + t * t * t); });
    auto const g = function_on(T, [](Q t) { return Q((2 - t) / (5 + t)); });
    auto const minus_f = Delta_minus(Q(1))[f];
    auto const plus_g = Delta_plus(Q(1))[g];
    for (hilger::index_type k = 1; k < 6; ++k) {
        Q const product = (f[k] * g[k + 1] - f[k - 1] * g[k]) / T.h();
        CHECK(product == minus_f[k] * g[k] - f[k] * plus_g[k]);
    }
}

TEST_CASE("theorem 1: the derivative (16) of the functional in the direction w is h times the sum of the residual times w") {
    using D = jet<Q, 0, 1, 1>;
    auto const T = uniform(Q(1, 3), Q(1), 6);
    auto const lagrangian = [](auto const& t, auto const& x, auto const& v) { return v * v * (1 + x) / 2 + t * x * x * x - v * x; };
    auto const x = function_on(T, [](Q t) { return Q((1 + t * t) / (2 + t)); });
    for (Q const& alpha : {Q(1), Q(2, 3), Q(1, 4)}) {
        auto const rest = two_sided(lagrangian, alpha, T).residual(x);
        auto const v = Delta_minus(alpha)[x];
        for (hilger::index_type i = 0; i <= 6; ++i) {
            auto const w = function_on(T, [&](Q t) { return t == T.point(i) ? Q(1) : Q(0); });
            auto const change = Delta_minus(alpha)[w];
            D total(Q(0));
            for (hilger::index_type k = 1; k <= 6; ++k) {
                auto const along = [](Q const& value, Q const& by) { return D(value) + D::variable(Q(0), 0, {1, 0}) * by; };
                total += T.h() * lagrangian(T.point(k), along(x[k], w[k]), along(v[k], change[k]));
            }
            if (i > 0 and i < 6) CHECK(total.by<0>() == T.h() * rest[i]);
        }
        // and so the solutions are the critical points: exactly, where the equation is linear
        auto const linear = [](auto const& t, auto const& y, auto const& u) { return u * u + t * y * u - y * y / 3 + y; };
        auto const quadratic = two_sided(linear, alpha, T);
        auto const solution = solve(quadratic, T, {.q0 = 2, .qN = -1});
        auto const action_with = [&](hilger::index_type i, Q const& e) {
            return quadratic.action()(function_on(T, [&](Q t) { return Q(solution(t) + (t == T.point(i) ? e : Q(0))); }));
        };
        for (hilger::index_type i = 1; i < 6; ++i) {
            CHECK(action_with(i, Q(1)) == action_with(i, Q(-1))); // the slope of a parabola
            CHECK(action_with(i, Q(1)) != action_with(i, Q(0)));
        }
        CHECK(action_with(6, Q(1)) != action_with(6, Q(-1)));
    }
}

} // namespace bourdin_theorems_tests
