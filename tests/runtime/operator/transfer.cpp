// SPDX-License-Identifier: BSL-1.0
// What carries functions from T to T_half and T_o and back, against tables computed by hand, with the adjoints: which value goes where,
// with which weight, and which points have none.
#include <doctest/doctest.h>

#include "support/values.hpp"

namespace operator_transfer_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {
auto const T = steps_1_2_4();
auto const f = function_on(T, std::vector<Q>{1, 2, 6, -2});
auto const g = function_on(half(T), std::vector<Q>{4, 1, 7});
auto const k = function_on(circ(T), std::vector<Q>{0, 3, 1, 5, -1, 2, 4});
} // namespace

TEST_CASE("the extension is f at the points of T and the average between") {
    CHECK(values(extend[f]) == "T_o: 1, 3/2, 2, 4, 6, 2, -2");
    CHECK(values(extend_lambda<1, 3>[f]) == "T_{o,1/3}: 1, 4/3, 2, 10/3, 6, 10/3, -2");
    CHECK(values(extend_at(Q(1, 3))[f]) == "T_{o,lambda}: 1, 4/3, 2, 10/3, 6, 10/3, -2");
    CHECK(values(extend_at(Q(1, 2))[f]) == "T_{o,lambda}: 1, 3/2, 2, 4, 6, 2, -2");
    CHECK(values(extend[Delta_plus[f]]) == "T_o^{++}: 1, 3/2, 2, 0, -2");
    CHECK(values(extend[rho[f]]) == "T_o^{--}: 1, 3/2, 2, 4, 6");
    CHECK(extend_at(Q(1, 3))[f].scale() == circ<1, 3>(T));
}

TEST_CASE("restrictions take the values at every second point") {
    CHECK(values(on_T[k]) == "T: 0, 1, -1, 4");
    CHECK(values(on_half[k]) == "T_half: 3, 5, 2");
    CHECK(values(on_T[sigma_o[k]]) == "T^{+}: 3, 5, 2");
    CHECK(values(on_half[sigma_o[k]]) == "T_half: 1, -1, 4");
    CHECK(values(on_T[rho_o[k]]) == "T^{-}: 3, 5, 2");
    CHECK(values(on_half[rho_o[k]]) == "T_half: 0, 1, -1");
    CHECK(values(on_half[sigma_o[sigma_o[k]]]) == "T_half^{+}: 5, 2"); // T_o^{++} has lost the last mid-point
    CHECK(values(on_T[sigma_o[sigma_o[k]]]) == "T^{+}: 1, -1, 4");
    CHECK(values(on_half[rho_o[rho_o[rho_o[k]]]]) == "T_half^{-}: 0, 1");
    CHECK(values(on_lambda<1, 3>[extend_lambda<1, 3>[f]]) == "T_1/3: 4/3, 10/3, 10/3");
}

TEST_CASE("pi_half gives the value at a mid-point the point before it") {
    CHECK(values(pi_half[g]) == "T^{+}: 4, 1, 7");
    CHECK(values(pi_half[rho_h[g]]) == "T^{+-}: 4, 1");
    CHECK(values(pi_half[sigma_h[g]]) == "T^{++}: 1, 7");
    CHECK(values(pi_inverse[f]) == "T_half: 1, 2, 6");
    CHECK(values(pi_inverse[Delta_plus[f]]) == "T_half: 1, 2, -2");
    CHECK(values(pi_inverse[Delta_minus[f]]) == "T_half^{-}: 1, 2");
    CHECK(values(pi_inverse[sigma[sigma[f]]]) == "T_half^{+}: 6, -2");
    CHECK(values(pi_lambda_inverse<1, 3>[f]) == "T_1/3: 1, 2, 6");
    CHECK(values(projection<fraction<1, 3>, false>{}[pi_lambda_inverse<1, 3>[f]]) == "T^{+}: 1, 2, 6");
    CHECK(pi_half[g](Q(3)) == g(Q(5)));
}

TEST_CASE("mean_o is the plain mean of the two neighbouring mid-points") {
    CHECK(values(mean_o[k]) == "T^{+-}: 4, 7/2");
    CHECK(values(mean_o[extend[f]]) == "T^{+-}: 11/4, 3");
    CHECK(values(pi_half[mean_h_minus[on_half[k]]]) == "T^{+-}: 4, 7/2");
}

TEST_CASE("step_mean weighs them by their steps") {
    CHECK(values(step_mean[g]) == "T^{+-}: 2, 5"); // (1*4 + 2*1)/3, (2*1 + 4*7)/6
    CHECK(values(step_mean_at<fraction<1, 3>>{}[function_on(at_lambda<1, 3>(T), std::vector<Q>{4, 1, 7})]) == "T^{+-}: 8/5, 29/5");
    // with the Delta weight of a lambda known at run time: ((1 - lambda) mu g + lambda nu g^rho) / mu
    auto const at_third = function_on(at_lambda(T, Q(1, 3)), std::vector<Q>{4, 1, 7});
    CHECK(values(step_mean_at<run_time<Q>>{{}, {Q(1, 3)}}[at_third]) == "T^{+-}: 4/3, 29/6");
    // on a uniform scale it is the mean
    auto const h = function_on(half(uniform(Q(0), Q(1, 3), 3)), std::vector<Q>{4, 1, 7});
    CHECK(values(step_mean[h]) == "T^{+-}: 5/2, 4");
    CHECK(values(step_mean[h]) == values(pi_half[mean_h_minus[h]]));
}

TEST_CASE("the adjoints of the restrictions insert zeros, and a factor 2 for the halved weights of T_o") {
    CHECK(values(insertion<fraction<1, 2>, true>{}[f]) == "T_o: 1, 0, 2, 0, 6, 0, -2");
    CHECK(values(insertion<fraction<1, 2>, false>{}[g]) == "T_o: 0, 4, 0, 1, 0, 7, 0");
    CHECK(values(adjoint(on_T)[f]) == "T_o: 2, 0, 4, 0, 12, 0, -4");
    CHECK(values(adjoint(on_half)[g]) == "T_o: 0, 8, 0, 2, 0, 14, 0");
    CHECK(values(insertion<fraction<1, 2>, true>{}[Delta_plus[f]]) ==
          "T_o^{+}: 1, 0, 2, 0, -2, 0"); // the mid-point after T^+ is known to be 0
    CHECK(values(insertion<fraction<1, 2>, false>{}[rho_h[g]]) == "T_o^{--}: 0, 4, 0, 1, 0");
    CHECK(values(insertion<fraction<1, 3>, true>{}[f]) == "T_{o,1/3}: 1, 0, 2, 0, 6, 0, -2");
}

TEST_CASE("the adjoint of the extension") {
    CHECK(values(adjoint(extend)[k]) == "T^{+-}: 8/3, 1"); // (1 + 13/3)/2, (-1 + 3)/2
    CHECK(values(adjoint(on_half * extend)[g]) == values(step_mean[g]));
    // A lambda known at run time pairs in Delta sums, so the half weights are those of mu: k/2 + (mu k_+ + nu k_-) / (4 mu).
    auto const same = function_on(circ(T, Q(1, 2)), std::vector<Q>{0, 3, 1, 5, -1, 2, 4});
    CHECK(values(adjoint(extend_at(Q(1, 2)))[same]) == "T^{+-}: 17/8, 5/8"); // 1/2 + (2*5 + 1*3)/8, -1/2 + (4*2 + 2*5)/16
}

TEST_CASE("one and two steps") {
    auto const one = uniform(Q(0), Q(1), 1);
    auto const p = function_on(one, std::vector<Q>{3, 5});
    CHECK(values(extend[p]) == "T_o: 3, 4, 5");
    CHECK(values(on_half[extend[p]]) == "T_half: 4");
    CHECK(values(pi_inverse[p]) == "T_half: 3");
    CHECK(values(pi_half[function_on(half(one), std::vector<Q>{7})]) == "T^{+}: 7");
    CHECK(step_mean[function_on(half(one), std::vector<Q>{7})].size() == 0);
    CHECK(mean_o[extend[p]].size() == 0);
    CHECK(adjoint(extend)[extend[p]].size() == 0);
    CHECK(values(adjoint(on_half)[function_on(half(one), std::vector<Q>{7})]) == "T_o: 0, 14, 0");
    auto const q = function_on(uniform(Q(0), Q(1), 2), std::vector<Q>{3, 5, 11});
    CHECK(values(extend[q]) == "T_o: 3, 4, 5, 8, 11");
    CHECK(values(mean_o[extend[q]]) == "T^{+-}: 6");
    CHECK(values(step_mean[on_half[extend[q]]]) == "T^{+-}: 6");
}

} // namespace operator_transfer_tests
