// SPDX-License-Identifier: BSL-1.0
// expect: the slopes of a flow with fractional damping come from its history: give dense_output the path, dense_output(flow.along(T, q0, p0))
// The force of the damping is not in the states.
#include "hilger/fractional/flow.hpp"
#include "hilger/trajectory/dense_output.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
    auto const flow = embed(with_fractional_damping(L, 0.1, fraction<1, 2>{}), mid_point);
    auto const path = flow.along(uniform(0.0, 0.1, 10), 1.0, 0.0);
#ifdef MUST_NOT_COMPILE
    dense_output const between(flow.mechanics(), record(path).states);
#else
    dense_output const between(path);
#endif
    return between(0.55).q < 1 ? 0 : 1;
}
