// SPDX-License-Identifier: BSL-1.0
// expect: a damping is given by its coefficient, its order, a history as direct{}, blocks{} or exponentials{} and, for impulses, its options
#include "hilger/fractional/flow.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const damped = with_fractional_impulses(L, 0.1, 0.5, impulse_options{.at = damping_at::end});
#else
    [[maybe_unused]] auto const damped = with_fractional_impulses(L, 0.1, 0.5, direct{}, {.at = damping_at::end});
#endif
}
