// SPDX-License-Identifier: BSL-1.0
// expect: a fractional boundary value problem is solved on a uniform scale T, and this one is a scale of given points
// expect-clang: "a fractional boundary value problem is solved on a uniform scale T, and this one is " + time_scale<double>::kind()
// Fractional differences are convolutions; on unequal steps they are none.
#include "hilger/boundary/solve.hpp"
#include "hilger/scale/time_scale.hpp"

using namespace hilger;

int main() {
    fractional_problem const problem([](auto const&, auto const& v) { return v * v / 2; }, 0.75);
#ifdef MUST_NOT_COMPILE
    time_scale<double> const T{0.0, 0.5, 1.0};
#else
    auto const T = uniform(0.0, 0.5, 2);
#endif
    (void)solve_boundary(problem, T, 0, 1);
}
