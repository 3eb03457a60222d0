// SPDX-License-Identifier: BSL-1.0
// expect 1: a time scale needs a scalar that can be divided, and its numbers were given as integers: write 0.0
// expect 2: a time scale needs a scalar that can be divided, and its numbers were given as integers: write 0.0
// expect 3: a time scale needs a scalar that can be divided, and its points were given as integers: write 0.0
// The mid-point of 0 and 1 is no integer. Beside a number that can be divided, integers become such numbers.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
#if not defined(MUST_NOT_COMPILE)
    [[maybe_unused]] auto const T = uniform(0, 0.1, 10);
    [[maybe_unused]] auto const U = uniform(interval{0, 1.0}, 10);
    [[maybe_unused]] auto const V = time_scale<double>{0, 1, 3};
#elif MUST_NOT_COMPILE == 1
    [[maybe_unused]] auto const T = uniform(0, 1, 10);
#elif MUST_NOT_COMPILE == 2
    [[maybe_unused]] auto const T = uniform(interval{0, 1}, 10);
#else
    [[maybe_unused]] auto const T = time_scale{0, 1, 3};
#endif
}
