// SPDX-License-Identifier: BSL-1.0
// expect: Delta_plus acts on functions on T, and extend makes functions on T_o
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
