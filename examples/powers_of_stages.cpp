// SPDX-License-Identifier: BSL-1.0
// Powers of the difference quotient of Radau IIA as operators on a graded T: a half derivative of high order, and damping with memory from
// a variational principle, which equals with_fractional_damping.
#include <cmath>
#include <iostream>

#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - (1 - cos(x)); }};
    auto const T_3 = graded(0.0, 1.0, 24, 3.0);

    auto const nodes_3 = at_nodes<radau, 3>(T_3);
    auto const half_derivative_3 = Delta_minus_radau<3, 1, 2>[function_on(nodes_3, [](double t) { return t * std::sqrt(t); })];
    static_assert(Delta_minus_radau<3, 1, 4> * Delta_minus_radau<3, 1, 4> == Delta_minus_radau<3, 1, 2>);
    static_assert(adjoint(Delta_minus_radau<3, 1, 2>) == Delta_plus_radau<3, 1, 2>);
    double const of_power = half_derivative_3[half_derivative_3.last()], exact = 0.75 * std::sqrt(std::acos(-1.0));
    std::cout << "D^(1/2) of t^(3/2) is " << of_power << " at t = 1, off by " << of_power - exact << "\n\n";

    constexpr auto G = galerkin<3, radau>;
    constexpr unknown<"q", subdivided<3>> q_3;
    constexpr unknown<"y", subdivided<3>> y_3;
    auto const coupling =
        integral(Delta_minus_radau<3, 1, 4>[G.position[minus_start_inside<3>[q_3]]] * Delta_plus_radau<3, 1, 4>[G.position[y_3]], nodes_3);
    auto const EL_3 = variation(integral(L(G.position[q_3], G.velocity[q_3]), nodes_3) - 1.0 * coupling);
    std::cout << EL_3;

    auto const path = flow_of(EL_3, exponentials{1e-13}).along(T_3, 1.0, 0.5);
    auto const same = embed(with_fractional_damping(L, 1.0, fraction<1, 2>{}, exponentials{1e-13}), G).along(T_3, 1.0, 0.5);
    double const of_principle = record(path).states.back().q, of_damping = record(same).states.back().q;
    double const roundings = relative_residual(path); // the damping summed again by its definition
    std::cout << "q(1) = " << of_principle << ", and its equation holds to " << roundings << " roundings\n";
    return std::abs(of_power - exact) < 1e-5 and of_principle == of_damping and roundings < 100 ? 0 : 1;
}
