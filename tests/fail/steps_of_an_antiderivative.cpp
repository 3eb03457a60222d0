// SPDX-License-Identifier: BSL-1.0
// expect: error: static assertion failed: an action whose position or velocity reads all points before or after
// An antiderivative sums from the first point on.
#include "hilger/integrator/flow.hpp"

using namespace hilger;

int main() {
    constexpr unknown q;
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
    auto const T = uniform(0.0, 0.1, 10);
#ifdef MUST_NOT_COMPILE
    auto const S = integral(L(antiderivative[q], Delta_plus[q]), T);
#else
    auto const S = integral(L(q, Delta_plus[q]), T);
#endif
    for (auto const& x : flow_of(variation(S)).along(T, 1.0, 0.0)) (void)x;
}
