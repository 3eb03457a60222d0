// SPDX-License-Identifier: BSL-1.0
// expect: this needs a function on T^{+}, and the one given lives on T^{+-}
// f has no value at the first point, where the integral starts.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    auto const f = function_on(T, [](double t) { return t; });
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const s = integral(restrict_to(f, interior(T)), T);
#else
    [[maybe_unused]] auto const s = integral(restrict_to(f, without_last(T)), T);
#endif
}
