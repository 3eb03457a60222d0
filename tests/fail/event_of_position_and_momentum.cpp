// SPDX-License-Identifier: BSL-1.0
// expect: events are where a function of a state passes zero, as [](auto const& x) { return x.q; } does
// A state is one thing, with its time.
#include "hilger/integrator/flow.hpp"
#include "hilger/trajectory/events.hpp"

using namespace hilger;

int main() {
    auto const path =
        embed([](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; }, mid_point).along(uniform(0.0, 0.1, 10), 1.0, 0.0);
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const turns = events(path, [](auto const&, auto const& p) { return p; });
#else
    [[maybe_unused]] auto const turns = events(path, [](auto const& x) { return x.p; });
#endif
}
