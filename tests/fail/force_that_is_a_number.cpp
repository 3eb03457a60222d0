// SPDX-License-Identifier: BSL-1.0
// expect: a force is a state like q: a number for a number, a vector for a vector
// lines-clang: 45
#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    auto const L = [](auto const& q, auto const& v) { return v.dot(v) / 2 - q.dot(q) / 2; };
#ifdef MUST_NOT_COMPILE
    auto const drag = [](auto const&, auto const& v) { return -v(0); };
#else
    auto const drag = [](auto const&, auto const& v) { return (-1 * v).eval(); };
#endif
    Eigen::Vector2d const x(1, 0);
    for (auto const& at : embed(with_force(L, drag), mid_point).along(uniform(0.0, 0.1, 10), x, x)) (void)at;
}
