// SPDX-License-Identifier: BSL-1.0
// expect: error: static assertion failed: the weights of an embedding add up to the step h
// expect: make_embedding<Weight>(position, velocity, name, inconsistent)
// Delta_plus belongs to the sum over the left ends of the steps.
#include "hilger/embedding/embedding.hpp"

using namespace hilger;

int main() {
#ifdef MUST_NOT_COMPILE
    constexpr auto mine = make_embedding<nabla_weight>(identity_T, Delta_plus, "mine");
#else
    constexpr auto mine = make_embedding<delta_weight>(identity_T, Delta_plus, "mine");
#endif
    return mine.name[0] == 'm' ? 0 : 1;
}
