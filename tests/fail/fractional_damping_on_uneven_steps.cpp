// SPDX-License-Identifier: BSL-1.0
// expect: fractional damping lives on a uniform T, and this one has steps of different lengths
// Differences of fractional order are defined for one h.
#include "hilger/fractional/flow.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
    auto const flow = embed(with_fractional_damping(L, 0.1, fraction<1, 2>{}), mid_point);
#ifdef MUST_NOT_COMPILE
    time_scale<double> const T{0.0, 0.1, 0.3};
#else
    auto const T = uniform(0.0, 0.1, 2);
#endif
    [[maybe_unused]] auto const path = flow.along(T, 1.0, 0.0);
}
