// SPDX-License-Identifier: BSL-1.0
// expect: half, circ and their lambda siblings are made from T, and this scale is T_half
// The points of a derived scale make a T of their own when asked to.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const S = half(half(T));
#else
    [[maybe_unused]] auto const S = half(time_scale(half(T)));
#endif
}
