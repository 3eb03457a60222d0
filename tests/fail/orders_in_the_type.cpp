// SPDX-License-Identifier: BSL-1.0
// expect 1: the order P/Q of a fractional difference has a positive denominator and lies in [-100, 100]
// expect 2: the order P/Q of a Caputo difference lies in ]0, 1]: it is of f - f(a), without a derivative at a
// expect 3: the sum of these two orders of fractional differences has a denominator beyond the range of int
// expect 4: the order of a fractional difference lies in [-100, 100]
// expect 5: the order P/Q of a Caputo difference lies in ]0, 1]: it is of f - f(a), without a derivative at a
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
#if not defined(MUST_NOT_COMPILE)
    static_assert(Delta_minus_alpha<3, 4> * Delta_minus_alpha<3, 4> == Delta_minus_alpha<3, 2>);
    static_assert(Delta_minus_alpha<3, 4> * Delta_minus_alpha<3, 4> * Delta_minus_alpha<3, 4> == Delta_minus_alpha<9, 4>);
    constexpr auto twice = Delta_minus_alpha<314159, 1'000'000> * Delta_minus_alpha<314159, 1'000'000>;
    static_assert(std::same_as<decltype(twice.order), fraction<314159, 500'000>>);
#elif MUST_NOT_COMPILE == 1
    (void)Delta_minus_alpha<1, 0>;
#elif MUST_NOT_COMPILE == 2
    (void)caputo_minus_alpha<0, 1>;
#elif MUST_NOT_COMPILE == 3
    (void)(Delta_minus_alpha<314159, 1'000'003> * Delta_minus_alpha<271828, 1'000'033>);
#elif MUST_NOT_COMPILE == 4
    (void)(Delta_minus_alpha<75, 1> * Delta_minus_alpha<75, 1>);
#else
    (void)caputo_minus_alpha<3, 2>;
#endif
}
