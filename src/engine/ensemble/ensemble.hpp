// SPDX-License-Identifier: BSL-1.0
// One motion from many initial values, in threads and in the lanes of the processor's registers. Members are independent: results do not
// depend on the number of threads or on the other members, and a failure affects only its own member.
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "engine/ensemble/lanes.hpp"

namespace engine {

struct ensemble {
    hilger::index_type members = 0, points = 0; ///< kept of each member
    int dimension = 0;
    std::vector<double> t, q, p;       ///< q and p: members x points x dimension, NaN if not reached
    std::vector<std::string> failures; ///< of each member, "" if it reached the end
    [[nodiscard]] std::size_t place(hilger::index_type member, hilger::index_type point) const {
        return static_cast<std::size_t>((member * points + point) * dimension);
    }
};

/// The same problem with other values of its parameters.
problem with_words(problem const& what, hilger::text::vocabulary const& words);

/// Walks from the initial values as a motion does.
using walker = std::function<void(initial<double> const& from,
                                  std::function<bool(double const& t, vector<double> const& q, vector<double> const& p)> const& keep)>;
inline walker walker_of(std::shared_ptr<motion<double> const> path) {
    return [path = std::move(path)](auto const& from, auto const& keep) { path->walk(from, keep); };
}

/// The properties common to all members, and the walk of a single one.
struct cast {
    problem what;
    points<double> T;
    std::function<walker(problem const&)> make;
    walker common; ///< of all members, when they bring no parameters
    std::unique_ptr<lanes> together;
};
/// With `in_lanes`, members step together if possible.
cast make_cast(problem const& what, std::string const& method, points<double> const& T, bool in_lanes,
               std::function<walker(problem const&)> make);

struct member {
    initial<double> from;
    std::vector<double> parameters; ///< the parameters that vary between members
};

/// The start of a member in its lane, possibly after one step alone. Nothing when that step fails: the walk of the member alone reports it.
std::optional<lanes::start> start_of(std::function<walker()> const& alone, member const& who);

/// The number of kept points: the first one, every stride-th and the last.
constexpr hilger::index_type points_kept(hilger::index_type steps, hilger::index_type stride) {
    return steps / stride + 1 + (steps % stride != 0 ? 1 : 0);
}
/// Keeps the first state, every stride-th and the last one of each member. When `stop` becomes true, `done` members are complete. Without
/// lanes each member equals its motion to the last bit; a member that fails in a lane is walked again alone.
/// @throws hilger::error::invalid_parameter when stride < 1 or threads < 1; hilger::error::mismatch when a member has other than d
/// coordinates, or too few parameters
ensemble walk_all(cast const& all, std::vector<member> const& from, hilger::index_type stride, int threads, std::atomic<bool> const& stop,
                  std::atomic<hilger::index_type>& done);

} // namespace engine
