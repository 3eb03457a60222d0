// SPDX-License-Identifier: BSL-1.0
// expect 1: flows with a history (fractional damping, Newmark) walk steps of one length from their first point on: they are not composed of parts of a step
// expect 2: the parts of a step are those of its type: compose(shares<fraction<1, 3>, fraction<2, 3>>{}, f, g), or those of a method as suzuki<4>
// Each part would remember the points of its own kind alone.
#include "hilger/composition/methods.hpp"
#include "hilger/fractional/flow.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
#if not defined(MUST_NOT_COMPILE)
    auto const flow = compose(suzuki<4>, embed(L, mid_point));
#elif MUST_NOT_COMPILE == 1
    auto const flow = compose(suzuki<4>, embed(with_fractional_damping(L, 0.1, fraction<1, 2>{}), mid_point));
#else
    auto const flow = compose(std::array{0.5, 0.5}, embed(L, mid_point));
#endif
    for (auto const& x : flow.along(uniform(0.0, 0.1, 10), 1.0, 0.0)) (void)x;
}
