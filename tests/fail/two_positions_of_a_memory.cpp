// SPDX-License-Identifier: BSL-1.0
// expect: with fractional damping, and of structures, a trajectory begins at {.q0 = ..., .v0 = ...}
// What a memory adds to the first step is no part of two positions.
#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; }};
    auto const damped = embed(with_fractional_damping(L, 0.2, 0.5), mid_point);
    auto const T = uniform(0.0, 0.1, 10);
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const path = damped.along(T, {.q0 = 1.0, .q1 = 1.0});
#else
    [[maybe_unused]] auto const path = damped.along(T, {.q0 = 1.0, .v0 = 0.0});
#endif
}
