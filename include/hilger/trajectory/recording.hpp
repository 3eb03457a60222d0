// SPDX-License-Identifier: BSL-1.0
// A trajectory kept in memory. record throws what a step throws; with keep_partial it returns the states reached, and `stopped` says why
// and where the run ended.
//   auto const run = record(flow.along(T, q0, p0));                  run.states, run.positions(), run.momenta()
//   auto const part = record(flow.along(T, q0, p0), keep_partial);   if (part.stopped) std::cerr << *part.stopped;
#pragma once

#include <optional>

#include "hilger/function/function.hpp"
#include "hilger/trajectory/trajectory.hpp"
#include "hilger/whole_number.hpp"

namespace hilger {

/// Requests the states reached by a trajectory that stops before its end.
inline constexpr struct keep_partial_t {
} keep_partial{};

/// States in the order of time up to the end of the run, possibly incomplete: see stopped.
template <class S, class V, class Scale>
struct recording {
    std::vector<state<S, V>> states;
    std::optional<std::string> stopped; ///< what() of the error that ended the run, if one did: with keep_partial only
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

namespace detail {

template <class Path>
using recording_of = recording<std::remove_cvref_t<decltype((*std::declval<Path const&>().begin()).t)>,
                               std::remove_cvref_t<decltype((*std::declval<Path const&>().begin()).q)>,
                               std::remove_cvref_t<decltype(std::declval<Path const&>().scale())>>;

/// A stride, given as 10 or 1e3. @throws error::invalid_parameter where it is not a positive whole number
template <arithmetic N>
index_type whole_stride(N stride) {
    auto const count = whole(stride);
    if (not count or *count < 1)
        error::raise<error::invalid_parameter>(
            "a recording keeps every stride-th state, a whole number from 1, and its stride was given as ", stride);
    return *count;
}
/// Records states, always with the last one reached, also when a step throws.
template <class Path>
void record_into(recording_of<Path>& to, Path const& path, index_type stride) {
    auto at = path.begin();
    if (at == path.end()) return; // a range of events may be empty
    auto last = *at;
    bool kept = false; // whether the state at `at` is
    auto const finish = [&] {
        if (not kept) to.states.push_back(std::move(last));
    };
    try {
        for (index_type walked = 0; not(at == path.end()); ++at, ++walked) {
            last = *at;
            kept = walked % stride == 0;
            if (kept) to.states.push_back(last);
        }
    } catch (...) {
        finish();
        throw;
    }
    finish();
}

/// @throws error::mismatch where there is not one state for each point of T
template <class S, class V, class Scale>
void require_complete(recording<S, V, Scale> const& run) {
    if (run.stopped or std::ssize(run.states) != run.scale.size())
        error::raise<error::mismatch>("a recording is judged that has a state at each point of ", run.scale, ", and this one has ",
                                      run.states.size());
}

} // namespace detail

/// Computes a trajectory, or the rest of one, and records the first state, every stride-th one after it, and the last.
/// @throws error::invalid_parameter when stride < 1 or not whole, and what steps throw, without a result
template <class Path, detail::arithmetic N = index_type>
[[nodiscard]] auto record(Path const& path, N stride = 1) {
    auto const every = detail::whole_stride(stride);
    detail::recording_of<Path> result{{}, {}, path.scale()};
    detail::record_into(result, path, every);
    return result;
}
/// The same, with the states reached where a step fails, the last of them at any stride: check `stopped`, which says why and where. @throws
/// error::invalid_parameter as above
template <class Path, detail::arithmetic N>
[[nodiscard]] auto record(Path const& path, N stride, keep_partial_t) {
    auto const every = detail::whole_stride(stride);
    detail::recording_of<Path> result{{}, {}, path.scale()};
    try {
        detail::record_into(result, path, every);
    } catch (std::exception const& why) { // a failed step, or what the Lagrangian itself throws
        result.stopped = why.what();
    }
    return result;
}
template <class Path>
[[nodiscard]] auto record(Path const& path, keep_partial_t) {
    return record(path, index_type(1), keep_partial);
}

} // namespace hilger
