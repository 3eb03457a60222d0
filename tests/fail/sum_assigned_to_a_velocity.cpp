// SPDX-License-Identifier: BSL-1.0
// expect: instead of v += q, give the sum a name of its own
// lines-clang: 30
// What q and v carry are derivatives of different kinds.
#include "hilger/integrator/flow.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto q, auto v) {
#ifdef MUST_NOT_COMPILE
        v += q;
        return v * v / 2 - q * q / 2;
#else
        v *= 2.0; // numbers leave v what it is
        auto const w = v + q;
        return w * w / 2 - q * q / 2;
#endif
    }};
    [[maybe_unused]] auto const path = embed(L, mid_point).along(uniform(0.0, 0.1, 10), 1.0, 0.0);
}
