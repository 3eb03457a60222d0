// SPDX-License-Identifier: BSL-1.0
// expect: on_half acts on functions on T_o, and this one lives on T_{o,1/3}
// Every lambda has scales of its own.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    auto const f = function_on(T, [](double t) { return t; });
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const g = on_half[extend_lambda<1, 3>[f]];
#else
    [[maybe_unused]] auto const g = on_lambda<1, 3>[extend_lambda<1, 3>[f]];
#endif
}
