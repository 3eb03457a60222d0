// SPDX-License-Identifier: BSL-1.0
// expect: Delta_minus_alpha<1/2> has the weights of one step h, and this function lives on
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
#ifdef MUST_NOT_COMPILE
    time_scale<double> const T{0.0, 1.0, 2.0};
#else
    auto const T = uniform(0.0, 1.0, 2);
#endif
    auto const f = function_on(T, [](double t) { return t; });
    [[maybe_unused]] auto const g = Delta_minus_alpha<1, 2>[f];
}
