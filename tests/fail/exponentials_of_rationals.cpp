// SPDX-License-Identifier: BSL-1.0
// expect: exponentials are accurate to a tolerance, for exact scalars there is direct
#include "hilger/history/history.hpp"
#include "hilger/multiprecision.hpp"

using namespace hilger;

int main() {
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const history = make_history<bdf<2>>(exponentials{}, Q(1, 2), Q(0));
#else
    [[maybe_unused]] auto const history = make_history<bdf<2>>(direct{}, Q(1, 2), Q(0));
#endif
}
