// SPDX-License-Identifier: BSL-1.0
// expect: C code is that of a flow of one embedding with plain sums and without a history
#include "hilger/hilger.hpp"
#include "hilger/text/c_code.hpp"

using namespace hilger;

int main() {
    auto const L = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };
#ifdef MUST_NOT_COMPILE
    auto const flow = compose(suzuki<4>, embed(L, mid_point));
    [[maybe_unused]] auto const text = c_code(flow, "step");
#else
    auto const flow = embed(L, mid_point);
    [[maybe_unused]] auto const text = c_code(flow, "step");
#endif
}
