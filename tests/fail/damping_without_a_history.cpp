// SPDX-License-Identifier: BSL-1.0
// expect: a damping is given by its coefficient, its order, a history as direct{}, blocks{} or exponentials{}, and its options
#include "hilger/fractional/flow.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const damped = with_fractional_damping(L, 0.1, 0.5, damping_options{initial_history::caputo});
#else
    [[maybe_unused]] auto const damped = with_fractional_damping(L, 0.1, 0.5, direct{}, {initial_history::caputo});
#endif
}
