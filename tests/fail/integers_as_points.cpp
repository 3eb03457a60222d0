// SPDX-License-Identifier: BSL-1.0
// expect: a time scale needs a scalar that can be divided, and its start was given as an integer
// The mid-point of 0 and 1 is no integer.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const T = uniform(0, 0.1, 10);
#else
    [[maybe_unused]] auto const T = uniform(0.0, 0.1, 10);
#endif
}
