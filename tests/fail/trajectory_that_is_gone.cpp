// SPDX-License-Identifier: BSL-1.0
// expect: an iterator refers to its trajectory, which ends here: keep the trajectory in a variable first
// An iterator walks the trajectory that it is from, which must still be there.
#include "hilger/integrator/flow.hpp"

using namespace hilger;

int main() {
    auto const flow = embed([](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; }, mid_point);
    auto const T = uniform(0.0, 0.1, 10);
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const at = flow.along(T, 1.0, 0.0).begin();
#else
    auto const path = flow.along(T, 1.0, 0.0);
    [[maybe_unused]] auto const at = path.begin();
#endif
}
