// SPDX-License-Identifier: BSL-1.0
// Printed equations of actions over T_half that are not the library's: what is printed is what runs.
#include "hilger/scale/uniform.hpp"
#include "read_back.hpp"

namespace printed_on_half_tests {

using namespace hilger;
using reading::L;
using reading::read_back;

namespace {

constexpr unknown q;
constexpr auto q_o = extend[q];
constexpr auto velocity = pi_inverse * Delta_plus;

auto const T = uniform(Q(1, 3), Q(2, 5), 9);

} // namespace

TEST_CASE("swapped, scaled and shifted mid-point operators") {
    read_back(integral(L(fraction<3, 2>{} * q_o, Delta_o_plus[q_o]), half(T)));
    read_back(integral(L(Delta_o_plus[q_o], q_o), half(T)));
    read_back(integral(L(sigma_o[q_o], Delta_o_plus[q_o]), half(T)));
    read_back(integral(L(rho_o[q_o], Delta_o_minus[q_o]), half(T)));
    read_back(integral(L(fraction<-1>{} * q_o, fraction<2, 5>{} * Delta_o_plus[q_o]), half(T)));
}

TEST_CASE("means, differences of differences, values at the ends of a step") {
    read_back(integral(L(pi_inverse[q], velocity[q]), half(T)));
    read_back(integral(L(pi_inverse[sigma[q]], velocity[q]), half(T)));
    read_back(integral(L(q_o, Delta_o_plus[Delta_o_plus[q_o]]), half(T)));
    read_back(integral(L((mean_h_minus * on_half)[q_o], velocity[q]), half(T)));
    read_back(integral(L((on_half * extend)[fraction<1, 2>{} * (q + sigma[q])], Delta_h_minus[on_half[q_o]]), half(T)));
}

} // namespace printed_on_half_tests
