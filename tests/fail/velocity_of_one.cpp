// SPDX-License-Identifier: BSL-1.0
// expect: error: static assertion failed: the velocity operator of an embedding makes 0 of the constant 1
// expect: make_embedding<Weight>(position, velocity, name, inconsistent)
// Position and velocity in the wrong order.
#include "hilger/embedding/embedding.hpp"

using namespace hilger;

int main() {
#ifdef MUST_NOT_COMPILE
    constexpr auto mine = make_embedding<delta_weight>(sigma, sigma, "mine");
#else
    constexpr auto mine = make_embedding<delta_weight>(sigma, Delta_plus, "mine");
#endif
    return mine.name[0] == 'm' ? 0 : 1;
}
