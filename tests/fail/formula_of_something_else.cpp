// SPDX-License-Identifier: BSL-1.0
// expect: a function on T is made from a formula that takes its points, or from a std::vector of its values
// The points of T are doubles.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    struct angle {};
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const f = function_on(T, [](angle) { return 1.0; });
#else
    [[maybe_unused]] auto const f = function_on(T, [](double) { return 1.0; });
#endif
}
