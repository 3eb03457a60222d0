// SPDX-License-Identifier: BSL-1.0
// expect: a variation is that of an action, as integral(L(q, Delta_plus[q]), T)
#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    auto const L = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };
#ifdef MUST_NOT_COMPILE
    constexpr unknown q;
    [[maybe_unused]] auto const EL = variation(lagrangian{L}(q, Delta_plus[q]));
#else
    constexpr unknown q;
    [[maybe_unused]] auto const EL = variation(integral(lagrangian{L}(q, Delta_plus[q]), uniform(0.0, 0.1, 10)));
#endif
}
