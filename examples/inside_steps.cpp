// SPDX-License-Identifier: BSL-1.0
// Points inside the steps: quadratic polynomials, read at two nodes of a quadrature of one's own. The embedding is three operators, so its
// equation is derived, printed and stepped, and judges what was stepped, as that of every other.
#include <cmath>
#include <iostream>

#include "hilger/hilger.hpp"

using namespace hilger;

/// Radau's rule with two nodes, the first at the beginning of the step: exact up to degree 2.
struct radau_left {
    static constexpr char const* name = "Radau I";
    static constexpr bool is_symmetric = false;
    template <class S>
    static quadrature<S> on_unit_interval(int) {
        return {{S(0), S(2) / S(3)}, {S(1) / S(4), S(3) / S(4)}};
    }
};

int main() {
    auto const mine =
        make_embedding<step_weight>(polynomial_value<2, radau_left, 2>{}, polynomial_slope<2, radau_left, 2>{}, "quadratic, Radau I");

    lagrangian const pendulum = [](auto const& q, auto const& v) { return v * v / 2 - (1 - cos(q)); };
    auto const T = uniform(0.0, 0.1, 100);
    constexpr unknown<"q", subdivided<2>> q; // a function on T with the middle of each step
    auto const EL = variation(integral(pendulum(mine.position[q], mine.velocity[q]), at_nodes<radau_left, 2>(T)));
    std::cout << EL;

    auto const x = solve(EL, T, {.q0 = 1.0, .v0 = 0.0});
    std::cout << "q(0.05) = " << x(0.05) << ", q(10) = " << x(10.0) << '\n';
    auto const residual = largest_residual(EL, x);
    std::cout << "what is left of the equation: " << residual << '\n';

    auto const path = embed(pendulum, mine).along(T, 1.0, 0.0);
    auto const energy_error = drift_along(path, energy(pendulum)).largest;
    std::cout << "largest error of the energy: " << energy_error << '\n';
    return residual < 1e-11 and energy_error < 1e-4 ? 0 : 1;
}
