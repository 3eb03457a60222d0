// SPDX-License-Identifier: BSL-1.0
// expect: f[i] takes the number i of a point of T; the value at t is f(t)
// f[0.3] would be f[0].
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    auto const f = function_on(T, [](double t) { return t; });
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const y = f[0.3];
#else
    [[maybe_unused]] auto const y = f(0.3);
#endif
}
