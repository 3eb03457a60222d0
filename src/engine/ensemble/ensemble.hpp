// SPDX-License-Identifier: BSL-1.0
// One motion from many initial values, in threads and in the lanes of the processor's registers. Members do not know of each other: results
// do not depend on the number of threads or on who else is there, and a member that fails loses nobody else's.
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "engine/ensemble/lanes.hpp"

namespace engine {

struct ensemble {
    hilger::index_type members = 0, points = 0; ///< points that are kept of each
    int dimension = 0;
    std::vector<double> t, q, p;       ///< q and p: members x points x dimension, NaN where a member did not get to
    std::vector<std::string> failures; ///< of each member, "" where it came to the end
    [[nodiscard]] std::size_t place(hilger::index_type member, hilger::index_type point) const {
        return static_cast<std::size_t>((member * points + point) * dimension);
    }
};

/// The same with other meanings of the parameters in it.
problem with_words(problem const& what, hilger::text::vocabulary const& words);

/// Walks from there as a motion does.
using walker = std::function<void(initial<double> const& from,
                                  std::function<bool(double const& t, vector<double> const& q, vector<double> const& p)> const& keep)>;
inline walker walker_of(std::shared_ptr<motion<double> const> path) {
    return [path = std::move(path)](auto const& from, auto const& keep) { path->walk(from, keep); };
}

/// What all members are, and how each is walked alone.
struct cast {
    problem what;
    points<double> T;
    std::function<walker(problem const&)> make;
    walker common; ///< of all, where no parameter is brought by the members
    std::unique_ptr<lanes> together;
};
/// With `in_lanes`, members step together where that is possible.
cast make_cast(problem const& what, std::string const& method, points<double> const& T, bool in_lanes,
               std::function<walker(problem const&)> make);

struct member {
    initial<double> from;
    std::vector<double> parameters; ///< those that what.lagrangian's words say states bring
};

/// Where a member begins in its lane, which may take a first step alone; nothing where that fails, which is told where it is walked alone.
std::optional<lanes::start> start_of(std::function<walker()> const& alone, member const& who);

/// The first one, every stride-th and the last.
constexpr hilger::index_type points_kept(hilger::index_type steps, hilger::index_type stride) {
    return steps / stride + 1 + (steps % stride != 0 ? 1 : 0);
}
/// Keeps the first state, every stride-th and the last one of each. Stops where `stop` becomes true, `done` members being whole. Without
/// lanes each member is what its motion makes of it, to the last bit; who fails in a lane is walked again so.
/// @throws hilger::error::invalid_parameter when stride < 1 or threads < 1; hilger::error::mismatch when a member has not as many
///         coordinates as L, or fewer parameters than states bring
ensemble walk_all(cast const& all, std::vector<member> const& from, hilger::index_type stride, int threads, std::atomic<bool> const& stop,
                  std::atomic<hilger::index_type>& done);

} // namespace engine
