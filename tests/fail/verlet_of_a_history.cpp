// SPDX-License-Identifier: BSL-1.0
// expect: flows with a history (fractional damping, Newmark) walk steps of one length from their first point on: they are not composed of parts of a step
// Stoermer-Verlet is order one over half a step, and its adjoint over the other half.
#include "hilger/composition/composition.hpp"
#include "hilger/fractional/flow.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
#ifdef MUST_NOT_COMPILE
    auto const flow = stoermer_verlet(with_fractional_damping(L, 0.1, fraction<1, 2>{}));
#else
    auto const flow = stoermer_verlet(L);
#endif
    for (auto const& x : flow.along(uniform(0.0, 0.1, 10), 1.0, 0.0)) (void)x;
}
