// SPDX-License-Identifier: BSL-1.0
// The discrete Euler-Lagrange equation against the definition of a critical point: the derivative of the action along every variation
// of one inner value, exactly, in dual numbers over the rationals.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "runtime/embedding/radau.hpp"

namespace variation_tests {

using namespace hilger;

namespace {

using D = jet<Q, 0, 1, 1>;

// Polynomial, so that rationals stay rational; neither separable nor quadratic.
constexpr auto scalar_L = [](auto const& x, auto const& v) { return v * v / 2 + v * x * x / 3 - x * x * x / 5 + v * v * x / 7; };
constexpr auto plane_L = [](auto const& x, auto const& v) {
    return v.dot(v) / 2 + x(0) * v(1) - x(1) * x(1) * v(0) / 3 - x.dot(x) * x(0) / 5;
};

template <class V>
V some_value(int i, int component) {
    return V(3 * i * i - 2 * i + component) / V(5 + i + component);
}

/// d/de S(x + e e_k), exactly, for scalar values.
template <class Action>
Q along_variation(Action const& S, std::vector<Q> const& x, hilger::index_type k) {
    std::vector<D> moved;
    for (std::size_t i = 0; i < x.size(); ++i)
        moved.push_back(static_cast<hilger::index_type>(i) == k ? D::variable(x[i], 0, {1, 0}) : D(x[i]));
    auto const& root = S.scale();
    auto const T = derived_scale(root, domain<nodes>{});
    auto const f = function_on(root, [&](Q const& t) { return moved[static_cast<std::size_t>(T.number_of(t))]; });
    return D(S(f)).by<0>();
}

/// The residual at t_k times the weight of t_k in the sum that the equation is written in is the derivative of the action.
template <class Weight, class Action>
void is_the_derivative_of(Action const& S) {
    std::vector<Q> x;
    auto const& T = S.scale();
    for (int i = 0; i <= T.steps(); ++i) x.push_back(some_value<Q>(i, 1));
    auto const f = function_on(T, x);
    auto const residual = variation(S).residual(f);
    REQUIRE(residual.first() == 1);
    REQUIRE(residual.last() == T.steps() - 1);
    for (hilger::index_type k = 1; k < T.steps(); ++k) {
        CAPTURE(k);
        CHECK(residual[k] * weight_at<Weight>(f, k) == along_variation(S, x, k));
    }
}

constexpr unknown q;
constexpr auto q_o = extend[q];
constexpr auto q_third = extend_lambda<1, 3>[q];
constexpr auto velocity_third = (pi_lambda_inverse<1, 3> * Delta_plus)[q];
using trapezoid_rule = mean_weight<fraction<1, 2>>;

} // namespace

TEST_CASE_TEMPLATE("the residual is the derivative of the action on any scale", Scale, uniform_scale<Q>, time_scale<Q>) {
    auto const T = [] {
        if constexpr (Scale::is_uniform)
            return uniform(Q(-1, 3), Q(2, 7), 6);
        else
            return time_scale<Q>{Q(0), Q(1, 3), Q(1), Q(7, 5), Q(2), Q(9, 4), Q(3)};
    }();
    constexpr lagrangian L{scalar_L};
    SUBCASE("order one") { is_the_derivative_of<delta_weight>(integral(L(q, Delta_plus[q]), T)); }
    SUBCASE("mid-point") { is_the_derivative_of<trapezoid_rule>(integral(L(q_o, Delta_o_plus[q_o]), half(T))); }
    SUBCASE("lambda = 1/3") {
        is_the_derivative_of<mean_weight<fraction<1, 3>>>(integral(L(on_lambda<1, 3>[q_third], velocity_third), at_lambda<1, 3>(T)));
    }
    SUBCASE("lambda = 1/3, velocity as the derivative of the extension") {
        auto const v = derivative<joined<fraction<1, 3>>, side::plus>{}[q_third];
        is_the_derivative_of<mean_weight<fraction<1, 3>>>(integral(L(q_third, v), at_lambda<1, 3>(T)));
    }
    SUBCASE("lambda known at run time") {
        Q const lambda(2, 7);
        auto const q_lambda = extend_at(lambda)[q];
        auto const v = derivative<joined<run_time<Q>>, side::plus>{}[q_lambda];
        is_the_derivative_of<delta_weight>(integral(L(q_lambda, v), at_lambda(T, lambda))); // the Delta sum: see natural_weight
    }
    SUBCASE("sums of actions that read T in different ways, in the weights of the first") {
        constexpr lagrangian M{[](auto const& x, auto const& v) { return x * x * x / 4 - v * v / 3 + x * v; }};
        auto const middle = integral(L(q_o, Delta_o_plus[q_o]), half(T));
        auto const left = integral(M(q, Delta_plus[q]), T);
        auto const right = nabla_integral(M(q, Delta_minus[q]), T);
        is_the_derivative_of<trapezoid_rule>(middle - Q(1, 3) * (left + right));
        is_the_derivative_of<delta_weight>(Q(1, 3) * left + (right - middle));
        is_the_derivative_of<delta_weight>(-right + left); // the weights of the operator q
        auto const reach_of_two = integral(M(q, (fraction<1, 2>{} * (Delta_plus + Delta_minus))[q]), T);
        std::vector<Q> x;
        for (int i = 0; i <= T.steps(); ++i) x.push_back(some_value<Q>(i, 1));
        auto const f = function_on(T, x);
        auto const both = variation(left + reach_of_two).residual(f);
        auto const one = variation(left).residual(f);
        auto const other = variation(reach_of_two).residual(f);
        REQUIRE(both.first() == other.first());
        REQUIRE(both.last() == other.last());
        for (hilger::index_type k = both.first(); k <= both.last(); ++k) CHECK(both[k] == one[k] + other[k]);
    }
    SUBCASE("an integrand on T_o is read on T_half") {
        auto const S = integral(L(q_o, Delta_o_plus[q_o]), half(T));
        auto const same = integral(L(on_half[q_o], (pi_inverse * Delta_plus)[q]), half(T));
        auto const f = function_on(T, [](Q t) { return Q(t * t - t); });
        CHECK(S(f) == same(f));
        CHECK(S(f) != 0);
    }
}

TEST_CASE("vectors: the residual of a plane system is the derivative of its action") {
    using V = Eigen::Matrix<Q, 2, 1>;
    time_scale<Q> const T{Q(0), Q(1, 3), Q(1), Q(7, 5), Q(2)};
    auto const S = integral(lagrangian{plane_L}(q_o, Delta_o_plus[q_o]), half(T));
    std::vector<V> x;
    for (int i = 0; i <= T.steps(); ++i) x.push_back(V(some_value<Q>(i, 0), some_value<Q>(i, 2)));
    auto const f = function_on(T, x);
    auto const residual = variation(S).residual(f);
    for (hilger::index_type k = 1; k < T.steps(); ++k)
        for (int c = 0; c < 2; ++c) {
            std::vector<Eigen::Matrix<D, 2, 1>> moved;
            for (std::size_t i = 0; i < x.size(); ++i) moved.push_back(x[i].cast<D>());
            moved[static_cast<std::size_t>(k)](c) = D::variable(x[static_cast<std::size_t>(k)](c), 0, {1, 0});
            auto const g = function_on(T, [&](Q const& t) { return moved[static_cast<std::size_t>(T.number_of(t))]; });
            CHECK(residual[k](c) * weight_at<trapezoid_rule>(f, k) == D(S(g)).by<0>());
        }
}

TEST_CASE("at the nodes of a quadrature weights differ on a uniform T too") {
    using B = quadrature_nodes<testing::own_radau, 2>;
    constexpr unknown<"q", subdivided<2>> x;
    constexpr lagrangian L{[](auto const& y, auto const& v) { return v * v / 2 - y * y / 3 + y * v / 5 + y; }};
    auto const T = uniform(Q(0), Q(1), 4);
    auto const S = integral(
        L((shift<B, side::plus>{} * polynomial_value<2, testing::own_radau, 2>{})[x], polynomial_slope<2, testing::own_radau, 2>{}[x]),
        at_nodes<testing::own_radau, 2>(T));
    std::vector<Q> values;
    for (int i = 0; i <= 8; ++i) values.push_back(some_value<Q>(i, 1));
    auto const residual = variation(S).residual(function_on(subdivide<2>(T), values));
    for (hilger::index_type i = residual.first(); i <= residual.last(); ++i) { // S is quadratic: a central difference is exact
        auto up = values, down = values;
        up[static_cast<std::size_t>(i)] += 1;
        down[static_cast<std::size_t>(i)] -= 1;
        CHECK(residual[i] / 2 == (S(function_on(subdivide<2>(T), up)) - S(function_on(subdivide<2>(T), down))) / 2); // h/2 = 1/2
    }
}

TEST_CASE("the operators of the equation are those of the papers, by type") {
    constexpr lagrangian L{scalar_L};
    constexpr auto T = uniform(0.0, 0.1, 10);
    constexpr auto order_one_EL = variation(integral(L(q, Delta_plus[q]), T));
    static_assert(order_one_EL.force() == identity_T and order_one_EL.momentum() == -Delta_minus); // S (14)
    constexpr auto midpoint_EL = variation(integral(L(q_o, Delta_o_plus[q_o]), half(T)));
    static_assert(midpoint_EL.force() == mean_h_minus and midpoint_EL.momentum() == -Delta_h_minus); // S (56)
    static_assert(not(midpoint_EL.force() == mean_h_plus) and not(midpoint_EL.momentum() == Delta_h_minus));
    static_assert(not(order_one_EL.force() == rho) and not(order_one_EL.momentum() == -Delta_plus));
    static_assert(mid_point.position == theta<1, 2>.position and mid_point.velocity == theta<1, 2>.velocity);
    static_assert(mid_point.velocity == on_half * Delta_o_plus * extend);
    CHECK(midpoint_EL.action().T.steps() == 10);
}

TEST_CASE("an end that the integral does not count is not read") {
    auto const T = uniform(Q(-1, 3), Q(2, 7), 6);
    constexpr lagrangian L{scalar_L};
    auto const check = [&](auto const& S, hilger::index_type first, hilger::index_type last) {
        std::vector<Q> x;
        for (int i = 0; i <= 6; ++i) x.push_back(some_value<Q>(i, 1));
        auto const residual = variation(S).residual(function_on(T, x));
        CHECK(residual.first() == first);
        CHECK(residual.last() == last);
        for (hilger::index_type k = first; k <= last; ++k) CHECK(residual[k] * T.h() == along_variation(S, x, k));
    };
    check(integral(L(q, Delta_minus[q]), T), 1, 4); // the row at t_5 would read dL/dv at t_6, which has no weight
    check(nabla_integral(L(q, Delta_plus[q]), T), 2, 5);
    check(integral(L(rho[q], Delta_plus[q]), T), 2, 4);
}

TEST_CASE("the mid-point equation is Wendlandt and Marsden's, S (64)") {
    auto const T = uniform(Q(0), Q(1, 4), 4);
    auto const EL = variation(integral(lagrangian{scalar_L}(q_o, Delta_o_plus[q_o]), half(T)));
    Q const h = T.h();
    auto const L_h = [&](auto const& x, auto const& y) { return scalar_L((x + y) / 2, (y - x) / h) * h; };
    auto const f = function_on(T, [](Q t) { return Q(1 + t - 2 * t * t); });
    for (hilger::index_type i = 1; i < 4; ++i)
        CHECK(h * EL.residual(f)[i] == gradient_first(L_h, f[i], f[i + 1]) + gradient_second(L_h, f[i - 1], f[i]));
}

TEST_CASE("equations are printed as the papers write them") {
    constexpr lagrangian L{scalar_L};
    auto const printed = [](auto const& x) {
        std::ostringstream out;
        out << x;
        return out.str();
    };
    auto const T = uniform(0.0, 0.1, 10);
    auto const mid = variation(integral(L(q_o, Delta_o_plus[q_o]), half(T)));
    CHECK(printed(mid) == "[∂L/∂q(⋆)]½,₋ − Δ½,₋[∂L/∂v(⋆)] = 0   on T½⁻,   ⋆ = (q∘, Δ∘,₊[q∘])\n");
    CHECK(printed(hamiltonian_form(mid)) == "Δ½,₋[p∘] = [−∂H/∂q(p∘, q∘)]½,₋   on T½⁻\nΔ∘,₊[q∘] = ∂H/∂p(p∘, q∘)   on T½,   p∘ = ∂L/∂v(⋆)\n");
    auto const right = variation(integral(L(q, Delta_plus[q]), T));
    CHECK(printed(right) == "∂L/∂q(⋆) − Δ₋[∂L/∂v(⋆)] = 0   on T±,   ⋆ = (q, Δ₊[q])\n");
    CHECK(printed(hamiltonian_form(right)) == "Δ₋[p] = −∂H/∂q(p, q)   on T±\nΔ₊[q] = ∂H/∂p(p, q)   on T⁺,   p = ∂L/∂v(⋆)\n");
    CHECK(latex(right).find("\\frac{\\partial L}{\\partial q}(\\star) - \\Delta_{-}\\left[") != std::string::npos);
    time_scale<double> const U{0, 1, 3, 4};
    auto const uneven = variation(integral(L(q, Delta_plus[q]), U));
    CHECK(printed(uneven) == "∂L/∂q(⋆) − (ν/μ) Δ₋[∂L/∂v(⋆)] = 0   on T±,   ⋆ = (q, Δ₊[q])\n");
}

TEST_CASE("the equation has a row for every point that a position in the middle leaves free, whichever sum it is of") {
    time_scale<Q> const T{Q(0), Q(1), Q(3), Q(4), Q(6), Q(13, 2)};
    constexpr lagrangian L{scalar_L};
    constexpr auto half = fraction<1, 2>{};
    constexpr auto third = fraction<1, 3>{};
    is_the_derivative_of<delta_weight>(nabla_integral(L((half * (identity_T + rho))[q], Delta_minus[q]), T));
    is_the_derivative_of<delta_weight>(integral(L((half * (identity_T + sigma))[q], Delta_plus[q]), T));
    is_the_derivative_of<delta_weight>(nabla_integral(L((third * identity_T + third * (rho + identity_T))[q], Delta_minus[q]), T));
    is_the_derivative_of<delta_weight>(nabla_integral(L((Q(1, 3) * (rho + identity_T) + third * rho)[q], Delta_minus[q]), T));
    // Two steps back: two values are given at each end.
    auto const wide = nabla_integral(L((third * (identity_T + rho + rho * rho))[q], Delta_minus[q]), T);
    std::vector<Q> const x{Q(1), Q(-2, 3), Q(5, 2), Q(0), Q(7, 5), Q(100)};
    auto const residual = variation(wide).residual(function_on(T, x));
    CHECK(residual.first() == 2);
    CHECK(residual.last() == 3);
    for (hilger::index_type const k : {2, 3}) CHECK(residual[k] * weight_at<delta_weight>(residual, k) == along_variation(wide, x, k));
    // The straight line joins two ends of a free particle.
    constexpr lagrangian free{[](auto const&, auto const& v) { return v * v / 2; }};
    auto const line =
        solve(variation(nabla_integral(free((half * (identity_T + rho))[q], Delta_minus[q]), T)), T, boundary_values{Q(0), Q(13, 2)});
    for (hilger::index_type k = 0; k <= 5; ++k) CHECK(line[k] == T.element(k));
}

TEST_CASE("the equation of a sum of actions is the sum of their equations, on uneven steps and with the time") {
    time_scale<Q> const T{Q(0), Q(1), Q(3), Q(4), Q(6), Q(13, 2)};
    auto const kinetic = [](auto const&, auto const& v) { return v * v / 2 + v * v * v / 9; };
    auto const potential = [](auto const& t, auto const& x, auto const&) { return t * x * x / 3 - x * x * x / 5; };
    constexpr auto q_o = extend[q];
    auto const S = integral(lagrangian{kinetic}(q_o, Delta_o_plus[q_o]), half(T));
    auto const timed =
        integral(lagrangian{[&](auto const&, auto const& x, auto const& v) { return kinetic(x, v); }}(q_o, Delta_o_plus[q_o]), half(T));
    auto const R = integral(lagrangian{potential}(q_o, Delta_o_plus[q_o]), half(T));
    auto const x = function_on(T, std::vector<Q>{Q(1), Q(-2, 3), Q(5, 2), Q(0), Q(7, 5), Q(100)});
    auto const of_sum = variation(timed + R).residual(x);
    auto const first = variation(S).residual(x);
    auto const second = variation(R).residual(x);
    for (hilger::index_type k = 1; k <= 4; ++k) CHECK(of_sum[k] == first[k] + second[k]);
    CHECK((timed + R)(x) == S(x) + R(x));
    auto const elsewhere = integral(lagrangian{potential}(q_o, Delta_o_plus[q_o]), half(time_scale<Q>{Q(0), Q(1)}));
    CHECK_THROWS_AS((void)(timed + elsewhere), error::mismatch);
}

} // namespace variation_tests
