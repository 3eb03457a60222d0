// SPDX-License-Identifier: BSL-1.0
// expect: a function is used on its own scale, and this one lives on a scale of given points and is needed on a uniform scale of another type
// The scale of the integral is the scale of the function.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.5, 2);
    auto const f = function_on(time_scale{0.0, 0.5, 1.0}, [](double t) { return t; });
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const s = integral(f, T);
#else
    [[maybe_unused]] auto const s = integral(f, time_scale(T));
#endif
}
