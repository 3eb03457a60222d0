// SPDX-License-Identifier: BSL-1.0
// sigma, rho, Delta_plus and Delta_minus on T, T_half, T_o and T_lambda against tables computed by hand, in exact rationals on a scale with
// the steps 1, 2, 4. The end points are part of each table: T^kappa is where the derivative is, and nothing is made up for the last point.
#include <doctest/doctest.h>

#include "support/values.hpp"

namespace operator_local_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {
auto const T = steps_1_2_4();
auto const f = function_on(T, std::vector<Q>{1, 2, 6, -2});
auto const g = function_on(half(T), std::vector<Q>{4, 1, 7});                       // at 1/2, 2, 5: steps 3/2, 3
auto const k = function_on(circ(T), std::vector<Q>{0, 3, 1, 5, -1, 2, 4});          // steps 1/2, 1/2, 1, 1, 2, 2
auto const l = function_on(at_lambda<1, 3>(T), std::vector<Q>{1, 5, -3});           // at 1/3, 5/3, 13/3: steps 4/3, 8/3
auto const m = function_on(circ(T, Q(1, 4)), std::vector<Q>{0, 3, 1, 5, -1, 2, 5}); // steps 1/4, 3/4, 1/2, 3/2, 1, 3
} // namespace

TEST_CASE("the shifts") {
    CHECK(values(sigma[f]) == "T^{+}: 2, 6, -2");
    CHECK(values(rho[f]) == "T^{-}: 1, 2, 6");
    CHECK(values(sigma[sigma[f]]) == "T^{++}: 6, -2");
    CHECK(values(rho[rho[f]]) == "T^{--}: 1, 2");
    CHECK(values(rho[sigma[f]]) == "T^{-}: 2, 6, -2");
    CHECK(values(sigma[rho[f]]) == "T^{+}: 1, 2, 6");
    CHECK(values(sigma[restrict_to(f, without_first(T))]) == "T^{+}: 2, 6, -2"); // C(T^-) -> C(T^+)
    CHECK(values(rho[restrict_to(f, without_last(T))]) == "T^{-}: 1, 2, 6");
    CHECK(values(sigma_h[g]) == "T_half^{+}: 1, 7");
    CHECK(values(rho_h[g]) == "T_half^{-}: 4, 1");
    CHECK(values(sigma_o[k]) == "T_o^{+}: 3, 1, 5, -1, 2, 4");
    CHECK(values(rho_o[k]) == "T_o^{-}: 0, 3, 1, 5, -1, 2");
    CHECK(values(shift<between<fraction<1, 3>>, side::plus>{}[l]) == "T_1/3^{+}: 5, -3");
    CHECK(values(shift<joined<run_time<Q>>, side::minus>{}[m]) == "T_{o,lambda}^{-}: 0, 3, 1, 5, -1, 2");
}

TEST_CASE("the derivatives on T divide by the step to the right or to the left") {
    CHECK(values(Delta_plus[f]) == "T^{+}: 1, 2, -2");
    CHECK(values(Delta_minus[f]) == "T^{-}: 1, 2, -2");
    CHECK(values(Delta_minus[Delta_plus[f]]) == "T^{+-}: 1, -2");
    CHECK(values(Delta_plus[Delta_minus[f]]) == "T^{+-}: 1/2, -1");
    CHECK(values(Delta_plus[Delta_plus[f]]) == "T^{++}: 1, -2");
    CHECK(values(Delta_minus[Delta_minus[f]]) == "T^{--}: 1/2, -1");
    CHECK(values(Delta_plus[Delta_plus[Delta_plus[f]]]) == "T^{+++}: -3");
    CHECK(values(Delta_plus[sigma[f]]) == "T^{++}: 4, -4");
    CHECK(values(sigma[Delta_plus[f]]) == "T^{++}: 2, -2");
    CHECK(values(Delta_plus[restrict_to(f, interior(T))]) == "T^{++-}: 2");
}

TEST_CASE("on T_half the step is the distance of mid-points") {
    CHECK(values(Delta_h_plus[g]) == "T_half^{+}: -2, 2");
    CHECK(values(Delta_h_minus[g]) == "T_half^{-}: -2, 2");
    CHECK(values(Delta_h_minus[Delta_h_plus[g]]) == "T_half^{+-}: 8/3"); // (2 - -2) / nu(2), and nu(2) = 3/2
    CHECK(values(Delta_h_plus[Delta_h_minus[g]]) == "T_half^{+-}: 4/3"); // the same difference over mu(2) = 3
}

TEST_CASE("on T_o it is half of a step of T") {
    CHECK(values(Delta_o_plus[k]) == "T_o^{+}: 6, -4, 4, -6, 3/2, 1");
    CHECK(values(Delta_o_minus[k]) == "T_o^{-}: 6, -4, 4, -6, 3/2, 1");
    CHECK(values(Delta_o_plus[Delta_o_plus[k]]) == "T_o^{++}: -20, 16, -10, 15/2, -1/4");
    CHECK(values(Delta_o_minus[Delta_o_plus[k]]) == "T_o^{+-}: -20, 16, -10, 15/2, -1/4");
    CHECK(values(Delta_o_plus[extend[f]]) == "T_o^{+}: 1, 1, 2, 2, -2, -2");
}

TEST_CASE("on T_lambda and T_{o,lambda} it is what the points say") {
    CHECK(values(derivative<between<fraction<1, 3>>, side::plus>{}[l]) == "T_1/3^{+}: 3, -3");
    CHECK(values(derivative<between<fraction<1, 3>>, side::minus>{}[l]) == "T_1/3^{-}: 3, -3");
    CHECK(values(derivative<joined<run_time<Q>>, side::plus>{}[m]) == "T_{o,lambda}^{+}: 12, -8/3, 8, -4, 3, 1");
    CHECK(values(derivative<joined<run_time<Q>>, side::minus>{}[m]) == "T_{o,lambda}^{-}: 12, -8/3, 8, -4, 3, 1");
    auto const at_zero = function_on(at_lambda<0, 1>(T), std::vector<Q>{1, 2, 6}); // T_0 has the points of T^+
    CHECK(values(derivative<between<fraction<0>>, side::plus>{}[at_zero]) == "T_0/1^{+}: 1, 2");
}

TEST_CASE("a derivative is the quotient of the differences of any function, on any scale") {
    auto const check = [](auto const& scale) {
        using Base = typename std::remove_cvref_t<decltype(scale)>::domain_type::base_type;
        auto const cube = function_on(scale, [](Q const& t) { return Q(t * t * t - t); });
        auto const right = derivative<Base, side::plus>{}[cube];
        auto const left = derivative<Base, side::minus>{}[cube];
        for (auto i = scale.first(); i < scale.last(); ++i) {
            Q const quotient = (cube[i + 1] - cube[i]) / (scale.point(i + 1) - scale.point(i));
            CHECK(right[i] == quotient);
            CHECK(left[i + 1] == quotient);
        }
        CHECK_THROWS_AS((void)right[scale.last()], error::outside_domain);
        CHECK_THROWS_AS((void)left[scale.first()], error::outside_domain);
    };
    auto const all = [&](auto const& S) {
        check(S), check(half(S)), check(circ(S)), check(at_lambda<2, 7>(S)), check(circ<2, 7>(S)), check(at_lambda(S, Q(3, 5)));
        check(circ(S, Q(3, 5))), check(at_lambda<0, 1>(S)), check(without_last(S)), check(without_first(circ(S)));
    };
    all(T), all(uniform(Q(1), Q(1, 3), 5)), all(powers(Q(3, 2), -2, 2)), all(harmonic_numbers<Q>(4)), all(uniform(Q(0), Q(2), 3));
}

TEST_CASE("the means of neighbouring mid-points") {
    CHECK(values(mean_h_minus[g]) == "T_half^{-}: 5/2, 4");
    CHECK(values(mean_h_plus[g]) == "T_half^{+}: 5/2, 4");
    CHECK(values(mean_h_minus[mean_h_plus[g]]) == "T_half^{+-}: 13/4");
}

TEST_CASE("one, two and three steps leave what they can") {
    auto const one = function_on(uniform(Q(0), Q(1, 2), 1), std::vector<Q>{3, 5});
    CHECK(values(sigma[one]) == "T^{+}: 5");
    CHECK(values(rho[one]) == "T^{-}: 3");
    CHECK(values(Delta_plus[one]) == "T^{+}: 4");
    CHECK(values(Delta_minus[one]) == "T^{-}: 4");
    CHECK(values(rho[sigma[one]]) == "T^{-}: 5");
    CHECK(Delta_minus[Delta_plus[one]].size() == 0);
    CHECK(sigma[sigma[one]].size() == 0);
    CHECK_THROWS_AS((void)Delta_plus[Delta_plus[one]][0], error::outside_domain);
    CHECK(values(mean_h_minus[pi_inverse[one]]) == "T_half^{-}:");
    CHECK(values(Delta_o_plus[extend[one]]) == "T_o^{+}: 4, 4");
    auto const two = function_on(time_scale<Q>{Q(0), Q(1), Q(3)}, std::vector<Q>{3, 5, 6});
    CHECK(values(Delta_plus[two]) == "T^{+}: 2, 1/2");
    CHECK(values(Delta_minus[Delta_plus[two]]) == "T^{+-}: -3/2");
    CHECK(values(Delta_plus[Delta_minus[two]]) == "T^{+-}: -3/4");
    CHECK(values(Delta_plus[Delta_plus[two]]) == "T^{++}: -3/2");
    CHECK(Delta_plus[Delta_plus[Delta_plus[two]]].size() == 0);
    auto const three = function_on(uniform(Q(0), Q(1), 3), std::vector<Q>{0, 1, 4, 9});
    CHECK(values(Delta_plus[Delta_plus[three]]) == "T^{++}: 2, 2");
    CHECK(values(Delta_minus[Delta_minus[Delta_minus[three]]]) == "T^{---}: 0");
}

} // namespace operator_local_tests
