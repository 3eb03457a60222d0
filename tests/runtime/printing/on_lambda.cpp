// SPDX-License-Identifier: BSL-1.0
// Printed equations of actions over T_lambda: what is printed is what runs.
#include "hilger/embedding/embedding.hpp"
#include "hilger/scale/time_scale.hpp"
#include "hilger/scale/uniform.hpp"

#include "read_back.hpp"

namespace printed_on_lambda_tests {

using namespace hilger;
using reading::L;
using reading::read_back;

namespace {

constexpr unknown q;
constexpr auto q_l = extend_lambda<1, 3>[q];

auto const T = uniform(Q(1, 3), Q(2, 5), 9);

} // namespace

TEST_CASE("any lambda") {
    read_back(integral(L(q_l, derivative<joined<fraction<1, 3>>, side::plus>{}[q_l]), at_lambda<1, 3>(T)));
    read_back(integral(L(fraction<2>{} * on_lambda<1, 3>[q_l], pi_lambda_inverse<1, 3>[Delta_plus[q]]), at_lambda<1, 3>(T)));
    read_back(integral(L(pi_lambda_inverse<3, 7>[Delta_plus[q]], on_lambda<3, 7>[extend_lambda<3, 7>[q]]), at_lambda<3, 7>(T)));
    auto const at_run_time = theta_at(Q(2, 5));
    read_back(integral(L(at_run_time.position[q], at_run_time.velocity[q]), at_lambda(T, Q(2, 5))));
}

TEST_CASE("a lambda known at run time in the Hamiltonian form") {
    auto const how = theta_at(0.25);
    auto const written = [&](auto const& scale) {
        std::ostringstream out;
        out << hamiltonian_form(variation(integral(L(how.position[q], how.velocity[q]), at_lambda(scale, 0.25))));
        return out.str();
    };
    std::string const velocity = "π0.25⁻¹[Δ₊[q]] = ∂H/∂p(p∘,0.25, q∘,0.25)   on T0.25,   p∘,0.25 = ∂L/∂v(⋆)\n";
    std::string const force = "π0.25[−∂H/∂q(p∘,0.25, q∘,0.25)]";
    CHECK(written(uniform(0.0, 0.5, 4)) ==
          "π0.25⁻¹[Δ₋[π0.25[p∘,0.25]]] = π0.25⁻¹[(1 − 0.25) " + force + " + 0.25 ρ[" + force + "]]   on T0.25⁻\n" + velocity);
    CHECK(written(time_scale<double>{0.0, 0.5, 0.75, 2.0}) ==
          "π0.25⁻¹[(ν/μ) Δ₋[π0.25[p∘,0.25]]] = π0.25⁻¹[(1 − 0.25) " + force + " + 0.25 (ν/μ) ρ[" + force + "]]   on T0.25⁻\n" + velocity);
}

} // namespace printed_on_lambda_tests
