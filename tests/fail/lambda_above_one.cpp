// SPDX-License-Identifier: BSL-1.0
// expect: lambda lies in [0, 1[
// T_lambda lies between the points of T.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const S = at_lambda<3, 2>(T);
#else
    [[maybe_unused]] auto const S = at_lambda<2, 3>(T);
#endif
}
