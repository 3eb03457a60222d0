// SPDX-License-Identifier: BSL-1.0
// Embeddings of one's own are consistent, or they are refused in a sentence, or they are meant as they are. Conditions on types are in
// tests/fail; here are those on numbers known at run time only.
#include <doctest/doctest.h>

#include "hilger/embedding/galerkin.hpp"
#include "hilger/integrator/solve.hpp"
#include "hilger/multiprecision.hpp"

namespace consistency_tests {

using namespace hilger;

namespace {

constexpr unknown q;
struct oscillator {
    template <class X, class V>
    auto operator()(X const& x, V const& v) const {
        return v * v / 2 - x * x / 2;
    }
};
constexpr lagrangian<oscillator> L{oscillator{}};

template <class S, class E>
void walk(E const& how) {
    for (auto const& x : embed(L, how).along(uniform(S(0), S(1) / S(8), 8), S(1), S(1) / S(2))) (void)x;
}
std::string says(char const* condition) {
    return std::string("the ") + condition +
           ", and of the embedding \"mine\" not, so that it integrates another system; if that is meant, say "
           "make_embedding<Weight>(position, velocity, name, inconsistent)";
}

} // namespace

TEST_CASE("numbers known at run time only are looked at when a step is made") {
    auto const one = says("position operator of an embedding makes 1 of the constant 1");
    CHECK_THROWS_WITH_AS(walk<double>(make_embedding<delta_weight>(1.5 * identity_T, Delta_plus, "mine")), one.c_str(),
                         error::invalid_parameter);
    auto const zero = says("velocity operator of an embedding makes 0 of the constant 1");
    CHECK_THROWS_WITH_AS(walk<double>(make_embedding<delta_weight>(identity_T, Delta_plus + 1e-9 * identity_T, "mine")), zero.c_str(),
                         error::invalid_parameter);
    auto const time = says("velocity operator of an embedding makes 1 of the function t");
    CHECK_THROWS_WITH_AS(walk<double>(make_embedding<delta_weight>(identity_T, 1.0000001 * Delta_plus, "mine")), time.c_str(),
                         error::invalid_parameter);
    auto const weights = says("weights of an embedding add up to the step h");
    CHECK_THROWS_WITH_AS(walk<double>(make_embedding<nabla_weight>(identity_T, 1.0 * Delta_plus, "mine")), weights.c_str(),
                         error::invalid_parameter);
    auto const inside = says("velocities at the nodes of an embedding determine the values inside the step");
    CHECK_THROWS_WITH_AS(
        walk<double>(make_embedding<step_weight>(1.0 * polynomial_value<2, gauss, 1>{}, polynomial_slope<2, gauss, 1>{}, "mine")),
        inside.c_str(), error::invalid_parameter);
    // exactly, where numbers are exact
    CHECK_THROWS_AS(walk<Q>(make_embedding<delta_weight>(identity_T, Q(1'000'000'001, 1'000'000'000) * Delta_plus, "mine")),
                    error::invalid_parameter);
}

TEST_CASE("what is consistent up to rounding passes") {
    walk<double>(make_embedding<delta_weight>(0.1 * identity_T + 0.9 * sigma, Delta_plus, "mine"));
    walk<double>(
        make_embedding<delta_weight>(0.3 * identity_T + 0.6 * sigma + 0.1 * identity_T, 0.7 * Delta_plus + 0.3 * Delta_plus, "mine"));
    walk<double>(theta_at(0.3));
    walk<Q>(make_embedding<delta_weight>(Q(1, 7) * identity_T + Q(6, 7) * sigma, Delta_plus, "mine"));
}

TEST_CASE("an embedding that is meant as it is solves its own equation") {
    auto const T = uniform(Q(0), Q(1, 4), 6);
    auto const check = [&](auto const& S) {
        auto const equation = variation(S);
        std::vector<Q> positions;
        for (auto const& x : flow_of(equation, inconsistent).along(T, Q(1), Q(1, 2))) positions.push_back(x.q);
        for (Q const& r : equation.residual(function_on(T, positions))) CHECK(r == 0);
        CHECK(positions[6] != positions[0]);
    };
    check(integral(L(fraction<3, 2>{} * q, Delta_plus[q]), T));
    check(integral(L(sigma[q], Q(2, 3) * Delta_plus[q]), T));
    check(integral(L(fraction<1, 3>{} * extend[q], Delta_o_plus[extend[q]]), half(T)));
    walk<double>(make_embedding<delta_weight>(1.5 * identity_T, Delta_plus, "mine", inconsistent));
}

TEST_CASE("orders that add up to one are stepped, and their equation holds") {
    auto const T = uniform(Q(0), Q(1, 4), 6);
    auto const equation = variation(nabla_integral(L(q, Delta_minus_alpha<1, 2>[Delta_minus_alpha<1, 2>[q]]), T));
    std::vector<Q> positions;
    for (auto const& x : flow_of(equation).along(T, Q(1), Q(1, 2))) positions.push_back(x.q);
    for (Q const& r : equation.residual(function_on(T, positions))) CHECK(r == 0);
}

} // namespace consistency_tests
