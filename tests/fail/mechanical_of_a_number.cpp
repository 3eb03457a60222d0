// SPDX-License-Identifier: BSL-1.0
// expect: mechanical(mass, U) is for states that are Eigen vectors: for numbers write
#include "hilger/integrator/flow.hpp"
#include "hilger/models/mechanical.hpp"

using namespace hilger;

int main() {
#ifdef MUST_NOT_COMPILE
    mechanical const L{2.0, [](auto const& q) { return q * q / 2; }};
#else
    auto const L = [](auto const& q, auto const& v) { return v * v - q * q / 2; };
#endif
    [[maybe_unused]] auto const path = embed(L, mid_point).along(uniform(0.0, 0.1, 10), 1.0, 0.0);
}
