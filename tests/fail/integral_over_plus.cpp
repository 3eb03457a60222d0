// SPDX-License-Identifier: BSL-1.0
// expect: integrate over a whole scale: T, half(T), circ(T), or between two points
// The integral from a to b is over T; T^+ is where its integrand lives.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    auto const f = function_on(T, [](double t) { return t; });
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const s = integral(f, without_last(T));
#else
    [[maybe_unused]] auto const s = integral(f, T);
#endif
}
