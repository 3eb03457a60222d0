// SPDX-License-Identifier: BSL-1.0
// expect: a Lagrangian takes two states of any number type
#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    auto const L = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };
#ifdef MUST_NOT_COMPILE
    auto const M = [](double q, double v) { return v * v / 2 - q * q / 2; };
    [[maybe_unused]] auto const run = record(embed(M, mid_point).along(uniform(0.0, 0.1, 10), 1.0, 0.5));
#else
    [[maybe_unused]] auto const run = record(embed(L, mid_point).along(uniform(0.0, 0.1, 10), 1.0, 0.5));
#endif
}
