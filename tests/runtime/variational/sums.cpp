// SPDX-License-Identifier: BSL-1.0
// Sums of actions that read T in different ways: what their equation is, and that what steps solves it.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "support/orders.hpp"

namespace sums_tests {

using namespace hilger;

namespace {

constexpr unknown q;
constexpr auto q_o = extend[q];
constexpr auto square = [](auto const& x) {
    if constexpr (requires { x.squaredNorm(); })
        return x.squaredNorm();
    else
        return x * x;
};
constexpr auto first_of = [](auto const& x) {
    if constexpr (requires { x(0); })
        return x(0);
    else
        return x;
};
constexpr lagrangian stiff{[](auto const& x, auto const& v) { return square(v) / 2 - 8 * square(x); }};
constexpr lagrangian gentle{[](auto const& x, auto const&) { return cos(first_of(x)) - square(x) / 8; }};
constexpr lagrangian linear{[](auto const& x, auto const& v) { return square(x) / 3 + first_of(x) * first_of(v) / 5; }};
constexpr lagrangian kinetic{[](auto const&, auto const& v) { return square(v) / 2; }};
constexpr lagrangian pendulum{[](auto const& x, auto const& v) { return v * v / 2 + cos(x); }};

/// L by the mid-point rule, U by the trapezoid rule.
template <class L, class U, class T>
auto implicit_explicit(L const& l, U const& u, T const& t) {
    using S = typename T::scalar_type;
    return integral(l(q_o, Delta_o_plus[q_o]), half(t)) +
           S(1) / S(2) * (integral(u(q, Delta_plus[q]), t) + nabla_integral(u(q, Delta_minus[q]), t));
}
/// Its two parts exchanged.
template <class L, class U, class T>
auto explicit_implicit(L const& l, U const& u, T const& t) {
    using S = typename T::scalar_type;
    return S(1) / S(2) * (nabla_integral(u(q, Delta_minus[q]), t) + integral(u(q, Delta_plus[q]), t)) +
           integral(l(q_o, Delta_o_plus[q_o]), half(t));
}
template <class V>
V some_state(double c) {
    if constexpr (requires { V().size(); }) {
        V x = V::Zero(V::SizeAtCompileTime == Eigen::Dynamic ? 7 : V::SizeAtCompileTime);
        for (Eigen::Index k = 0; k < x.size(); ++k) x(k) = c / double(k + 1);
        return x;
    } else
        return V(c);
}
time_scale<double> uneven() {
    std::vector<double> t;
    for (int i = 0; i <= 60; ++i) t.push_back(0.1 * i + 0.03 * std::sin(double(i)));
    return time_scale(std::move(t));
}

} // namespace

TEST_CASE("a potential by the trapezoid rule is Stoermer and Verlet's method, exactly") {
    auto const T = uniform(Q(0), Q(1, 10), 6);
    constexpr lagrangian U{[](auto const& x, auto const&) { return -2 * x * x + x / 3; }};
    auto const S =
        integral(kinetic(q, Delta_plus[q]), T) + Q(1, 2) * (integral(U(q, Delta_plus[q]), T) + nabla_integral(U(q, Delta_minus[q]), T));
    auto const x = solve(variation(S), T, {.q0 = 1, .v0 = Q(1, 2)});
    constexpr lagrangian whole{[](auto const& y, auto const& v) { return v * v / 2 - 2 * y * y + y / 3; }};
    index_type i = 0;
    for (auto const& y : stoermer_verlet(whole).along(T, initial_velocity<Q>{1, Q(1, 2)})) CHECK(y.q == x[i++]);
    CHECK(i == 7);
    for (Q const& r : variation(S).residual(x)) CHECK(r == 0);
}

TEST_CASE_TEMPLATE("what steps solves the equation, in states of all kinds, on equal and other steps", V, double, Eigen::Vector3d,
                   Eigen::VectorXd) {
    initial_velocity<V> const from{some_state<V>(0.8), some_state<V>(-0.5)};
    auto const holds = [&](auto const& S) {
        auto const& T = S.scale();
        auto const EL = variation(S);
        auto const x = solve(EL, T, from);
        // |p|/h, and eight times |q| for each end of a step
        double const bound = 64 * epsilon<double>() * (4 / 0.05 + 32);
        CHECK(largest_residual(EL, x) <= bound);
        CHECK(largest_residual(flow_of(EL).along(T, from)) <= bound);
        CHECK(magnitude(V(x[T.steps()] - x[0])) > 0.01);
        // the same from two positions, and between the ends of them
        if constexpr (not std::same_as<V, Eigen::Vector3d>) {
            auto const again = solve(EL, T, initial_positions<V>{x[0], x[1]});
            auto const between = solve(EL, T, boundary_values<V>{x[0], x[T.steps()]});
            auto const marched = solve(EL, T, std::vector<V>{x[0], x[1]});
            for (index_type i : {index_type(2), T.steps() / 2, T.steps() - 1}) {
                CHECK(magnitude(V(again[i] - x[i])) <= 1e-12);
                CHECK(magnitude(V(between[i] - x[i])) <= 1e-11);
                CHECK(magnitude(V(marched[i] - x[i])) <= 1e-11);
            }
        }
    };
    auto const T = uniform(0.0, 0.125, 40);
    SUBCASE("implicit and explicit, on uneven steps") { holds(implicit_explicit(stiff, gentle, uneven())); }
    SUBCASE("exchanged") { holds(explicit_implicit(stiff, gentle, T)); }
    SUBCASE("three implicit ways") {
        holds(integral(stiff(q_o, Delta_o_plus[q_o]), half(T)) + 0.5 * nabla_integral(linear(q, Delta_minus[q]), T) -
              0.25 *
                  integral(linear(on_lambda<1, 3>[extend_lambda<1, 3>[q]], (pi_lambda_inverse<1, 3> * Delta_plus)[q]), at_lambda<1, 3>(T)));
    }
}

TEST_CASE("steps are symplectic, and their own adjoints, exactly in the rationals") {
    auto const T = uniform(Q(0), Q(1, 10), 2);
    auto const flow = flow_of(variation(implicit_explicit(stiff, linear, T)));
    state<Q, Q> const x{Q(0), Q(3, 4), Q(-1, 3)};
    auto const M = jacobian_of_step(flow, x, Q(1, 10));
    CHECK(symplecticity_error(M) == 0);
    CHECK(M(0, 1) != 0);
    auto const there = flow.step(x, Q(1, 10));
    auto const same = adjoint(flow).step(x, Q(1, 10));
    CHECK(same.q == there.q);
    CHECK(same.p == there.p);
    auto const back = adjoint(flow).step(there, Q(-1, 10));
    CHECK(back.q == x.q);
    CHECK(back.p == x.p);
}

TEST_CASE("order two, and four by composition, of actions of the time and of velocities too") {
    constexpr lagrangian driven{[](auto const& t, auto const& x, auto const& v) { return x * sin(t) / 2 + x * x * v * v / 8; }};
    auto const T = uniform(interval<float50>{0, 1}, 8);
    auto const S = implicit_explicit(pendulum, driven, T);
    auto const flow = flow_of(variation(S));
    auto const finest = compose(suzuki<4>, flow);
    float50 const reference = testing::at_one(compose(kahan_li<8>, flow), 256).q;
    CHECK(std::abs(testing::fitted_order(flow, 64, reference) - 2) <= 0.02);
    CHECK(std::abs(testing::fitted_order(finest, 64, reference) - 4) <= 0.02);
    auto const path = finest.along(uniform(0.0, 0.1, 20), 1.0, 0.0);
    CHECK(largest_residual(path) <= 64 * epsilon<double>() / 0.1);
}

TEST_CASE("a force stands beside the first Lagrangian; momenta and energies are those of the sum") {
    auto const T = uniform(0.0, 0.0625, 64);
    auto const EL = variation(implicit_explicit(pendulum, gentle, T));
    auto const force = [](auto const& x, auto const& v) { return -v / 4 + x / 8; };
    auto const x = solve(EL, T, {.q0 = 1.0, .v0 = 0.5}, force);
    CHECK(largest_residual(EL, x, force) <= 64 * epsilon<double>() / T.h());
    CHECK(largest_residual(EL, x) > 0.01);
    CHECK(largest_residual(flow_of(EL, force).along(T, initial_velocity<double>{1.0, 0.5})) <= 64 * epsilon<double>() / T.h());
    // beside dL/dq of the first, at its middle
    auto const alone = solve(variation(integral(pendulum(q_o, Delta_o_plus[q_o]), half(T))), T, {.q0 = 1.0, .v0 = 0.5}, force);
    auto const nothing = [](auto const& y, auto const&) { return y - y; };
    auto const same = solve(variation(implicit_explicit(pendulum, lagrangian{nothing}, T)), T, {.q0 = 1.0, .v0 = 0.5}, force);
    for (index_type i = 0; i <= 64; ++i) CHECK(std::abs(alone[i] - same[i]) <= 1e-13);
    auto const flow = flow_of(EL);
    auto const carried = record(embed(flow.mechanics(), flow.embedding(), compensated).along(T, 1.0, 0.5));
    CHECK(largest_residual(flow, carried.positions()) <= 64 * epsilon<double>() / T.h());
    CHECK(flow.momentum(0.0, 1.0, 0.5) == 0.5);
    CHECK(drift_along(flow.along(T, 1.0, 0.5), energy(flow.mechanics().lagrangian)).largest < T.h() * T.h());
}

TEST_CASE("with points inside the steps, where all parts read the same ones") {
    auto const T = uniform(0.0, 0.125, 40);
    auto const at_gauss = equation_of(embed(stiff, galerkin<2, gauss>), T).action();
    constexpr auto by_simpson =
        make_embedding<step_weight>(polynomial_value<2, lobatto, 3>{}, polynomial_slope<2, lobatto, 3>{}, "Simpson's rule");
    auto const EL = variation(at_gauss + equation_of(embed(gentle, by_simpson), T).action());
    auto const x = solve(EL, T, {.q0 = 0.8, .v0 = -0.5});
    CHECK(x.size() == 81);
    double const bound = 64 * epsilon<double>() * (4 / 0.125 + 32) * 4;
    CHECK(largest_residual(EL, x) <= bound);
    CHECK(largest_residual(flow_of(EL).along(T, 0.8, -0.5)) <= bound);
    auto const between = solve(EL, T, boundary_values<double>{x[0], x[80]});
    CHECK(std::abs(between[41] - x[41]) <= 1e-12);
    std::ostringstream out;
    out << EL;
    CHECK(out.str().starts_with(
        "Π₂*[∂L₁/∂q(⋆₁)] + Π₂′*[∂L₁/∂v(⋆₁)] + Π₂*[∂L₂/∂q(⋆₂)] + Π₂′*[∂L₂/∂v(⋆₂)] = 0   on T∘±,   ⋆₁ = (Π₂[q], Π₂′[q])"));
}

TEST_CASE_TEMPLATE("between the points, in states of every kind", V, double, Eigen::Vector2d, Eigen::VectorXd) {
    auto const T = uniform(0.0, 0.0625, 48);
    auto const path = flow_of(variation(implicit_explicit(stiff, gentle, T))).along(T, some_state<V>(0.5), some_state<V>(-1));
    auto const dense = dense_output(path);
    double const h = T.h();
    double largest = 0;
    state<double, V> before = *path.begin();
    for (auto const& x : path) {
        if (x.t > 0) {
            auto const y = path.method().step(before, h / 2);
            largest = std::max({largest, magnitude(V(dense(y.t).q - y.q)), magnitude(V(dense(y.t).p - y.p))});
            V const slope = slopes_at(path.method().mechanics(), x).q; // of the sum: dL/dv = v
            CHECK(magnitude(V(slope - x.p)) <= 8 * epsilon<double>() * magnitude(x.p));
        }
        before = x;
    }
    CHECK(largest <= 16 * epsilon<double>());
    index_type crossings = 0;
    for (auto const& x : events(path, [](auto const& y) { return first_of(y.q); })) {
        CHECK(std::abs(first_of(x.q)) <= 8 * epsilon<double>());
        ++crossings;
    }
    CHECK(crossings == 4); // of a frequency between 4 and 5, over 3, from a phase of 0.46
}

TEST_CASE("what is written down") {
    auto const T = uniform(0.0, 0.1, 4);
    std::ostringstream out;
    out << variation(implicit_explicit(pendulum, gentle, T));
    CHECK(out.str() ==
          "π[[∂L₁/∂q(⋆₁)]½,₋] − π[Δ½,₋[∂L₁/∂v(⋆₁)]] + ∂L₂/∂q(⋆₂) − Δ₋[∂L₂/∂v(⋆₂)] + ∂L₃/∂q(⋆₃) − Δ₊[∂L₃/∂v(⋆₃)] = 0   on T±,   "
          "⋆₁ = (q∘, Δ∘,₊[q∘]),   ⋆₂ = (q, Δ₊[q]),   ⋆₃ = (q, Δ₋[q])\n");
    auto const tex = latex(variation(integral(pendulum(q, Delta_plus[q]), T) + nabla_integral(gentle(q, Delta_minus[q]), T)));
    CHECK(tex ==
          "\\begin{aligned}\n  \\frac{\\partial L_{1}}{\\partial q}(\\star_{1}) - \\Delta_{-}\\left[\\frac{\\partial L_{1}}{\\partial "
          "v}(\\star_{1})\\right] + \\frac{\\partial L_{2}}{\\partial q}(\\star_{2}) - \\Delta_{+}\\left[\\frac{\\partial "
          "L_{2}}{\\partial v}(\\star_{2})\\right] &= 0, && t \\in \\mathbb{T}^{\\pm}, \\quad \\star_{1} = (q, "
          "\\Delta_{+}\\left[q\\right]), \\quad \\star_{2} = (q, \\Delta_{-}\\left[q\\right])\n\\end{aligned}\n");
}

TEST_CASE("actions of one kind are one action, and their scale is one") {
    auto const T = uniform(0.0, 0.1, 4);
    auto const S = integral(pendulum(q, Delta_plus[q]), T);
    auto const doubled = variation(2 * S - S + S);
    static_assert(not hilger::detail::is_action_sum<std::remove_cvref_t<decltype(doubled.action())>>);
    auto const x = function_on(T, [](double t) { return 1 - t * t; });
    for (index_type i = 1; i < 4; ++i)
        CHECK(std::abs(doubled.residual(x)[i] - 2 * variation(S).residual(x)[i]) <= 16 * epsilon<double>() / 0.1);
    CHECK((-S)(x) == -S(x));
    CHECK(std::abs((S - 0.5 * S)(x)-S(x) / 2) <= 4 * epsilon<double>());
    CHECK_THROWS_WITH_AS(S + nabla_integral(pendulum(q, Delta_minus[q]), uniform(0.0, 0.2, 4)),
                         doctest::Contains("actions add up on one scale"), error::mismatch);
}

} // namespace sums_tests
