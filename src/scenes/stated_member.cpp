// SPDX-License-Identifier: BSL-1.0
#include "stated_walk.hpp"

namespace program {

engine::walker walker_of_member(engine::problem const& one, configuration const& c, engine::points<double> const& T) {
    return [one, c, T](engine::initial<double> const& from, auto const& keep) {
        with_flow<double>(one, c, [&](auto const& flow) {
            hilger::initial_velocity<engine::vector<double>> const start{from.q0, from.other};
            for (auto const& x : flow.along(hilger::uniform(T.start, T.step, T.steps), start))
                if (not keep(x.t, x.q, x.p)) return;
        });
    };
}

} // namespace program
