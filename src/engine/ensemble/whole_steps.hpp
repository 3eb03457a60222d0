// SPDX-License-Identifier: BSL-1.0
// One trajectory by steps that are machine code as a whole, where otherwise the formulas in them are: what lanes.hpp has for many members,
// for one. It takes the time of the same system written in C++, and agrees to rounding with what the engine makes.
#pragma once

#include <functional>
#include <optional>

#include "engine/ensemble/ensemble.hpp"

namespace engine {

/// States at the points of T, q and p of points x coordinates.
struct states_in_whole_steps {
    std::vector<double> t, q, p;
    bool interrupted = false; ///< it has the points before
};
/// `alone` is how the engine walks it, which may make the first step; `goes_on` is asked between stretches of steps with the number of
/// those made. Nothing where lanes::of has nothing for the problem, or where a step fails: the engine, from the beginning, says why.
std::optional<states_in_whole_steps> walk_in_whole_steps(problem const& what, std::string const& method, points<double> const& T,
                                                         initial<double> const& from, std::function<walker()> const& alone,
                                                         std::function<bool(hilger::index_type done)> const& goes_on);

} // namespace engine
