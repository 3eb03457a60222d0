// SPDX-License-Identifier: BSL-1.0
// A pendulum with a memory, x'' + sin x + D^{1/2}[x - 1] = 0, x(0) = x'(0) = 1, to ten digits with 48 steps: damping at the three
// nodes of Radau's quadrature, on a time scale that is graded where the solution begins like t^{5/2}; and a mean over each step beside it.
#include <cmath>
#include <iomanip>
#include <iostream>

#include "hilger/hilger.hpp"

using namespace hilger;

namespace {
constexpr auto L = [](auto const& x, auto const& v) { return v * v / 2 + cos(x); };
double const at_one = 1.34165212463519; // with six stages

template <class Flow, class Scale>
double error_of(Flow const& flow, Scale const& T) {
    double last = 0;
    for (auto const& x : flow.along(T, {.q0 = 1.0, .v0 = 1.0})) last = x.q;
    return std::abs(last - at_one);
}
} // namespace

int main() {
    auto const damped_3 = embed(with_fractional_damping(L, 1.0, fraction<1, 2>{}, exponentials{1e-13}), galerkin<3, radau>);
    auto const T_3 = graded(0.0, 1.0, 24, 3.0); // tᵢ = (i/24)³: a solution with memory begins like t^(3 − β)
    auto const mean = embed(with_fractional_damping(L, 1.0, fraction<1, 2>{}, exponentials{1e-13}), mid_point);

    std::cout << "steps   three stages, graded   mean over a step, equal\n" << std::scientific << std::setprecision(1);
    for (int N = 6; N <= 48; N *= 2)
        std::cout << std::setw(5) << N << std::setw(23) << error_of(damped_3, graded(0.0, 1.0, N, 3.0)) << std::setw(26)
                  << error_of(mean, uniform(0.0, 1.0 / N, N)) << '\n';
    return error_of(damped_3, T_3) < 1e-8 ? 0 : 1; // the mean has 1e-4
}
