// SPDX-License-Identifier: BSL-1.0
// expect: Delta_plus acts on functions on T, and extend makes functions on T_o
// expect-clang: derivative<nodes, hilger::side::plus>::name() + " acts on functions on " + nodes::name() + ", and " + extension<fraction<1, 2>>::name() + " makes functions on " + joined<fraction<1, 2>>::name()
// The extension leads to T_o, the derivative starts at T.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] constexpr auto A = Delta_plus * extend;
#else
    [[maybe_unused]] constexpr auto A = Delta_o_plus * extend;
#endif
}
