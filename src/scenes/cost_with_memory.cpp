// SPDX-License-Identifier: BSL-1.0
#include "cost.hpp"
#include "engine/methods/newmark.hpp"
#include "hilger/history/history.hpp"
#include "hilger/trajectory/requirements.hpp"

namespace program {

hilger::requirements requirements_of_structure(stated_problem const& what, hilger::index_type steps, bool whole) {
    auto const points = points_of(what, steps);
    auto const T = hilger::uniform(points.start, points.step, points.steps);
    engine::vector<double> const q = numbers_of(what.q), v = numbers_of(what.v);
    engine::structure_of_problem<double> const structure(what.of);
    hilger::requirements needs{};
    auto const count = [&](auto const& scheme) {
        hilger::initial_velocity const from{engine::taken_by<double>(scheme, q), engine::taken_by<double>(scheme, v)};
        needs = hilger::requirements_of(scheme.along(T, from));
    };
    if (whole)
        structure.with_weights<hilger::bdf<2>>(hilger::direct{}, count);
    else // it is walked for some steps whatever T is
        structure.with_weights<hilger::bdf<2>>(hilger::exponentials{0.0, steps + 40}, count);
    return needs;
}

} // namespace program
