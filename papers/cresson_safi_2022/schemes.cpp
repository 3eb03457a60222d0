// SPDX-License-Identifier: BSL-1.0
// J. Cresson and R. Safi, "Mid-point embedding of Hamiltonian systems and variational integrators" (2022), exactly: the order-one theory of
// section 1, and the schemes that sections 3 and 4 say the equations are, (58) to (61), (69) to (72), (78) to (81), (95) and (96).
#include <doctest/doctest.h>

#include "slope.hpp"

namespace cresson_schemes_tests {

using namespace hilger;
using namespace hilger::papers;

namespace {

constexpr unknown q;
constexpr auto q_o = extend[q];
constexpr lagrangian quartic{[](auto const& x, auto const& v) { return v * v / 2 - x * x * x * x / 4; }}; // V = x^4/4
/// dL/dv = 2v + x/3: g(p, q) = (p - q/3)/2
constexpr lagrangian quadratic{[](auto const& x, auto const& v) { return v * v + v * x / 3 - x * x / 2; }};
Q g(Q const& p, Q const& x) { return Q((p - x / 3) / 2); }

Q const h(2, 7);
auto const T = uniform(Q(-1, 3), h, 6);
auto const f = function_on(T, [](Q const& t) { return Q((2 - t) / (5 + t) + t * t); });
Q mid(hilger::index_type i) { return Q((f[i] + f[i + 1]) / 2); }
Q speed(hilger::index_type i) { return Q((f[i + 1] - f[i]) / h); }

} // namespace

TEST_CASE("(3) to (5), (10), (14): the sum of L(q_{i+1}, q_i) is the integral, and (5) is h times the equation") {
    auto const action = integral(quartic(q, Delta_plus[q]), T);
    auto const L_h = [](auto const& y, auto const& x) { return h * quartic(x, (y - x) / h); };
    Q sum(0);
    for (hilger::index_type i = 0; i < 6; ++i) sum += L_h(f[i + 1], f[i]);
    CHECK(action(f) == sum);
    for (hilger::index_type i = 1; i < 6; ++i) {
        CHECK(h * variation(action).residual(f)[i] == gradient_second(L_h, f[i + 1], f[i]) + gradient_first(L_h, f[i], f[i - 1]));
        CHECK(variation(action).residual(f)[i] == -(speed(i) - speed(i - 1)) / h - f[i] * f[i] * f[i]);
    }
}

TEST_CASE("(58) to (61): the next mean velocity from the next mean position, and q from both") {
    auto const at = on_half[extend[f]];
    auto const v = on_half[Delta_o_plus[extend[f]]];
    for (hilger::index_type i = 0; i + 1 < 6; ++i) CHECK(v[i + 1] == 2 / h * at[i + 1] - 2 / h * at[i] - v[i]);
    for (hilger::index_type i = 0; i < 6; ++i) {
        CHECK(at[i] - h / 2 * v[i] == f[i]); // the inverse of the matrix (61)
        CHECK(at[i] + h / 2 * v[i] == f[i + 1]);
    }
}

TEST_CASE("(69) to (72): for L = v^2/2 - V(q) the equation is the second difference and the mean of V' at two mid-points") {
    auto const residual = variation(integral(quartic(q_o, Delta_o_plus[q_o]), half(T))).residual(f);
    CHECK(residual.first() == 1);
    CHECK(residual.last() == 5);
    auto const slope = [](Q const& x) { return Q(x * x * x); };
    for (hilger::index_type i = 1; i < 6; ++i)
        CHECK(residual[i] == -(f[i + 1] - 2 * f[i] + f[i - 1]) / (h * h) - (slope(mid(i)) + slope(mid(i - 1))) / 2);
}

TEST_CASE("(78) to (81), definition 13: the Hamiltonian function of L, and its derivatives") {
    hamiltonian const H(quadratic);
    for (hilger::index_type i = 0; i < 6; ++i) {
        Q const p = f[i], x = speed(i), v = g(p, x);
        CHECK(gradient_second(quadratic, x, v) == p);                   // (79)
        CHECK(H(p, x) == p * v - quadratic(x, v));                      // (81), (93)
        CHECK(H.by_momentum(p, x) == v);                                // (80), first line
        CHECK(H.by_position(p, x) == -gradient_first(quadratic, x, v)); // second line
    }
}

TEST_CASE("(95), (96): the steps of the mid-point flow") {
    auto const [x, p] = trajectory_of(embed(quadratic, mid_point), T, initial_velocity<Q>{Q(1), Q(1, 2)});
    for (hilger::index_type i = 0; i < 6; ++i) {
        Q const middle = (x[i] + x[i + 1]) / 2, v = (x[i + 1] - x[i]) / h;
        CHECK(p[i + 1] == p[i] + h * gradient_first(quadratic, middle, v));
        CHECK(x[i + 1] == x[i] + h * g(Q((p[i] + p[i + 1]) / 2), middle));
    }
}

} // namespace cresson_schemes_tests
