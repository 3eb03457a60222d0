// SPDX-License-Identifier: BSL-1.0
// expect: a sum of operators needs one scale to map to, and pi_inverse maps to T_half, Delta_plus to T
// expect-clang: "a sum of operators needs one scale to map to, and " + projection<fraction<1, 2>, true>::name() + " maps to " + between<fraction<1, 2>>::name() + ", " + derivative<nodes, hilger::side::plus>::name() + " to " + nodes::name()
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
