// SPDX-License-Identifier: BSL-1.0
// expect: expressions of one unknown are multiplied in a Lagrangian
// lines: 60
// lines-clang: 40
// A lambda is what a Lagrangian is made of.
#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    constexpr unknown q;
#ifdef MUST_NOT_COMPILE
    auto const L = [](auto, auto v) { return v * v / 2; };
#else
    constexpr lagrangian L{[](auto, auto v) { return v * v / 2; }};
#endif
    [[maybe_unused]] auto const EL = variation(integral(L(q, Delta_plus[q]), T));
}
