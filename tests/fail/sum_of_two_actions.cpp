// SPDX-License-Identifier: BSL-1.0
// expect 1: actions add up on one scale, and these are on two kinds of scales
// expect 2: fractional damping under embeddings with points inside the steps, as galerkin<2, gauss>, has no equation in the points of T alone
// expect 3: actions add up of functions that live on the same points
// expect 4: a Hamiltonian form is of one position and one velocity, and a sum of actions has several of them
// expect 5: a coupling damps one action, and this is a sum of several that read T in different ways
// expect 6: actions of Lagrangians add up, and one here is that of a Hamiltonian
// expect 7: actions of Lagrangians have multiples, and this is that of a Hamiltonian
// expect 8: equations are not added up, actions are: variation(S + R) is the equation of the sum of the actions S and R
// What one sentence has to say instead of the operators inside.
#include <iostream>

#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    constexpr unknown q;
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
    auto const T = uniform(0.0, 0.5, 2);
    auto const S = integral(L(q, Delta_plus[q]), T);
#if defined MUST_NOT_COMPILE && MUST_NOT_COMPILE == 1
    time_scale<double> const U{0.0, 0.5, 1.0};
    auto const other = integral(L(extend[q], Delta_o_plus[extend[q]]), half(U));
#else
    auto const other = integral(L(q, Delta_plus[q]), T);
#endif
    (void)(S + other);
#if defined MUST_NOT_COMPILE && MUST_NOT_COMPILE == 8
    (void)(variation(S) + variation(S));
#endif
#if defined MUST_NOT_COMPILE && MUST_NOT_COMPILE == 3
    (void)(S + equation_of(embed(L, galerkin<2, gauss>), T).action());
#else
    (void)(S + equation_of(embed(L, theta<1, 3>), T).action());
#endif
    lagrangian const of_H{lagrangian_of([](auto const& p, auto const& x) { return p * p / 2 + x * x / 2; })};
    auto const R = integral(of_H(q, Delta_plus[q]), T);
#if defined MUST_NOT_COMPILE && MUST_NOT_COMPILE == 6
    (void)(S + R);
#elif defined MUST_NOT_COMPILE && MUST_NOT_COMPILE == 7
    (void)(2.0 * R);
#else
    (void)variation(R);
#endif
    constexpr unknown<"y"> y;
    auto const friction = 0.1 * integral(Delta_minus_alpha<1, 4>[q] * Delta_plus_alpha<1, 4>[y], T);
#if defined MUST_NOT_COMPILE && MUST_NOT_COMPILE == 5
    std::cout << variation(S + nabla_integral(L(q, Delta_minus[q]), T) - friction);
#else
    std::cout << variation(S - friction);
#endif
    auto const both = variation(S + nabla_integral(L(q, Delta_minus[q]), T));
#if defined MUST_NOT_COMPILE && MUST_NOT_COMPILE == 4
    std::cout << hamiltonian_form(both);
#else
    std::cout << both;
#endif
#if defined MUST_NOT_COMPILE && MUST_NOT_COMPILE == 2
    constexpr auto how = galerkin<2, gauss>;
#else
    constexpr auto how = mid_point;
#endif
    std::cout << largest_residual(embed(with_fractional_damping(L, 0.1, 0.5), how).along(T, 1.0, 0.0));
}
