// SPDX-License-Identifier: BSL-1.0
// The notation of the operators of a Galerkin embedding:
//   P3[q], P3'[q]        the polynomial of degree 3 through q on each step, and its derivative, at the nodes of the integral
//   P3*[f], P3'*[f]      their adjoints
// with the capital letter pi for P; and
//   D_s^a[f], D_s^a*[f]  a power of Radau's difference quotient with s stages, and its adjoint
#pragma once

#include "hilger/embedding/polynomial.hpp"
#include "hilger/embedding/stage_difference.hpp"
#include "hilger/printing/notation.hpp"

namespace hilger::detail {

template <class Reading>
notation letter_of_polynomial(bool is_slope, bool is_adjoint) {
    std::string const n = std::to_string(Reading::degree);
    notation s{"Π" + subscript(Reading::degree) + (is_slope ? "′" : "") + (is_adjoint ? "*" : ""),
               "\\Pi_{" + n + "}" +
                   (is_slope or is_adjoint ? "^{" + std::string(is_slope ? "\\prime" : "") + (is_adjoint ? "*" : "") + "}" : "")};
    auto const where = [](print_style style) { return written_domain(domain<typename Reading::to>{}, style); };
    s = with_bracket(s);
    s.terminal_note = "Π" + subscript(Reading::degree) + "[f] = the polynomial of degree " + n + " through f on each step, on " +
                      where(print_style::terminal);
    s.latex_note = "\\Pi_{" + n + "}[f] \\text{ the polynomial of degree } " + n + " \\text{ through } f \\text{ on each step, on } " +
                   where(print_style::latex);
    return s;
}
template <int Degree, class Quadrature, int Count, bool IsSlope>
expression written_alone(polynomial_reading<Degree, Quadrature, Count, IsSlope> const&, expression const& f) {
    return f.in_brackets(letter_of_polynomial<polynomial_reading<Degree, Quadrature, Count, IsSlope>>(IsSlope, false), closing());
}
template <int Degree, class Quadrature, int Count, bool IsSlope>
expression written_alone(polynomial_spread<Degree, Quadrature, Count, IsSlope> const&, expression const& f) {
    return f.in_brackets(letter_of_polynomial<polynomial_reading<Degree, Quadrature, Count, IsSlope>>(IsSlope, true), closing());
}

/// Of some orders, over a finite field too; but nothing else has their values.
template <int Stages, class Order, side Side>
inline constexpr bool is_algebraic<stage_difference<Stages, Order, Side>> = false;

template <int Stages, class Order, side Side>
expression written_alone(stage_difference<Stages, Order, Side> const& a, expression const& f) {
    std::string const order = written_order(a.order);
    std::string const n = std::to_string(Stages), at = order.size() > 1 ? "(" + order + ")" : order;
    notation power{"D" + subscript(Stages) + "^" + at, "D_{" + n + "}^{" + order + "}"};
    if (Side == side::plus) power = {"(" + power.terminal + ")*", "\\left(" + power.latex + "\\right)^{*}"};
    power = with_bracket(power);
    power.terminal_note = "D" + subscript(Stages) + " = the inverse of the integral of Radau IIA with s = " + n;
    power.latex_note = "D_{" + n + "} \\text{ the inverse of the integral of Radau IIA with } s = " + n;
    return f.in_brackets(power, closing());
}

} // namespace hilger::detail
