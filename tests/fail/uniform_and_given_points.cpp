// SPDX-License-Identifier: BSL-1.0
// expect: a product needs both functions on one scale, and one lives on a uniform scale, the other on a scale of given points
// Their points may agree; the types do not know.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.5, 2);
    auto const U = time_scale{0.0, 0.5, 1.0};
    auto const formula = [](double t) { return t; };
    auto const f = function_on(U, formula);
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const g = function_on(T, formula) * f;
#else
    [[maybe_unused]] auto const g = function_on(time_scale(T), formula) * f;
#endif
}
