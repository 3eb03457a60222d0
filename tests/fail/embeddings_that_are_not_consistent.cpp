// SPDX-License-Identifier: BSL-1.0
// expect 1: the weights of an embedding add up to the step h, and these do not
// expect 2: the position operator of an embedding makes 1 of the constant 1, and this one does not
// expect 3: the velocity operator of an embedding makes 0 of the constant 1, and this one does not
// expect 4: the velocity operator of an embedding makes 1 of the function t, and this one does not
// expect 5: the velocities at the nodes of an embedding determine the values inside the step, and here they are too few
// expect 6: the velocities at the nodes of an embedding determine the values inside the step, and here they are too few
// An embedding that is not consistent integrates another system: it is refused, or said to be meant.
#include "hilger/embedding/embedding.hpp"
#include "hilger/embedding/galerkin.hpp"

using namespace hilger;

int main() {
    constexpr auto velocity = pi_inverse * Delta_plus;
    constexpr fraction<3, 2> scaled{};
#if not defined(MUST_NOT_COMPILE)
    constexpr auto mine = make_embedding<step_weight>(on_half * extend, fraction<1, 2>{} * (velocity + velocity), "mine");
    [[maybe_unused]] constexpr auto enough =
        make_embedding<step_weight>(polynomial_value<2, lobatto, 2>{}, polynomial_slope<2, lobatto, 2>{}, "enough");
    [[maybe_unused]] constexpr auto meant = make_embedding<delta_weight>(scaled * identity_T, Delta_plus, "meant", inconsistent);
#elif MUST_NOT_COMPILE == 1 // Delta_plus belongs to the sum over the left ends of the steps
    constexpr auto mine = make_embedding<nabla_weight>(identity_T, Delta_plus, "mine");
#elif MUST_NOT_COMPILE == 2
    constexpr auto mine = make_embedding<delta_weight>(scaled * identity_T, Delta_plus, "mine");
#elif MUST_NOT_COMPILE == 3 // a position for a velocity
    constexpr auto mine = make_embedding<delta_weight>(sigma, sigma, "mine");
#elif MUST_NOT_COMPILE == 5
    constexpr auto mine = make_embedding<step_weight>(polynomial_value<2, gauss, 1>{}, polynomial_slope<2, gauss, 1>{}, "mine");
#elif MUST_NOT_COMPILE == 6
    constexpr auto mine = make_embedding<step_weight>(polynomial_value<4, lobatto, 3>{}, polynomial_slope<4, lobatto, 3>{}, "mine");
#else
    constexpr auto mine = make_embedding<step_weight>(on_half * extend, fraction<2>{} * velocity, "mine");
#endif
    return mine.name[0] == 'm' ? 0 : 1;
}
