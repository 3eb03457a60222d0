// SPDX-License-Identifier: BSL-1.0
// expect: error: static assertion failed: position and velocity of an embedding that is stepped read the two ends of one step
// The second difference has an equation, and its residual, but no flow of position and momentum.
#include "hilger/integrator/flow.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
    auto const T = uniform(0.0, 0.1, 10);
#ifdef MUST_NOT_COMPILE
    constexpr auto mine = make_embedding<delta_weight>(identity_T, fraction<1, 2>{} * (Delta_plus + sigma * Delta_plus), "two steps");
#else
    constexpr auto mine = make_embedding<delta_weight>(identity_T, fraction<1, 2>{} * (Delta_plus + Delta_plus), "one step");
#endif
    for (auto const& x : embed(L, mine).along(T, 1.0, 0.0)) (void)x;
}
