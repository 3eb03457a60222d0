// SPDX-License-Identifier: BSL-1.0
#include "cost.hpp"
#include "engine/methods/damped.hpp"
#include "hilger/trajectory/requirements.hpp"

namespace program {

hilger::requirements requirements_with_force(stated_problem const& what, hilger::index_type steps) {
    auto const points = points_of(what, steps);
    auto const T = hilger::uniform(points.start, points.step, points.steps);
    hilger::initial_velocity<engine::vector<double>> const from{numbers_of(what.q), numbers_of(what.v)};
    auto const forced = engine::with_any_force(what.of);
    if (not what.of.has_memory()) return hilger::requirements_of(hilger::embed(forced, hilger::mid_point).along(T, from));
    // it is walked for some steps whatever T is
    auto const terms = engine::fractional_terms_of(what.of);
    return engine::use_at_mid_point(hilger::with_fractional_damping(forced, terms, hilger::exponentials{0.0, steps + 40}), terms,
                                    [&](auto const& flow) { return hilger::requirements_of(flow.along(T, from)); });
}

} // namespace program
