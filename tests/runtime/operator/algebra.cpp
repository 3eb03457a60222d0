// SPDX-License-Identifier: BSL-1.0
// Multiples, sums and compositions of operators, applied: they do to values what the same operations on functions do. And reweighting,
// which the types can only compare with itself.
#include <doctest/doctest.h>

#include "support/values.hpp"

namespace operator_algebra_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {
auto const T = steps_1_2_4();
auto const f = function_on(T, std::vector<Q>{1, 2, 6, -2});
auto const g = function_on(T, std::vector<Q>{0, -1, 5, 3});
} // namespace

TEST_CASE("multiples, with fractions and with numbers") {
    CHECK(values((-sigma)[f]) == "T^{+}: -2, -6, 2");
    CHECK(values((fraction<1, 2>{} * sigma)[f]) == "T^{+}: 1, 3, -1");
    CHECK(values((Q(2, 3) * sigma)[f]) == "T^{+}: 4/3, 4, -4/3");
    CHECK(values((2 * Delta_plus)[f]) == "T^{+}: 2, 4, -4");
    CHECK(values(adjoint(Q(2, 3) * Delta_plus)[f]) == "T^{-}: -2/3, -4/3, 4/3");
    auto const x = function_on(uniform(0.0, 0.5, 2), [](double t) { return t; });
    CHECK(values((0.5 * Delta_plus)[x]) == "T^{+}: 0.5, 0.5");
    CHECK(values((3 * sigma)[x]) == "T^{+}: 1.5, 3");
}

TEST_CASE("quotients, and factors on the right") {
    CHECK(values((sigma / 2)[f]) == "T^{+}: 1, 3, -1");
    CHECK(values((sigma / -4)[f]) == "T^{+}: -1/2, -3/2, 1/2");
    CHECK(values((Delta_plus / Q(2, 3))[f]) == "T^{+}: 3/2, 3, -3");
    CHECK(values((sigma / fraction<-2, 3>{})[f]) == "T^{+}: -3, -9, 3");
    CHECK(values((sigma * 2)[f]) == "T^{+}: 4, 12, -4");
    CHECK(values(adjoint(Delta_plus / 2)[f]) == "T^{-}: -1/2, -1, 1");
    auto const x = function_on(uniform(0.0, 0.5, 2), [](double t) { return t; });
    CHECK(values((Delta_plus / 0.5)[x]) == "T^{+}: 2, 2");
    auto const exact = function_on(uniform(float100(0), float100(1), 1), [](float100 const&) { return float100(1); });
    CHECK((sigma / 3)[exact][0] == float100(1) / 3); // divided in the scalar
    CHECK_THROWS_WITH_AS((void)(sigma / 0), "an operator is divided by 0", error::invalid_parameter);
    CHECK(sigma / 2 == fraction<1, 2>{} * sigma);
    CHECK_FALSE(sigma / 2 == sigma / 3);
}

TEST_CASE("sums live where both summands do") {
    CHECK(values((sigma + rho)[f]) == "T^{+-}: 7, 0");
    CHECK(values((sigma - identity_T)[f]) == "T^{+}: 1, 4, -8");
    CHECK(values((Delta_plus + Delta_minus)[f]) == "T^{+-}: 3, 0");
    CHECK(values((identity_T - Delta_minus)[f]) == "T^{-}: 1, 4, 0");
    CHECK(values((sigma + rho + identity_T)[f]) == "T^{+-}: 9, 6");
    CHECK(values((pi_inverse + pi_inverse * sigma)[f]) == "T_half: 3, 8, 4");
    CHECK_THROWS_AS((void)(sigma + rho)[f][0], error::outside_domain);
}

TEST_CASE("compositions do the second first") {
    CHECK(values((Delta_minus * Delta_plus)[f]) == "T^{+-}: 1, -2");
    CHECK(values((Delta_plus * Delta_minus)[f]) == "T^{+-}: 1/2, -1");
    CHECK(values(Delta_minus[Delta_plus][f]) == "T^{+-}: 1, -2");
    CHECK(values((Delta_plus * sigma)[f]) == "T^{++}: 4, -4");
    CHECK(values((sigma * Delta_plus)[f]) == "T^{++}: 2, -2");
    CHECK(values((on_half * Delta_o_plus * extend)[f]) == "T_half: 1, 2, -2");
    CHECK(values((on_half * (Delta_o_plus * extend))[f]) == "T_half: 1, 2, -2");
    CHECK(values((Delta_plus * antiderivative_h * pi_inverse * Delta_plus)[f]) == "T^{+}: 1, 2, -2");
    CHECK(values((mean_o * extend)[f]) == "T^{+-}: 11/4, 3");
    CHECK(values((Delta_plus * Delta_plus * Delta_plus)[f]) == "T^{+++}: -3");
    CHECK(values((Delta_plus * (sigma + rho))[f]) == "T^{++-}: -7/2");
}

TEST_CASE("every operator is linear, in values") {
    Q const a(2, 3), b(-5);
    auto const check = [&](auto const& A) { CHECK(values(A[a * f + b * g]) == values(a * A[f] + b * A[g])); };
    check(sigma), check(rho), check(Delta_plus), check(Delta_minus), check(extend), check(pi_inverse), check(extend_lambda<1, 3>);
    check(extend_at(Q(2, 7))), check(antiderivative), check(antiderivative_nabla), check(adjoint(antiderivative_h)), check(adjoint(on_T));
    check(on_half * Delta_o_plus * extend), check(mean_o * extend), check(step_mean * on_half * extend), check(-sigma), check(sigma + rho);
    check(reweight<nodes, delta_weight, nabla_weight>{}), check(Delta_minus * Delta_plus), check(identity_T);
}

TEST_CASE("the product rules of the derivative and of the shift") {
    CHECK(values(sigma[f * g]) == values(sigma[f] * sigma[g]));
    CHECK(values(Delta_plus[f * g]) == values(Delta_plus[f] * g + sigma[f] * Delta_plus[g]));
    CHECK(values(Delta_minus[f * g]) == values(Delta_minus[f] * g + rho[f] * Delta_minus[g]));
    auto const k = extend[f], l = extend[g];
    CHECK(values(Delta_o_plus[k * l]) == values(Delta_o_plus[k] * l + sigma_o[k] * Delta_o_plus[l]));
    auto const graininess = function_on(without_last(T), [](Q const& t) { return T.mu(t); });
    CHECK(values(sigma[f]) == values(f + graininess * Delta_plus[f]));
}

TEST_CASE("reweighting multiplies by the ratio of two weights where there is one") {
    CHECK(values(reweight<nodes, delta_weight, nabla_weight>{}[f]) == "T^{-}: 4, 12, 0");                     // mu / nu = 2, 2, 0
    CHECK(values(reweight<nodes, nabla_weight, delta_weight>{}[f]) == "T^{+}: 0, 1, 3");                      // nu / mu = 0, 1/2, 1/2
    CHECK(values(reweight<nodes, mean_weight<fraction<1, 2>>, delta_weight>{}[f]) == "T^{+}: 1/2, 3/2, 9/2"); // 1/2, 3/4, 3/4
    CHECK(values(reweight<nodes, delta_weight, delta_weight>{}[f]) == "T^{+}: 1, 2, 6");
    CHECK(values(identity_on<nodes, delta_weight, nabla_weight>{}[f]) == "T: 1, 2, 6, -2"); // between two sums, and no factor
    CHECK(values(adjoint(identity_on<nodes, delta_weight, nabla_weight>{})[f]) == values(reweight<nodes, nabla_weight, delta_weight>{}[f]));
    auto const U = uniform(Q(0), Q(1, 3), 3);
    CHECK(values(reweight<nodes, delta_weight, nabla_weight>{}[function_on(U, std::vector<Q>{1, 2, 6, -2})]) == "T^{-}: 2, 6, 0");
}

TEST_CASE("the weights themselves") {
    auto const weights = [](auto weight, auto const& scale) {
        using W = decltype(weight);
        auto const one = function_on(scale, [](Q const&) { return 1; });
        std::string text;
        for (auto i = scale.first(); i <= scale.last(); ++i) text += printed(Q(weight_at<W>(one, i))) + " ";
        return text;
    };
    CHECK(weights(delta_weight{}, T) == "1 2 4 0 ");
    CHECK(weights(nabla_weight{}, T) == "0 1 2 4 ");
    CHECK(weights(mean_weight<fraction<1, 3>>{}, T) == "2/3 5/3 10/3 4/3 ");
    CHECK(weights(delta_weight{}, half(T)) == "3/2 3 0 ");
    CHECK(weights(nabla_weight{}, half(T)) == "0 3/2 3 ");
    CHECK(weights(step_weight{}, half(T)) == "1 2 4 ");
    CHECK(weights(step_weight{}, at_lambda<1, 3>(T)) == "1 2 4 ");
    CHECK(weights(delta_weight{}, circ(T)) == "1/2 1/2 1 1 2 2 0 ");
    CHECK(weights(nabla_weight{}, circ<1, 3>(T)) == "0 1/3 2/3 2/3 4/3 4/3 8/3 ");
    CHECK(weights(split_weight<delta_weight>{}, circ(T)) == "1/2 1/2 1 1 2 2 0 ");
    CHECK(weights(split_weight<mean_weight<fraction<1, 2>>>{}, circ(T)) == "1/4 1/2 3/4 1 3/2 2 1 ");
    CHECK(weights(delta_weight{}, without_last(T)) == "1 2 4 "); // a part of T keeps the weights of T
    CHECK(weights(nabla_weight{}, without_first(T)) == "1 2 4 ");
}

} // namespace operator_algebra_tests
