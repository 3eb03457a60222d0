// SPDX-License-Identifier: BSL-1.0
// The restricted principle at Radau's nodes, on any T: its equation is the derivative of its action, it is printed, and its flow is that of
// with_fractional_damping under galerkin<s, radau>.
#include <doctest/doctest.h>

#include <cmath>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "support/values.hpp"

namespace variation_at_stages_tests {

using namespace hilger;

namespace {

constexpr lagrangian pendulum{[](auto const& x, auto const& v) { return v * v / 2 + cos(x); }};
constexpr lagrangian quadratic{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 3 + x * v / 5; }};

/// The principle with the damping rho D_s^{2P/Q}.
template <int Stages, int P, int Q, class L, class Scale, class S>
auto principle(L const& l, Scale const& T, S const& rho) {
    constexpr unknown<"q", subdivided<Stages>> q;
    constexpr unknown<"y", subdivided<Stages>> y;
    constexpr auto G = galerkin<Stages, radau>;
    auto const nodes = at_nodes<radau, Stages>(T);
    return integral(l(G.position[q], G.velocity[q]), nodes) -
           rho * integral(Delta_minus_radau<Stages, P, Q>[G.position[minus_start_inside<Stages>[q]]] *
                              Delta_plus_radau<Stages, P, Q>[G.position[y]],
                          nodes);
}
time_scale<Q> const squares{Q(0), Q(1), Q(5), Q(46, 9), Q(82, 9)};

/// The same variation for x and y: the equations of both are the derivative of the action, divided by the weights of the points.
template <int Stages, int P, int R>
void check_derivative() {
    Q const rho(3, 7);
    auto const S = principle<Stages, P, R>(quadratic, squares, rho);
    auto const EL = variation(S);
    auto const scale = derived_scale(squares, domain<subdivided<Stages>>{});
    std::vector<Q> a, b;
    for (int k = 0; k < static_cast<int>(scale.size()); ++k) {
        a.push_back(Q((k * k * 5 + 3 * k + 1) % 17 - 8, k % 5 + 1));
        b.push_back(Q((k * k * 2 + 5 * k + 2) % 13 - 6, k % 3 + 1));
    }
    auto const rx = EL.residual(function_on(scale, a));
    auto const ry = EL.reversed_residual(function_on(scale, b));
    CHECK(rx.first() == 1);
    CHECK(rx.last() == static_cast<hilger::index_type>(a.size()) - 2);
    for (std::size_t k = 1; k + 1 < a.size(); ++k) {
        auto const both = [&](Q const& e) {
            auto c = a, d = b;
            c[k] += e, d[k] += e;
            return S(function_on(scale, c), function_on(scale, d));
        };
        auto const i = static_cast<hilger::index_type>(k);
        CHECK((both(1) - both(-1)) / 2 ==
              (rx[i] + ry[i]) * weight_at<typename decltype(galerkin<Stages, radau>.position)::from_weight>(rx, i));
    }
}

} // namespace

TEST_CASE("the equations of both curves are the derivative of the action, exactly") {
    check_derivative<1, 1, 2>();
    check_derivative<2, 1, 1>(); // other orders are irrational
}

TEST_CASE("the damping is a power of the difference quotient between the position and its adjoint") {
    using equation = decltype(variation(principle<2, 1, 4>(pendulum, graded(0.0, 1.0, 8, 3.0), 0.5)));
    constexpr auto A = galerkin<2, radau>.position;
    static_assert(equation::damping() == A.adjoint() * (Delta_minus_radau<2, 1, 2> * (A * minus_start_inside<2>)));
    static_assert(not(equation::damping() == A.adjoint() * (Delta_minus_radau<2, 1, 4> * (A * minus_start_inside<2>))));
}

TEST_CASE("its flow is that of the damped Lagrangian, and solves it, for q0 other than 0 too") {
    auto const T = graded(0.0, 1.0, 8, 3.0);
    auto const EL = variation(principle<3, 1, 4>(pendulum, T, 0.5));
    auto const flow = flow_of(EL, exponentials{1e-13});
    auto const same = embed(with_fractional_damping(pendulum, 0.5, fraction<1, 2>{}, exponentials{1e-13}), galerkin<3, radau>);
    static_assert(std::same_as<decltype(flow), decltype(same)>);
    auto const path = flow.along(T, 1.0, 0.5);
    auto const same_path = same.along(T, 1.0, 0.5);
    auto other = same_path.begin();
    for (auto const& x : path) {
        CHECK((x.q == other->q and x.p == other->p));
        ++other;
    }
    auto const inside = detail::positions_along(EL.conservative(), T, path);
    auto const damped = EL.residual(inside);
    auto const undamped = EL.conservative().residual(inside);
    double rest = 0, size = 0;
    for (hilger::index_type k = damped.first(); k <= damped.last(); ++k) {
        // p/h cancels in a row, and h is least in the first step
        rest = std::max(rest, std::abs(damped[k]) * T.step(k / 3) * T.step(std::max<hilger::index_type>(k - 1, 0) / 3));
        size = std::max(size, std::abs(undamped[k]));
    }
    CHECK(rest <= 1e-13);
    CHECK(size > 0.1);
}

TEST_CASE("orders above 1 are refused, and orders known at run time are taken") {
    auto const T = uniform(0.0, 0.25, 4);
    CHECK_THROWS_WITH_AS((void)flow_of(variation(principle<2, 3, 4>(pendulum, T, 0.5))),
                         "a coupling of positions damps with an order up to 1, and the orders here have the sum 1.5",
                         error::invalid_parameter);
    constexpr unknown<"q", subdivided<2>> q;
    constexpr unknown<"y", subdivided<2>> y;
    constexpr auto G = galerkin<2, radau>;
    auto const D = Delta_minus_at_radau<2>(0.25);
    auto const S = integral(pendulum(G.position[q], G.velocity[q]), at_nodes<radau, 2>(T)) -
                   0.5 * integral(D[G.position[minus_start_inside<2>[q]]] * adjoint(D)[G.position[y]], at_nodes<radau, 2>(T));
    auto const path = flow_of(variation(S)).along(T, 1.0, 0.5);
    auto const same_path = flow_of(variation(principle<2, 1, 4>(pendulum, T, 0.5))).along(T, 1.0, 0.5);
    auto other = same_path.begin();
    for (auto const& x : path) {
        CHECK(std::abs(x.q - other->q) <= 8 * epsilon<double>()); // of which one is in compensated sums
        ++other;
    }
}

TEST_CASE("how it is printed") {
    auto const EL = variation(principle<3, 1, 4>(pendulum, graded(0.0, 1.0, 8, 3.0), 0.25));
    CHECK(text_lines(EL, "") == "Π₃*[∂L/∂q(⋆)] + Π₃′*[∂L/∂v(⋆)] = ρ Π₃*[D₃^(1/2)[Π₃[q − q(a)]]]   on T/3±,   ⋆ = (Π₃[q], Π₃′[q]),   "
                                "Π₃[f] = the polynomial of degree 3 through f on each step, on T_R3,   "
                                "D₃ = the inverse of the integral of Radau IIA with s = 3\n"
                                "the same of y = ρ Π₃*[(D₃^(1/2))*[Π₃[y]]],   ρ = 0.25\n");
    CHECK(latex(EL).find("= \\rho\\,\\Pi_{3}^{*}\\left[D_{3}^{1/2}\\left[\\Pi_{3}\\left[q - q(a)\\right]\\right]\\right]") !=
          std::string::npos);
}

} // namespace variation_at_stages_tests
