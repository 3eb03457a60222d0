// SPDX-License-Identifier: BSL-1.0
// expect: error: static assertion failed: the position operator of an embedding makes 1 of the constant 1
// expect: make_embedding<Weight>(position, velocity, name, inconsistent)
// Half as far again is another system, or it is meant.
#include "hilger/embedding/embedding.hpp"

using namespace hilger;

int main() {
#ifdef MUST_NOT_COMPILE
    constexpr auto mine = make_embedding<delta_weight>(fraction<3, 2>{} * identity_T, Delta_plus, "mine");
#else
    constexpr auto mine = make_embedding<delta_weight>(fraction<3, 2>{} * identity_T, Delta_plus, "mine", inconsistent);
#endif
    return mine.name[0] == 'm' ? 0 : 1;
}
