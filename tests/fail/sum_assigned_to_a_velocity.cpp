// SPDX-License-Identifier: BSL-1.0
// expect 1: instead of v += q or v = v + q, give the sum a name of its own
// expect 2: instead of v += q or v = v + q, give the sum a name of its own
// lines-clang 1: 30
// lines-clang 2: 30
// What q and v carry are derivatives of different kinds.
#include "hilger/integrator/flow.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto q, auto v) {
#if MUST_NOT_COMPILE == 1
        v += q;
        return v * v / 2 - q * q / 2;
#elif MUST_NOT_COMPILE == 2
        auto sum = v * v / 2;
        sum = sum - q * q / 2;
        return sum;
#else
        v *= 2.0; // numbers leave v what it is
        v = v + 1.0;
        auto const w = v + q;
        return w * w / 2 - q * q / 2;
#endif
    }};
    [[maybe_unused]] auto const path = embed(L, mid_point).along(uniform(0.0, 0.1, 10), 1.0, 0.0);
}
