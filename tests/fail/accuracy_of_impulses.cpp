// SPDX-License-Identifier: BSL-1.0
// expect: with a memory an accuracy is for with_fractional_damping, and not for impulses
#include "hilger/fractional/accuracy.hpp"
#include "hilger/history/history.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
#ifdef MUST_NOT_COMPILE
    (void)solve(with_fractional_impulses(L, 0.1, 0.5), interval{0.0, 1.0}, {.q0 = 1.0, .v0 = 0.0}, accuracy{1e-3});
#else
    (void)solve(with_fractional_damping(L, 0.1, 0.5), interval{0.0, 1.0}, {.q0 = 1.0, .v0 = 0.0}, accuracy{1e-3});
#endif
}
