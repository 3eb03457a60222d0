// SPDX-License-Identifier: BSL-1.0
// expect: error: static assertion failed: the velocity operator of an embedding makes 1 of the function t
// expect: make_embedding<Weight>(position, velocity, name, inconsistent)
// Twice the velocity.
#include "hilger/embedding/embedding.hpp"

using namespace hilger;

int main() {
#ifdef MUST_NOT_COMPILE
    constexpr auto mine = make_embedding<step_weight>(on_half * extend, fraction<2>{} * (pi_inverse * Delta_plus), "mine");
#else
    constexpr auto mine =
        make_embedding<step_weight>(on_half * extend, fraction<1, 2>{} * (pi_inverse * (Delta_plus + Delta_plus)), "mine");
#endif
    return mine.name[0] == 'm' ? 0 : 1;
}
