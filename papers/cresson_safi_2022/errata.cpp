// SPDX-License-Identifier: BSL-1.0
// Misprints of J. Cresson and R. Safi, "Mid-point embedding of Hamiltonian systems and variational integrators" (2022), sections 1 to 3:
// each printed form is false and the corrected one true, in exact rationals. The table is papers/errata.md.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace cresson_errata_tests {

using namespace hilger;

namespace {

// One scale and two functions in general position are enough to refute; the identity suite proves the corrected forms.
hilger::index_type const N = 5;
Q const h(2, 7);
auto const T = uniform(Q(-1, 3), h, N);
auto const f = function_on(T, [](Q t) { return Q(1 + t + 3 * t * t * t); });
auto const g = function_on(T, [](Q t) { return Q((2 - t) / (5 + t)); });
auto const f_half = function_on(half(T), [](Q t) { return Q(1 + t - t * t); });

constexpr unknown q;
constexpr lagrangian L{[](auto x, auto v) { return v * v / 2 + v * x * x / 3 - x * x * x; }};
auto const S = integral(L(q, Delta_plus[q]), T);

} // namespace

TEST_CASE("(8): Delta_plus of the antiderivative is f on T^+, not on all of T") {
    auto const F = Delta_plus[antiderivative[restrict_to(f, without_last(T))]];
    for (hilger::index_type i = 0; i < N; ++i) CHECK(F[i] == f[i]);
    CHECK_THROWS_AS((void)F[N], error::outside_domain);
}

TEST_CASE("(9): the integral on the right is the nabla integral") {
    Q const left = integral(f * Delta_plus[g], T);
    auto const product = Delta_minus[f] * g;
    Q const inner = weighted_sum<delta_weight>(restrict_to(product, interior(T))); // Delta_minus f does not exist at a
    CHECK(left != boundary(f * g) - inner);                                        // as printed
    CHECK(left == boundary(f * g) - nabla_integral(product, T));                   // corrected
    CHECK(left == f[N - 1] * g[N] - f[0] * g[0] - inner);                          // with the inner sum, the end terms are these
}

TEST_CASE("(13): the derivative of the action is the integral of [-Delta_minus dL/dv + dL/dq] w") {
    auto const v = Delta_plus[f];
    auto const Lq = apply_pointwise([](auto const& x, auto const& y) { return gradient_first(L, x, y); }, f, v);
    auto const Lv = apply_pointwise([](auto const& x, auto const& y) { return gradient_second(L, x, y); }, f, v);
    auto const w = function_on(T, [](Q t) { return t == T.min() or t == T.max() ? Q(0) : Q(1 + t * t); });
    // The Frechet derivative, exactly: the coefficient of e in S(f + e w).
    using D = jet<Q, 0, 1, 1>;
    D total(Q(0));
    for (hilger::index_type i = 0; i < N; ++i) {
        auto const along = [&](hilger::index_type j) { return D(f[j]) + D::variable(Q(0), 0, {1, 0}) * w[j]; };
        total += L(along(i), (along(i + 1) - along(i)) / h) * h;
    }
    Q const derivative = total.by<0>();
    CHECK(derivative != weighted_sum<delta_weight>(-(Delta_minus[Lv] + Lq) * w)); // as printed
    CHECK(derivative == weighted_sum<delta_weight>((Lq - Delta_minus[Lv]) * w));  // corrected, as (14) has it
    CHECK(derivative == weighted_sum<delta_weight>(variation(S).residual(f) * w));
}

TEST_CASE("(16): Delta_minus p is +dL/dq, taken at the velocity and not at the momentum") {
    // The equation solved forward from two values, exactly: dL/dv is linear in v here.
    std::vector<Q> x{Q(1), Q(6, 5)};
    auto const velocity = [&](hilger::index_type i) {
        return Q((x[static_cast<std::size_t>(i) + 1] - x[static_cast<std::size_t>(i)]) / h);
    };
    auto const p = [&](hilger::index_type i) { return gradient_second(L, x[static_cast<std::size_t>(i)], velocity(i)); };
    for (hilger::index_type i = 1; i < N; ++i) { // p_i - p_{i-1} = h dL/dq(x_i, v_i), with dL/dv = v + x^2/3 and dL/dq = 2 v x / 3 - 3 x^2
        Q const at = x[static_cast<std::size_t>(i)];
        Q const v = (p(i - 1) - at * at / 3 - 3 * h * at * at) / (1 - 2 * h * at / 3);
        x.push_back(at + h * v);
    }
    auto const solution = function_on(T, x);
    for (Q const& r : variation(S).residual(solution)) CHECK(r == 0);
    for (hilger::index_type i = 1; i < N; ++i) {
        Q const change = (p(i) - p(i - 1)) / h;
        CHECK(change == gradient_first(L, solution[i], velocity(i)));    // corrected
        CHECK(change != -gradient_first(L, solution[i], p(i)));          // as printed
        CHECK(change != -gradient_first(L, solution[i], velocity(i)));   // the argument alone is not the misprint
        CHECK(change == -hamiltonian(L).by_position(p(i), solution[i])); // (18)
        CHECK(velocity(i) == hamiltonian(L).by_momentum(p(i), solution[i]));
    }
    CHECK(velocity(0) == hamiltonian(L).by_momentum(p(0), solution[0])); // the second line holds on T^+, not only on T^+-
}

TEST_CASE("(19)-(21): with L(y, x) as in (4) and (5), x and y are exchanged, and there is no 1/h") {
    // (4): L(q_{i+1}, q_i) = h L(q_i, (q_{i+1} - q_i)/h), arguments called (y, x).
    auto const step = [](auto const& y, auto const& x) { return h * L(x, (y - x) / h); };
    for (hilger::index_type i = 0; i < N; ++i) {
        Q const v = (f[i + 1] - f[i]) / h;
        Q const p = gradient_second(L, f[i], v);
        CHECK(gradient_first(step, f[i + 1], f[i]) == p);      // (20), (21) corrected: the derivative by y, without 1/h
        CHECK(gradient_second(step, f[i + 1], f[i]) != p / h); // as printed
        CHECK(gradient_first(step, f[i + 1], f[i]) != p / h);
    }
    // (19): -dL/dx(q_{i+1}, q_i) = dL/dy(q_i, q_{i-1}) is the Euler-Lagrange equation (5), so that p_i is well defined along solutions.
    for (hilger::index_type i = 1; i < N; ++i) {
        Q const five = gradient_second(step, f[i + 1], f[i]) + gradient_first(step, f[i], f[i - 1]);
        CHECK(five == h * variation(S).residual(f)[i]);
    }
}

TEST_CASE("(38): the sum on the right runs over the inner points, where Delta_{1/2,-}[f] o sigma_o exists") {
    auto const integrand = pi_half[Delta_h_minus[f_half]] * g;
    CHECK(integrand.first() == 1);
    CHECK_THROWS_AS((void)integrand[0], error::outside_domain);
    Q const left = integral(f_half * (on_half * Delta_o_plus * extend)[g], half(T));
    CHECK(left == f_half[N - 1] * g[N] - f_half[0] * g[0] - weighted_sum<delta_weight>(integrand));
}

TEST_CASE("lemma 3, (40), (41), (101), (103): the end terms carry h/2, not h") {
    Q const left = integral(f_half * (on_half * extend)[g], half(T));
    Q const ends = f_half[N - 1] * g[N] + f_half[0] * g[0];
    auto const inner = pi_half[mean_h_minus[f_half]] * g;
    CHECK(left != weighted_sum<delta_weight>(inner) + h * ends);     // as printed
    CHECK(left == weighted_sum<delta_weight>(inner) + h / 2 * ends); // corrected
}

TEST_CASE("lemma 3 is a uniform statement: on other scales the adjoint of the extension weighs the steps") {
    time_scale<Q> const U{Q(0), Q(1, 3), Q(1), Q(7, 5), Q(2), Q(9, 4)};
    auto const a = function_on(half(U), [](Q t) { return Q(1 + t * t); });
    auto const v = function_on(U, [&](Q t) { return t == U.min() or t == U.max() ? Q(0) : Q(2 + t); });
    Q const left = integral(a * (on_half * extend)[v], half(U));
    CHECK(left != weighted_sum<delta_weight>(pi_half[mean_h_minus[a]] * v));
    CHECK(left == weighted_sum<mean_weight<fraction<1, 2>>>(step_mean[a] * v));
    static_assert(uniformly(step_mean) == pi_half * mean_h_minus and not(step_mean == pi_half * mean_h_minus));
}

TEST_CASE("(56): the equation holds on T_half^-, one instance per inner point of T, and not only on T_half^+-") {
    constexpr auto q_o = extend[q];
    auto const two = uniform(Q(0), h, 2);
    auto const EL = variation(integral(L(q_o, Delta_o_plus[q_o]), half(two)));
    // Two steps: T_half^+- is empty, but the action has one free value and one equation for it.
    CHECK(interior(half(two)).empty());
    CHECK(without_first(half(two)).size() == 1);
    auto const x = function_on(two, [](Q t) { return Q(1 + t); });
    CHECK(EL.residual(x).size() == 1);
    CHECK(EL.residual(x)[1] != 0);
}

TEST_CASE("(36): the integral of f_o over T_half is the trapezoidal rule of f; the mid-point rule is the one of f itself") {
    auto const square = [](Q t) { return Q(t * t); };
    Q const printed = integral(extend[function_on(T, square)], half(T));
    Q trapezoid(0), midpoints(0);
    for (hilger::index_type i = 0; i < N; ++i) {
        trapezoid += h * (square(T.element(i)) + square(T.element(i + 1))) / 2;
        midpoints += h * square(Q((T.element(i) + T.element(i + 1)) / 2));
    }
    CHECK(printed == trapezoid);
    CHECK(printed != midpoints);
    CHECK(integral(function_on(half(T), square), half(T)) == midpoints);
}

TEST_CASE("(47) to (50) exchange the arguments of (64), (65): L_h(x, y) = h L((x + y)/2, (y - x)/h), x the earlier one") {
    auto const printed = [](auto const& a, auto const& b) { return h * L((a + b) / 2, (a - b) / h); }; // (47): L_h(q_{i+1}, q_i)
    auto const corrected = [](auto const& a, auto const& b) { return h * L((a + b) / 2, (b - a) / h); };
    constexpr auto q_o = extend[q];
    auto const EL = variation(integral(L(q_o, Delta_o_plus[q_o]), half(T)));
    auto const of_64 = [](auto const& L_h, hilger::index_type i) {
        return Q(gradient_first(L_h, f[i], f[i + 1]) + gradient_second(L_h, f[i - 1], f[i]));
    };
    for (hilger::index_type i = 1; i < N; ++i) {
        CHECK(of_64(printed, i) != h * EL.residual(f)[i]);
        CHECK(of_64(corrected, i) == h * EL.residual(f)[i]);
    }
}

TEST_CASE("(67), (68), (108), (112): the sum runs over the inner points, where [.]_{1/2,-} o sigma_o exists") {
    constexpr auto q_o = extend[q];
    auto const EL = variation(integral(L(q_o, Delta_o_plus[q_o]), half(T)));
    auto const integrand = EL.residual(f) * g;
    CHECK(integrand.scale() == interior(T));
    CHECK_THROWS_AS((void)integrand[0], error::outside_domain); // the first term of int_a^b . Delta t
}

} // namespace cresson_errata_tests
