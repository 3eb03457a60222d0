// SPDX-License-Identifier: BSL-1.0
// expect: a sum needs both functions on one scale, and they live on T and on T_o
// The values of f at the mid-points are somebody's choice: extend is one of them.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    auto const f = function_on(T, [](double t) { return t; });
    auto const g = function_on(circ(T), [](double t) { return t * t; });
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const sum = f + g;
#else
    [[maybe_unused]] auto const sum = extend[f] + g;
#endif
}
