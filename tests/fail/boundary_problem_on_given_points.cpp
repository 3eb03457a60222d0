// SPDX-License-Identifier: BSL-1.0
// expect: has the weights of one step h, and this integral is over a scale of given points
// lines-clang: 26
// The method of two-sided problems is made of convolutions; on unequal steps fractional differences are none.
#include "hilger/boundary/solve.hpp"
#include "hilger/scale/time_scale.hpp"
#include "hilger/scale/uniform.hpp"

using namespace hilger;

int main() {
    constexpr unknown q;
    constexpr lagrangian L{[](auto const&, auto const& v) { return v * v / 2; }};
#ifdef MUST_NOT_COMPILE
    time_scale<double> const T{0.0, 0.5, 1.0};
#else
    auto const T = uniform(0.0, 0.5, 2);
#endif
    (void)solve(variation(nabla_integral(L(q, Delta_minus(0.75)[q]), T)), T, {.q0 = 0, .qN = 1});
}
