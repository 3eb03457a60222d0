// SPDX-License-Identifier: BSL-1.0
// A pendulum's mid-point step as C99 that needs nothing but math.h: on the standard output, so that
//   generated_c > pendulum.c && cc -std=c99 -c pendulum.c
#include <iostream>

#include "hilger/formula/c_code.hpp"
#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - (1 - cos(x)); }};

    auto const q = variables<double>("q"), v = variables<double>("v");
    std::cerr << "L     = " << L(q, v) << '\n' << "dL/dq = " << partial(L(q, v), q) << '\n' << "dL/dv = " << partial(L(q, v), v) << '\n';

    std::cout << c_code(embed(L, mid_point), "pendulum");
    return std::cout.good() ? 0 : 1;
}
