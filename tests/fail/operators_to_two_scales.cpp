// SPDX-License-Identifier: BSL-1.0
// expect: a sum of operators needs one scale to map to, and pi_inverse maps to T_half, Delta_plus to T
// The two summands make functions on different scales.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] constexpr auto A = pi_inverse + Delta_plus;
#else
    [[maybe_unused]] constexpr auto A = pi_inverse + pi_inverse * Delta_plus;
#endif
}
