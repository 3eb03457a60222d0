// SPDX-License-Identifier: BSL-1.0
// expect: the lambda of theta<P, Q> lies in ]0, 1[; at its ends are order_one and order_one_left
#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    auto const L = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const flow = embed(L, theta<3, 2>);
#else
    [[maybe_unused]] auto const flow = embed(L, theta<2, 3>);
#endif
}
