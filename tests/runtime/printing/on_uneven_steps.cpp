// SPDX-License-Identifier: BSL-1.0
// Printed equations on a T of unequal steps, of the library's embeddings and of others: what is printed is what runs.
#include "hilger/scale/time_scale.hpp"
#include "read_back.hpp"

namespace printed_on_uneven_steps_tests {

using namespace hilger;
using reading::L;
using reading::read_back;

namespace {

constexpr unknown q;
constexpr auto q_o = extend[q];
constexpr auto q_l = extend_lambda<1, 3>[q];

time_scale<Q> const T{Q(0), Q(1, 3), Q(1), Q(7, 5), Q(2), Q(9, 4), Q(3), Q(10, 3)};

} // namespace

TEST_CASE("over T") {
    read_back(integral(L(q, Delta_plus[q]), T));
    read_back(integral(L(sigma[q], Q(5, 2) * Delta_plus[q]), T));
    read_back(integral(L(q - fraction<1, 3>{} * sigma[q], Delta_plus[q]), T));
    read_back(integral(L(q, Delta_plus[Delta_plus[q]]), T));
    read_back(nabla_integral(L(rho[q], fraction<2>{} * Delta_minus[q]), T));
    read_back(nabla_integral(L(q, Delta_minus[rho[q]]), T));
}

TEST_CASE("over T_half and T_lambda") {
    read_back(integral(L(q_o, Delta_o_plus[q_o]), half(T)));
    read_back(integral(L(Delta_o_plus[q_o], fraction<3, 4>{} * q_o), half(T)));
    read_back(integral(L(pi_inverse[sigma[q]], pi_inverse[Delta_plus[q]]), half(T)));
    read_back(integral(L(sigma_o[q_o], Delta_o_plus[q_o]), half(T)));
    read_back(integral(L(q_l, fraction<2>{} * derivative<joined<fraction<1, 3>>, side::plus>{}[q_l]), at_lambda<1, 3>(T)));
}

} // namespace printed_on_uneven_steps_tests
