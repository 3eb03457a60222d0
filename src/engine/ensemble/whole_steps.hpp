// SPDX-License-Identifier: BSL-1.0
// One trajectory by steps compiled to machine code as a whole (the code of lanes.hpp, for one member). It takes the time of the same system
// written in C++, and agrees with the engine to rounding.
#pragma once

#include <functional>
#include <optional>

#include "engine/ensemble/ensemble.hpp"

namespace engine {

/// States at the points of T, q and p of points x coordinates.
struct states_in_whole_steps {
    std::vector<double> t, q, p;
    bool interrupted = false; ///< holds the points before the interruption
};
/// `alone` is the engine's walk, which may make the first step; `goes_on` is called between stretches of steps with the number of steps so
/// far. Nothing when lanes::of does not support the problem or a step fails: the engine then starts anew and reports the reason.
std::optional<states_in_whole_steps> walk_in_whole_steps(problem const& what, std::string const& method, points<double> const& T,
                                                         initial<double> const& from, std::function<walker()> const& alone,
                                                         std::function<bool(hilger::index_type done)> const& goes_on);

} // namespace engine
