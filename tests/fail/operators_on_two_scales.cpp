// SPDX-License-Identifier: BSL-1.0
// expect: a sum of operators needs one scale to act on, and sigma acts on T, rho_o on T_o
// The two summands act on functions on different scales.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] constexpr auto A = sigma + rho_o;
#else
    [[maybe_unused]] constexpr auto A = sigma_o + rho_o;
#endif
}
