// SPDX-License-Identifier: BSL-1.0
// expect: a step with fractional damping depends on all steps before it: walk along(T, q0, p0)
// One state does not say how the next one is reached.
#include "hilger/fractional/flow.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
    state<double, double> const start{0.0, 1.0, 0.0};
#ifdef MUST_NOT_COMPILE
    auto const flow = embed(with_fractional_damping(L, 0.1, fraction<1, 2>{}), mid_point);
#else
    auto const flow = embed(L, mid_point);
#endif
    [[maybe_unused]] auto const next = flow.step(start, 0.1);
}
