// SPDX-License-Identifier: BSL-1.0
// expect: a force changes the energy, and here it is constant
// lines-clang: 45
#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    auto const L = [](auto const& q, auto const& v) { return v.dot(v) / 2 - q.dot(q) / 2; };
    auto const drag = [](auto const&, auto const& v) { return (-1 * v).eval(); };
    auto const forced = with_force(L, drag);
#ifdef MUST_NOT_COMPILE
    (void)transform_time(forced, sundman(1), 0.5);
#else
    (void)transform_time(forced, sundman(1));
#endif
}
