// SPDX-License-Identifier: BSL-1.0
// Printed equations with two steps of reach, weights, numbers known at run time only, and nabla integrals: actions that are not the
// library's: what is printed is what runs.
#include "hilger/scale/uniform.hpp"
#include "read_back.hpp"

namespace printed_of_nabla_tests {

using namespace hilger;
using reading::L;
using reading::read_back;

namespace {

constexpr unknown q;
constexpr fraction<1, 2> half_of{};
constexpr reweight<nodes, nabla_weight, delta_weight> nu_over_mu{};

auto const T = uniform(Q(1, 3), Q(2, 5), 9);

} // namespace

TEST_CASE("reach over two steps, weights, and numbers known at run time only") {
    read_back(integral(L(q, Delta_plus[Delta_plus[q]]), T));
    read_back(integral(L(nu_over_mu[q], Delta_plus[q]), T));
    read_back(integral(L(q, Q(5, 7) * Delta_plus[q]), T));
    read_back(integral(L(Q(-5, 7) * q + sigma[q], Delta_plus[Q(2, 9) * q]), T));
    read_back(integral(L((q - 3 * sigma[q]) / 2, Delta_plus[q / -4] * 5), T));
}

TEST_CASE("the nabla integral") {
    read_back(nabla_integral(L(rho[q], Delta_minus[q]), T));
    read_back(nabla_integral(L(q, Delta_minus[Delta_plus[q]]), T));
    read_back(nabla_integral(L(Delta_minus[q], fraction<3, 4>{} * q), T));
    read_back(nabla_integral(L(rho[rho[q]], half_of * (Delta_minus[q] + Delta_minus[rho[q]])), T));
}

} // namespace printed_of_nabla_tests
