// SPDX-License-Identifier: BSL-1.0
// expect 1: the order P/Q of a fractional difference lies in ]0, 1] (Bourdin et al. (7)); orders up to 2 are products
// expect 2: the order P/Q of a fractional difference lies in ]0, 1] (Bourdin et al. (7)); orders up to 2 are products
// expect 3: the sum of these two orders of fractional differences has a denominator beyond the range of int
// expect 4: orders of fractional differences add up to 2 at most
// The variational formulas are those of orders up to one; a product of two is a difference of order up to two.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
#if not defined(MUST_NOT_COMPILE)
    static_assert(Delta_minus_alpha<3, 4> * Delta_minus_alpha<3, 4> == Delta_minus_alpha<1, 2> * Delta_minus_alpha<1, 1>);
    constexpr auto twice = Delta_minus_alpha<314159, 1'000'000> * Delta_minus_alpha<314159, 1'000'000>;
    static_assert(std::same_as<decltype(twice.order), fraction<314159, 500'000>>);
#elif MUST_NOT_COMPILE == 1
    (void)Delta_minus_alpha<3, 2>;
#elif MUST_NOT_COMPILE == 2
    (void)caputo_minus_alpha<0, 1>;
#elif MUST_NOT_COMPILE == 3
    (void)(Delta_minus_alpha<314159, 1'000'003> * Delta_minus_alpha<271828, 1'000'033>);
#else
    (void)(Delta_minus_alpha<3, 4> * Delta_minus_alpha<3, 4> * Delta_minus_alpha<3, 4>);
#endif
}
