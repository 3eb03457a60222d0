// SPDX-License-Identifier: BSL-1.0
// Variations of fractional actions: the equations are the adjoints', and the action is stationary exactly where they hold.
#include <cmath>
#include <sstream>

#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "support/systems.hpp"
#include "support/values.hpp"

namespace fractional_variation_tests {

using namespace hilger;

namespace {

constexpr unknown q;
constexpr unknown<"y"> y;
constexpr auto q_o = extend[q];
constexpr lagrangian quadratic{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 3 + x * v / 5; }};

std::vector<Q> some_values(int n, int seed) {
    std::vector<Q> values;
    for (int k = 0; k <= n; ++k) values.push_back(Q((k * k * seed + 3 * k + seed) % 17 - 8, k % 5 + 1));
    return values;
}
/// d/d epsilon of S(x + epsilon e_k) for a quadratic S, exactly.
template <class Action>
Q derivative_at(Action const& S, std::vector<Q> x, std::size_t k) {
    x[k] = x[k] + 1;
    Q const after = S(x);
    x[k] = x[k] - 2;
    return (after - S(x)) / 2;
}

} // namespace

TEST_CASE("the fractional functional: (EL_h^alpha) of Bourdin et al.") {
    auto const T = uniform(Q(0), Q(1), 6);
    auto const S = nabla_integral(quadratic(q, Delta_minus_alpha<1, 3>[q]), T);
    auto const EL = variation(S);
    static_assert(EL.force() == identity_T);
    static_assert(EL.momentum() == Delta_plus_alpha<1, 3>);
    auto const x = some_values(6, 4);
    auto const r = EL.residual(function_on(T, x));
    CHECK(r.first() == 1);
    CHECK(r.last() == 5);
    for (hilger::index_type k = 1; k < 6; ++k)
        CHECK(r[k] == derivative_at([&](auto const& z) { return S(function_on(T, z)); }, x, static_cast<std::size_t>(k))); // h = 1
    // S is the sum that (12) says
    Q sum(0);
    auto const v = Delta_minus_alpha<1, 3>[function_on(T, x)];
    for (hilger::index_type k = 1; k <= 6; ++k) sum += quadratic(x[static_cast<std::size_t>(k)], Q(v[k]));
    CHECK(S(function_on(T, x)) == sum);
}

TEST_CASE("the restricted principle damps x, and y in reversed time") {
    auto const T = uniform(Q(0), Q(1), 7);
    Q const rho(3, 7);
    auto const S =
        integral(quadratic(q_o, Delta_o_plus[q_o]), half(T)) - rho * integral(Delta_minus_alpha<1, 4>[q] * Delta_plus_alpha<1, 4>[y], T);
    auto const EL = variation(S);
    static_assert(decltype(EL)::damping() == Delta_minus_alpha<1, 2>);
    auto const a = some_values(7, 5), b = some_values(7, 2);
    auto const added = integral(quadratic(q_o, Delta_o_plus[q_o]), half(T)) +
                       integral(Delta_minus_alpha<1, 4>[q] * Delta_plus_alpha<1, 4>[y], T) * Q(-rho);
    CHECK(added(function_on(T, a), function_on(T, b)) == S(function_on(T, a), function_on(T, b)));
    auto const rx = EL.residual(function_on(T, a));
    auto const ry = EL.reversed_residual(function_on(T, b));
    CHECK(rx.first() == 1);
    CHECK(rx.last() == 6);
    for (std::size_t k = 1; k < 7; ++k) {
        auto both = [&](std::size_t n, Q const& e) { // the same variation for x and y
            auto c = a, d = b;
            c[n] += e, d[n] += e;
            return S(function_on(T, c), function_on(T, d));
        };
        auto const i = static_cast<hilger::index_type>(k);
        CHECK((both(k, 1) - both(k, -1)) / 2 == rx[i] + ry[i]);
    }
    // The damping terms as they are written in (20), at the middle: order 1/2
    auto const D = Delta_minus_alpha<1, 2>[function_on(T, a)];
    auto const without = EL.conservative().residual(function_on(T, a));
    for (hilger::index_type k = 1; k < 7; ++k) CHECK(rx[k] == without[k] - rho * D[k]);
    // y is x in reversed time
    std::vector<Q> const reversed(a.rbegin(), a.rend());
    lagrangian const even{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 3; }};
    auto const EL2 = variation(integral(even(q_o, Delta_o_plus[q_o]), half(T)) -
                               rho * integral(Delta_minus_alpha<1, 4>[q] * Delta_plus_alpha<1, 4>[y], T));
    auto const forwards = EL2.residual(function_on(T, a));
    auto const back = EL2.reversed_residual(function_on(T, reversed));
    for (hilger::index_type k = 1; k < 7; ++k) CHECK(forwards[k] == back[7 - k]);
}

TEST_CASE("damping of order one is local") {
    auto const T = uniform(0.0, 0.25, 9);
    auto const S =
        integral(quadratic(q_o, Delta_o_plus[q_o]), half(T)) - 0.5 * integral(Delta_minus_alpha<1, 2>[q] * Delta_plus_alpha<1, 2>[y], T);
    auto const x = function_on(T, [](double t) { return t * t - 1; });
    auto const r = variation(S).residual(x);
    auto const without = variation(S.conservative).residual(x);
    for (hilger::index_type k = 1; k < 9; ++k) CHECK(r[k] == doctest::Approx(without[k] - 0.5 * Delta_minus[x][k]).epsilon(1e-15));
}

TEST_CASE("fractional equations are written down") {
    auto const T = uniform(0.0, 0.1, 10);
    std::ostringstream text;
    text << variation(nabla_integral(quadratic(q, Delta_minus_alpha<3, 4>[q]), T))
         << variation(nabla_integral(quadratic(q, minus_alpha<bdf<2>, 1, 2>[q]), T))
         << variation(integral(quadratic(q_o, Delta_o_plus[q_o]), half(T)) -
                      0.25 * integral(Delta_minus_alpha<1, 4>[q] * Delta_plus_alpha<1, 4>[y], T));
    CHECK(text.str() == "∂L/∂q(⋆) + Δ₊^(3/4)[∂L/∂v(⋆)] = 0   on T±,   ⋆ = (q, Δ₋^(3/4)[q])\n"
                        "∂L/∂q(⋆) + BDF2₊^(1/2)[∂L/∂v(⋆)] = 0   on T±,   ⋆ = (q, BDF2₋^(1/2)[q])\n"
                        "[∂L/∂q(⋆)]½,₋ − Δ½,₋[∂L/∂v(⋆)] = ρ π⁻¹[Δ₋^(1/2)[q]]   on T½⁻,   ⋆ = (q∘, Δ∘,₊[q∘])\n"
                        "the same of y = ρ π⁻¹[Δ₊^(1/2)[y]],   ρ = 0.25\n");
    CHECK(latex(variation(nabla_integral(quadratic(q, Delta_minus_alpha<1, 3>[q]), T))).find("\\Delta_{+}^{1/3}\\left[") !=
          std::string::npos);
}

TEST_CASE("what is walked and solved are solutions of the equations") {
    auto const T = uniform(0.0, 0.125, 40);
    using testing::pendulum;
    auto const damped = variation(integral(pendulum(q_o, Delta_o_plus[q_o]), half(T)) -
                                  0.5 * integral(Delta_minus_alpha<1, 3>[q] * Delta_plus_alpha<1, 3>[y], T));
    std::vector<double> positions;
    auto const flow = flow_of(damped, direct{}); // (20) as it is printed
    for (auto const& x : flow.along(T, 1.0, 0.5)) positions.push_back(x.q);
    auto const rest = damped.residual(function_on(T, positions));
    for (hilger::index_type k = 1; k < 40; ++k) CHECK(std::abs(rest[k]) <= 64 * epsilon<double>() / (0.125 * 0.125));
    CHECK(positions.back() != positions.front());

    lagrangian const quartic{[](auto const& x, auto const& v) { return v * v / 2 + x * x * x * x / 4 + x * v / 3; }};
    auto const two_sided = variation(nabla_integral(quartic(q, Delta_minus_alpha<3, 4>[q]), T));
    auto const solution = solve(two_sided, T, {.q0 = 0.25, .qN = 1.0});
    CHECK(solution[0] == 0.25);
    CHECK(solution[40] == 1.0);
    auto const left = two_sided.residual(solution);
    for (hilger::index_type k = 1; k < 40; ++k) CHECK(std::abs(left[k]) <= 64 * epsilon<double>() / std::pow(0.125, 1.5));
    // An order known at run time is the same problem.
    auto const again = solve(variation(nabla_integral(quartic(q, Delta_minus(0.75)[q]), T)), T, {.q0 = 0.25, .qN = 1.0});
    for (hilger::index_type k = 0; k <= 40; ++k) CHECK(std::abs(again[k] - solution[k]) <= 64 * epsilon<double>());
}

} // namespace fractional_variation_tests
