// SPDX-License-Identifier: BSL-1.0
// A pendulum's mid-point step as C99 that needs nothing but math.h: on the standard output, so that
//   generated_c > pendulum.c && cc -std=c99 -c pendulum.c
#include <iostream>

#include "hilger/hilger.hpp"
#include "hilger/text/c_code.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - (1 - cos(x)); }};

    formula const f = formula_of(L);
    std::cerr << "L     = " << f << '\n' << "dL/dq = " << f.by_q() << '\n' << "dL/dv = " << f.by_v() << '\n';

    std::cout << c_code(embed(L, mid_point), "pendulum");
    return std::cout.good() ? 0 : 1;
}
