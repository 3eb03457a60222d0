// SPDX-License-Identifier: BSL-1.0
// A pendulum with a memory, x'' + sin x + D^{1/2}[x - 1] = 0, x(0) = x'(0) = 1, to thirteen digits with 48 steps: damping at two to five
// nodes of Radau's quadrature, on a time scale that is graded where the solution begins like t^{5/2}; and a mean over each step beside it.
#include <cmath>
#include <iomanip>
#include <iostream>

#include "hilger/hilger.hpp"

using namespace hilger;

namespace {
constexpr auto L = [](auto const& x, auto const& v) { return v * v / 2 + cos(x); };
double const at_one = 1.341652124635186; // with six stages, in 50 digits

template <class Flow, class Scale>
double error_of(Flow const& flow, Scale const& T) {
    double last = 0;
    for (auto const& x : flow.along(T, {.q0 = 1.0, .v0 = 1.0})) last = x.q;
    return std::abs(last - at_one);
}
/// With s stages and N steps graded by gamma.
template <int s>
double error_with(double gamma, int N) {
    return error_of(embed(with_fractional_damping(L, 1.0, fraction<1, 2>{}, exponentials{}), galerkin<s, radau>),
                    graded(0.0, 1.0, N, gamma));
}
} // namespace

int main() {
    auto const damped_3 = embed(with_fractional_damping(L, 1.0, fraction<1, 2>{}, exponentials{1e-13}), galerkin<3, radau>);
    auto const T_3 = graded(0.0, 1.0, 24, 3.0); // tᵢ = (i/24)³: a solution with memory begins like t^(3 − β)
    auto const mean = embed(with_fractional_damping(L, 1.0, fraction<1, 2>{}, exponentials{1e-13}), mid_point);

    auto const damped_4 = embed(with_fractional_damping(L, 1.0, fraction<1, 2>{}, exponentials{1e-14}), galerkin<4, radau>);
    auto const T_4 = graded(0.0, 1.0, 24, 2.6);

    // gamma: the order min(2s - 1, s + 5/2) over 5/2
    std::cout << "steps   2, 3, 4 and 5 stages, graded          mean over a step, equal\n" << std::scientific << std::setprecision(1);
    for (int N = 6; N <= 48; N *= 2)
        std::cout << std::setw(5) << N << std::setw(10) << error_with<2>(1.2, N) << std::setw(9) << error_with<3>(2.0, N) << std::setw(9)
                  << error_with<4>(2.6, N) << std::setw(9) << error_with<5>(3.0, N) << std::setw(17)
                  << error_of(mean, uniform(0.0, 1.0 / N, N)) << '\n';

    auto const T_long = graded_start(0.0, 100.0, 0.1, 2.6); // graded up to t = 1, equal steps afterwards
    double at_rest = 1;
    for (auto const& x : damped_4.along(T_long, {.q0 = 1.0, .v0 = 1.0})) at_rest = x.q;
    std::cout << T_long.steps() << " steps to t = 100, where x = " << at_rest << '\n'; // x falls like t^(-1/2)

    return error_of(damped_3, T_3) < 1e-8 and error_of(damped_4, T_4) < 1e-11 ? 0 : 1; // the mean has 1e-4
}
