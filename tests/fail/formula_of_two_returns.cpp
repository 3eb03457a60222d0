// SPDX-License-Identifier: BSL-1.0
// expect 1: 'hilger::jet<double, 1, 1, 2>' and 'hilger::jet<double, 0, 2, 2>' deduced for lambda return type
// expect-clang 1: 'auto' in return type deduced as
// lines 1: 65
// expect 2: expected primary-expression before ')' token
// expect-clang 2: missing 'template' keyword prior to dependent template name 'head'
// What a compiler says of a lambda before anything of hilger sees it: a function has one type, and < is an operator in what is generic.
#include "hilger/integrator/flow.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
#if not defined(MUST_NOT_COMPILE)
    auto const L = [](auto const& q, auto const& v) -> decltype(q + v) {
        if (q > 0) return v * v / 2;
        return v * v / 2 - q * q / 2;
    };
    auto const M = [](auto const& q, auto const& v) { return v.squaredNorm() / 2 - q.head(1).sum() - q.template head<1>().sum(); };
    for (auto const& x : embed(M, mid_point).along(T, Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1))) (void)x;
#elif MUST_NOT_COMPILE == 1
    auto const L = [](auto const& q, auto const& v) {
        if (q > 0) return v * v / 2;
        return v * v / 2 - q * q / 2;
    };
#else
    auto const L = [](auto const& q, auto const& v) { return v * v / 2 - q.head<1>().sum(); };
#endif
    for (auto const& x : embed(L, mid_point).along(T, 1.0, 0.0)) (void)x;
}
