// SPDX-License-Identifier: BSL-1.0
// A trajectory kept in memory: its states, and why it stopped where it did not reach its end.
//   auto const run = record(flow.along(T, q0, p0));        run.states, run.positions(), run.momenta(), run.stopped
#pragma once

#include <optional>

#include "hilger/function/function.hpp"
#include "hilger/integrator/trajectory.hpp"

namespace hilger {

/// States in the order of time. The last one is where the walk ended, in good health or not.
template <class S, class V, class Scale>
struct recording {
    std::vector<state<S, V>> states;
    std::optional<std::string> stopped; ///< what() of the error that ended the walk, if one did
    Scale scale;

    /// q in C(T), one value per point. @throws error::mismatch when there is not one state for each point of T.
    [[nodiscard]] auto positions() const { return on_scale(&state<S, V>::q); }
    /// p in C(T), as above.
    [[nodiscard]] auto momenta() const { return on_scale(&state<S, V>::p); }

private:
    auto on_scale(V state<S, V>::*part) const {
        if (stopped)
            error::raise<error::mismatch>("a function on ", scale,
                                          " needs a trajectory that reaches its end, and this one stopped: ", *stopped);
        std::vector<V> values;
        values.reserve(states.size());
        for (auto const& x : states) values.push_back(x.*part);
        return function_on(scale, std::move(values));
    }
};

/// Walks a trajectory, or what is left of one, and keeps the first state, every stride-th one after it, and the last. Where a step fails
/// the states that were reached stay, and `stopped` says why. @throws error::invalid_parameter when stride < 1
template <class Path>
auto record(Path const& path, index_type stride = 1) {
    using state_type = std::remove_cvref_t<decltype(*path.begin())>;
    using S = decltype(state_type::t);
    using V = decltype(state_type::q);
    using Scale = std::remove_cvref_t<decltype(path.scale())>;
    if (stride < 1) error::raise<error::invalid_parameter>("a recording keeps every stride-th state, and its stride was given as ", stride);
    recording<S, V, Scale> result{{}, {}, path.scale()};
    auto at = path.begin();
    index_type walked = 0;
    bool kept = false; // is the state that `at` stands on
    state_type last = *at;
    try {
        for (; not(at == path.end()); ++at, ++walked) {
            last = *at;
            kept = walked % stride == 0;
            if (kept) result.states.push_back(last);
        }
    } catch (std::exception const& why) { // a failed step, or what the Lagrangian itself throws
        result.stopped = why.what();
    }
    if (not kept) result.states.push_back(std::move(last));
    return result;
}

} // namespace hilger
