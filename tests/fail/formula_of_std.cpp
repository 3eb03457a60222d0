// SPDX-License-Identifier: BSL-1.0
// expect 1: write sin(q), pow(q, 2), max(q, 0.0) without std:: in a Lagrangian, Hamiltonian or force
// expect 2: write sin(q), pow(q, 2), max(q, 0.0) without std:: in a Lagrangian, Hamiltonian or force
// expect 3: write sin(q), pow(q, 2), max(q, 0.0) without std:: in a Lagrangian, Hamiltonian or force
// expect 4: no matching function for call to 'max(
// expect-clang 4: no matching function for call to 'max'
// expect 5: log2 is none of the functions of numbers with derivatives: write log(q) / std::log(2.0)
// lines 4: 45
// Functions of std take plain numbers; those of numbers with derivatives are found by their arguments. (std::max is a template for two
// arguments of one type, of which the compiler lists the candidates itself; the sentence follows.)
#include "hilger/integrator/flow.hpp"

using namespace hilger;

int main() {
    auto const L = [](auto const& q, auto const& v) {
#if not defined(MUST_NOT_COMPILE)
        return v * v / 2 - (q > 0 ? cos(q) : 0.0);
#elif MUST_NOT_COMPILE == 1
        return v * v / 2 - std::cos(q);
#elif MUST_NOT_COMPILE == 2
        return v * v / 2 - std::pow(q, 2);
#elif MUST_NOT_COMPILE == 3
        return v * v / 2 - std::abs(q * v);
#elif MUST_NOT_COMPILE == 4
        return v * v / 2 - std::max(q, 0.0);
#else
        return v * v / 2 - log2(q);
#endif
    };
    for (auto const& x : embed(L, mid_point).along(uniform(0.0, 0.1, 10), 1.0, 0.0)) (void)x;
}
