// SPDX-License-Identifier: BSL-1.0
// expect: takes two states of any number type, as [](auto const& q, auto const& v) does
// Derivatives pass through a Lagrangian as numbers of another type.
#include "hilger/integrator/flow.hpp"

using namespace hilger;

int main() {
#ifdef MUST_NOT_COMPILE
    auto const L = [](double q, double v) { return v * v / 2 - q * q / 2; };
#else
    auto const L = [](auto q, auto v) { return v * v / 2 - q * q / 2; };
#endif
    [[maybe_unused]] auto const path = embed(L, mid_point).along(uniform(0.0, 0.1, 10), 1.0, 0.0);
}
