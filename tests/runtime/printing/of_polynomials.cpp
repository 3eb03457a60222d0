// SPDX-License-Identifier: BSL-1.0
// Galerkin equations are written with the operators that they are made of, and say where they hold and what is read where.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "runtime/printing/reading.hpp"

namespace printed_polynomials_tests {

using namespace hilger;

namespace {

auto const T = uniform(0.0, 0.1, 10);
lagrangian const L = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };

template <int Degree, class Quadrature, int Count>
std::string equation_of_nodes() {
    constexpr unknown<"q", subdivided<Degree>> q;
    return text_lines(
        variation(integral(L(polynomial_value<Degree, Quadrature, Count>{}[q], polynomial_slope<Degree, Quadrature, Count>{}[q]),
                           at_nodes<Quadrature, Count>(T))),
        "");
}

} // namespace

TEST_CASE("the equation of three Gauss nodes") {
    CHECK(equation_of_nodes<3, gauss, 3>() == "Π₃*[∂L/∂q(⋆)] + Π₃′*[∂L/∂v(⋆)] = 0   on T/3±,   ⋆ = (Π₃[q], Π₃′[q]),   "
                                              "Π₃[f] = the polynomial of degree 3 through f on each step, on T_G3\n");
}

TEST_CASE("with two of them the points inside are those of T_o, with Lobatto's the nodes are others") {
    CHECK(equation_of_nodes<2, gauss, 2>() == "Π₂*[∂L/∂q(⋆)] + Π₂′*[∂L/∂v(⋆)] = 0   on T∘±,   ⋆ = (Π₂[q], Π₂′[q]),   "
                                              "Π₂[f] = the polynomial of degree 2 through f on each step, on T_G2\n");
    CHECK(equation_of_nodes<1, lobatto, 2>() == "Π₁*[∂L/∂q(⋆)] + Π₁′*[∂L/∂v(⋆)] = 0   on T±,   ⋆ = (Π₁[q], Π₁′[q]),   "
                                                "Π₁[f] = the polynomial of degree 1 through f on each step, on T_L2\n");
}

TEST_CASE("one Gauss node is written as mid-point, which it is") {
    auto const mid = text_lines(variation(integral(L(extend[unknown{}], Delta_o_plus[extend[unknown{}]]), half(T))), "");
    CHECK(equation_of_nodes<1, gauss, 1>() == mid);
}

TEST_CASE("in LaTeX, and as a Hamiltonian system") {
    constexpr unknown<"q", subdivided<3>> q;
    constexpr auto G = galerkin<4, lobatto>;
    auto const EL = variation(integral(L(G.position[q], G.velocity[q]), at_nodes<lobatto, 4>(T)));
    CHECK(latex(EL) == "\\begin{aligned}\n"
                       "  \\Pi_{3}^{*}\\left[\\frac{\\partial L}{\\partial q}(\\star)\\right] + "
                       "\\Pi_{3}^{\\prime*}\\left[\\frac{\\partial L}{\\partial v}(\\star)\\right] &= 0, && t \\in "
                       "\\mathbb{T}_{/3}^{\\pm}, \\quad \\star = (\\Pi_{3}\\left[q\\right], \\Pi_{3}^{\\prime}\\left[q\\right]), \\quad "
                       "\\Pi_{3}[f] \\text{ the polynomial of degree } 3 \\text{ through } f \\text{ on each step, on } \\mathbb{T}_{L4}\n"
                       "\\end{aligned}\n");
    CHECK(text_lines(hamiltonian_form(EL), "") == "−Π₃′*[p] = Π₃*[−∂H/∂q(p, Π₃[q])]   on T/3±\n"
                                                  "Π₃′[q] = ∂H/∂p(p, Π₃[q])   on T_L4,   p = ∂L/∂v(⋆),   "
                                                  "Π₃[f] = the polynomial of degree 3 through f on each step, on T_L4\n");
}

} // namespace printed_polynomials_tests
