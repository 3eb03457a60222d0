// SPDX-License-Identifier: BSL-1.0
// expect: the order of a fractional difference and the values of its history have the same scalar
#include "hilger/history/history.hpp"

using namespace hilger;

int main() {
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const history = make_history<bdf<2>>(direct{}, 0.5, 0.0F);
#else
    [[maybe_unused]] auto const history = make_history<bdf<2>>(direct{}, 0.5F, 0.0F);
#endif
}
