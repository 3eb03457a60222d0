// SPDX-License-Identifier: BSL-1.0
// expect: fractional damping lives on a uniform T, and this one has steps of different lengths
// So has a structure's.
#include "hilger/fractional/newmark.hpp"

using namespace hilger;

int main() {
    auto const scheme = newmark<bdf<2>>(fractional_structure{1.0, 1.0, 1.0, 1.0, 0.5}, [](double) { return 1.0; });
#ifdef MUST_NOT_COMPILE
    time_scale<double> const T{0.0, 0.1, 0.3};
#else
    auto const T = uniform(0.0, 0.1, 2);
#endif
    [[maybe_unused]] auto const path = scheme.along(T, 0.0, 0.0);
}
