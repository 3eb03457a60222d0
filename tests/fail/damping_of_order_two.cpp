// SPDX-License-Identifier: BSL-1.0
// expect: the order of a fractional damping lies in ]0, 2[
// An order of 2 is a mass.
#include "hilger/fractional/flow.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const damped = with_fractional_damping(L, 0.1, fraction<4, 2>{});
#else
    [[maybe_unused]] auto const damped = with_fractional_damping(L, 0.1, fraction<3, 2>{});
#endif
}
