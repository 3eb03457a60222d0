// SPDX-License-Identifier: BSL-1.0
// expect: at Radau's nodes a fractional damping is a power of Delta, with a history exponentials{tolerance}
#include "hilger/fractional/flow.hpp"
#include "hilger/history/history.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const flow = embed(with_fractional_damping(L, 0.1, 0.5, direct{}), galerkin<2, radau>);
#else
    [[maybe_unused]] auto const flow = embed(with_fractional_damping(L, 0.1, 0.5, exponentials{1e-10}), galerkin<2, radau>);
#endif
}
