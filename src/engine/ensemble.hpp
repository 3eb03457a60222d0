// SPDX-License-Identifier: BSL-1.0
// One motion from many initial values, in threads. Each member is computed as if it were alone: results do not depend on the number of
// threads, and a member that fails loses nobody else's.
#pragma once

#include <atomic>

#include "engine/engine.hpp"

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

/// Keeps the first state, every stride-th and the last one of each. Stops where `stop` becomes true, `done` members being whole.
/// @throws hilger::error::invalid_parameter when stride < 1 or threads < 1
ensemble walk_all(motion<double> const& path, std::vector<initial<double>> const& from, hilger::index_type stride, int threads,
                  std::atomic<bool> const& stop, std::atomic<hilger::index_type>& done);

} // namespace engine
