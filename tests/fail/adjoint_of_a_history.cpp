// SPDX-License-Identifier: BSL-1.0
// expect: a flow with a history (fractional damping, Newmark) has no adjoint: its steps depend on all steps before them
#include "hilger/composition/composition.hpp"
#include "hilger/fractional/flow.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const flow = adjoint(embed(with_fractional_impulses(L, 0.1, fraction<1, 2>{}), mid_point));
#else
    [[maybe_unused]] auto const flow = adjoint(embed(L, mid_point));
#endif
}
