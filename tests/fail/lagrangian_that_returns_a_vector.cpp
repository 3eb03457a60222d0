// SPDX-License-Identifier: BSL-1.0
// expect: a Lagrangian L(q, v) returns a number, and this one returns something else, a vector perhaps
#include "hilger/integrator/flow.hpp"

using namespace hilger;

int main() {
#ifdef MUST_NOT_COMPILE
    auto const L = [](auto const& q, auto const& v) { return (v - q).eval(); };
#else
    auto const L = [](auto const& q, auto const& v) { return (v - q).dot(v); };
#endif
    using vector = Eigen::Vector2d;
    [[maybe_unused]] auto const path = embed(L, mid_point).along(uniform(0.0, 0.1, 10), vector(1, 0), vector(0, 1));
}
