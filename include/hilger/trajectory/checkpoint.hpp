// SPDX-License-Identifier: BSL-1.0
// A checkpoint as text that reads back exactly: built-in floating numbers in hexadecimal, wide ones with all their digits, rationals as
// they are. One labelled number a line, the version of the format in the first line and `end` in the last one. Before that stands the state
// that one step leads to, compared to half of the digits, so that another Lagrangian, force, damping or method is noticed unless that step
// is the same.
//   auto at = path.begin(); ...                       write_checkpoint(out, path, at.checkpoint());
//   for (auto [t, q, p] : path.resume(read_checkpoint(in, path))) ...
#pragma once

#include <istream>
#include <optional>
#include <ostream>
#include <string>

#include "hilger/history/component.hpp"
#include "hilger/trajectory/resuming.hpp"
#include "hilger/trajectory/trajectory.hpp"

namespace hilger {

namespace detail {

inline constexpr char const* checkpoint_version = "hilger checkpoint 2";

/// Visits all numbers of a checkpoint, in one order for writing and reading.
template <class S, class V, class Memory, class Method, class Visit>
void visit_checkpoint(checkpoint<S, V, Memory>& point, Method const& method, Visit& each) {
    static_assert(
        requires { point.memory.visit(method, each); }, "a method whose checkpoints are written has memory::visit(method, each)");
    each("point", point.number);
    each("time", point.at.t);
    memory::visit_components("position", point.at.q, each);
    memory::visit_components("momentum", point.at.p, each);
    point.memory.visit(method, each);
}

template <class Path>
inline constexpr bool goes_by_its_history = has_history<std::remove_cvref_t<decltype(std::declval<Path>().method())>>;
/// The length of the step that distinguishes problems at point i of `path`: the one after it, or at the end of T the one before.
template <class Path>
auto fingerprint_step(Path const& path, index_type i) {
    auto const& T = path.scale();
    return T.domain().base.step(T.root(), i < T.last() ? i : std::max(i - 1, T.first()));
}
/// The state after a step of length h from a checkpoint: without its memory, unless the method has a history, as with fractional damping.
/// Nothing where the step fails.
template <class Path, class S>
auto step_from(Path const& path, typename Path::checkpoint_type const& point, S const& h) {
    std::optional<std::remove_cvref_t<decltype(point.at)>> made;
    try {
        if constexpr (goes_by_its_history<Path>) {
            auto x = point.at;
            auto memory = point.memory;
            memory.advance(path.method(), x, h);
            made = std::move(x);
        } else
            made = path.method().step(point.at, h);
    } catch (std::exception const&) { // no fingerprint then
    }
    return made;
}
template <class S>
std::string scalar_line() {
    return std::numeric_limits<S>::is_exact ? std::string("scalar exact")
                                            : "scalar with " + std::to_string(std::numeric_limits<S>::digits) + " digits";
}

} // namespace detail

/// Writes a checkpoint of `path` as text, exactly.
template <class Path>
void write_checkpoint(std::ostream& out, Path const& path, typename Path::checkpoint_type point) {
    detail::line_writer writer{{detail::checkpoint_version, detail::scalar_line<decltype(point.at.t)>()}};
    detail::visit_checkpoint(point, path.method(), writer);
    auto const h = detail::fingerprint_step(path, point.number);
    auto next = detail::step_from(path, point, h);
    writer("step", next ? h : decltype(h)(0));
    if (next) {
        detail::memory::visit_components("leads_to_position", next->q, writer);
        detail::memory::visit_components("leads_to_momentum", next->p, writer);
    }
    for (std::string const& line : writer.lines) out << line << '\n';
    out << "end\n";
}

/// The checkpoint that write_checkpoint wrote for a trajectory of the same problem, method, scalar and dimension; `source` names it in
/// errors.
/// @throws error::unreadable, with the line and what is expected there; error::mismatch where a step from there leads elsewhere than it did
template <class Path>
typename Path::checkpoint_type read_checkpoint(std::istream& in, Path const& path, std::string const& source = "the input") {
    auto point = path.begin().checkpoint();
    std::vector<std::string> lines;
    for (std::string line; (lines.empty() or lines.back() != "end") and std::getline(in, line); lines.push_back(line))
        if (not line.empty() and line.back() == '\r') line.pop_back();
    detail::line_reader reader{lines, source};
    reader.require(detail::checkpoint_version);
    reader.require(detail::scalar_line<decltype(point.at.t)>());
    detail::visit_checkpoint(point, path.method(), reader);
    auto const own = detail::fingerprint_step(path, point.number);
    auto h = own;
    auto then = point.at;
    reader("step", h);
    bool const tells = not(h == decltype(h)(0));
    if (tells) {
        detail::memory::visit_components("leads_to_position", then.q, reader);
        detail::memory::visit_components("leads_to_momentum", then.p, reader);
    }
    reader.require("end");
    if (tells) {
        if (detail::goes_by_its_history<Path> and detail::square_root_of_epsilon<decltype(h)>() * h < magnitude(decltype(h)(own - h)))
            error::raise<error::mismatch>(source, " is a checkpoint of a walk in steps of ", h,
                                          ", whose memory does not go on in steps of ", own);
        auto const now = detail::step_from(path, point, h);
        if (not now or not detail::is_the_same(point.at.q, then.q, now->q) or not detail::is_the_same(point.at.p, then.p, now->p))
            error::raise<error::mismatch>(source, " is a checkpoint of another problem or method: a step of ", h,
                                          " from its state at t = ", point.at.t, now ? " leads elsewhere" : " fails",
                                          " here. With another Lagrangian, force or damping a new trajectory begins at that state");
    }
    return point;
}

} // namespace hilger
