// SPDX-License-Identifier: BSL-1.0
// expect: a walk goes along a time scale, as uniform(0.0, 0.1, 100) or time_scale{0.0, 0.1, 0.3}
#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    auto const L = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const path = embed(L, mid_point).along(std::vector<double>{0, 0.1, 0.3}, 1.0, 0.0);
#else
    [[maybe_unused]] auto const path = embed(L, mid_point).along(time_scale{0.0, 0.1, 0.3}, 1.0, 0.0);
#endif
}
