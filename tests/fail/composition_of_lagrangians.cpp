// SPDX-License-Identifier: BSL-1.0
// expect: what is composed are flows, as embed(L, mid_point), and not Lagrangians or embeddings
#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    auto const L = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const flow = compose(suzuki<4>, L);
#else
    [[maybe_unused]] auto const flow = compose(suzuki<4>, embed(L, mid_point));
#endif
}
