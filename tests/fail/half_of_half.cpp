// SPDX-License-Identifier: BSL-1.0
// expect: half, circ and their lambda siblings are made from T, and this scale is T_half
// expect-clang: "half, circ and their lambda siblings are made from T, and this scale is " + domain<between<fraction<1, 2>>, 0, 0>::name() + "; for the points of a derived scale as a T of its own write time_scale(scale)"
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
