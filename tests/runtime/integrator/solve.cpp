// SPDX-License-Identifier: BSL-1.0
// A force beside the data of an equation: what comes back leaves nothing of the equation with the force in it, and is what the flow of the
// forced Lagrangian walks through.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace solve_tests {

using namespace hilger;

namespace {

constexpr unknown q;
constexpr auto q_o = extend[q];
constexpr lagrangian oscillator{[](auto const& x, auto const& v) { return dot_product(v, v) / 2 - dot_product(x, x) / 2; }};
/// Of the time, the position and the velocity, as an expression of Eigen where they are vectors.
constexpr auto force = [](auto const& t, auto const& x, auto const& v) { return x * (t / 4) - v / 5; };

template <class EL, class T, class Data>
void leaves_nothing(EL const& equation, T const& scale, Data const& from) {
    auto const x = solve(equation, scale, from, force);
    CHECK(largest_residual(equation, x, force) < 1e-13 / 0.1); // terms of the size |p| / h cancel in it
    CHECK(largest_residual(equation, x) > 0.01);               // without the force it is not solved
}

} // namespace

TEST_CASE("exactly, of an explicit equation over rationals") {
    auto const T = uniform(Q(0), Q(1, 4), 6);
    auto const EL = variation(integral(oscillator(q, Delta_plus[q]), T));
    auto const x = solve(EL, T, {.q0 = 1, .v0 = 0}, force);
    CHECK(largest_residual(EL, x, force) == 0);
    auto const y = solve(EL, T, {.q0 = x[0], .q1 = x[1]}, force);
    index_type i = 0;
    for (auto const& s : embed(with_force(oscillator, force), order_one).along(T, {.q0 = 1, .v0 = 0})) {
        CHECK(x[i] == s.q);
        CHECK(y[i++] == s.q);
    }
    CHECK(i == T.size());
}

TEST_CASE("of implicit equations, points inside the steps included, in states of every kind") {
    auto const T = uniform(0.0, 0.1, 30);
    constexpr auto two_nodes = galerkin<2, gauss>;
    constexpr unknown<"q", joined<fraction<1, 2>>> q_inside;
    auto const mid = variation(integral(oscillator(q_o, Delta_o_plus[q_o]), half(T)));
    auto const mean = variation(integral(oscillator((q + sigma[q]) / 2, Delta_plus[q]), T));
    auto const inside = variation(integral(oscillator(two_nodes.position[q_inside], two_nodes.velocity[q_inside]), at_nodes<gauss, 2>(T)));
    auto const of_all = [&](auto const& from) {
        leaves_nothing(mid, T, from);
        leaves_nothing(mean, T, from);
        leaves_nothing(inside, T, from);
    };
    of_all(initial_velocity{1.0, 0.5});
    of_all(initial_velocity<Eigen::Vector2d>{{1.0, 0.5}, {0.0, -1.0}});
    of_all(initial_velocity<Eigen::VectorXd>{Eigen::VectorXd::Ones(5), Eigen::VectorXd::LinSpaced(5, -1.0, 1.0)});
    leaves_nothing(mid, T, initial_positions{1.0, 1.05});
}

TEST_CASE("a force of another length is refused") {
    auto const T = uniform(0.0, 0.1, 3);
    auto const shorter = [](auto const&, auto const& v) { return evaluated(v.head(v.size() - 1) * -1.0); };
    auto const EL = variation(integral(oscillator(q, Delta_plus[q]), T));
    auto const mid = variation(integral(oscillator(q_o, Delta_o_plus[q_o]), half(T)));
    char const* const sentence = "a force has a component for each of q, 6, and this one has 5";
    initial_velocity<Eigen::VectorXd> const from{Eigen::VectorXd::Ones(6), Eigen::VectorXd::Zero(6)};
    CHECK_THROWS_WITH_AS((void)solve(EL, T, from, shorter), doctest::Contains(sentence), error::mismatch);
    CHECK_THROWS_WITH_AS((void)solve(mid, T, from, shorter), doctest::Contains(sentence), error::mismatch);
    auto const x = solve(EL, T, from);
    CHECK_THROWS_WITH_AS((void)largest_residual(EL, x, shorter), doctest::Contains(sentence), error::mismatch);
    // Of a fixed size the state, and of any the force.
    auto const of_two = [](auto const&, auto const&) { return Eigen::VectorXd(Eigen::Vector2d(0.0, -9.81)); };
    initial_velocity<Eigen::Vector3d> const in_space{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    CHECK_THROWS_WITH_AS((void)solve(EL, T, in_space, of_two),
                         doctest::Contains("a force has a component for each of q, 3, and this one has 2"), error::mismatch);
}

TEST_CASE("a quotient of operators steps as the product, and as mid-point") {
    auto const T = uniform(0.0, 0.1, 30);
    auto const quotient = solve(variation(integral(oscillator((q + sigma[q]) / 2, Delta_plus[q]), T)), T, {.q0 = 1.0, .v0 = 0.0});
    auto const product = solve(variation(integral(oscillator(0.5 * (q + sigma[q]), Delta_plus[q]), T)), T, {.q0 = 1.0, .v0 = 0.0});
    index_type i = 0;
    for (auto const& s : embed(oscillator, mid_point).along(T, 1.0, 0.0)) {
        CHECK(quotient[i] == product[i]);
        CHECK(quotient[i] == doctest::Approx(s.q).epsilon(1e-13));
        ++i;
    }
}

} // namespace solve_tests
