// SPDX-License-Identifier: BSL-1.0
#include "engine/ensemble/whole_steps.hpp"

#include <algorithm>

namespace engine {

std::optional<states_in_whole_steps> walk_in_whole_steps(problem const& what, std::string const& method, points<double> const& T,
                                                         initial<double> const& from, std::function<walker()> const& alone,
                                                         std::function<bool(hilger::index_type done)> const& goes_on) {
    constexpr hilger::index_type at_once = 4096; // steps between two calls of goes_on
    auto const d = static_cast<std::size_t>(what.lagrangian.formula().words().dimension());
    if (static_cast<std::size_t>(from.q0.size()) != d or static_cast<std::size_t>(from.other.size()) != d) return {}; // engine reports it
    auto const code = lanes::of(what, method, T, lanes::alone);
    if (not code) return {};
    auto const begin = start_of(alone, {from, {}});
    if (not begin) return {};
    states_in_whole_steps made;
    auto const steps = T.steps;
    for (auto* x : {&made.q, &made.p}) x->reserve(d * static_cast<std::size_t>(steps + 1)), x->resize(d);
    lanes::group member(*code, {static_cast<std::size_t>(code->width()), *begin});
    for (std::size_t k = 0; k < d; ++k) made.q[k] = member.q(0, static_cast<int>(k)), made.p[k] = member.p(0, static_cast<int>(k));
    hilger::index_type done = 0;
    while (done < steps and not made.interrupted) {
        hilger::index_type const more = std::min(steps - done, at_once);
        std::size_t const to = made.q.size(); // resized for each stretch, so that it is in the cache when written
        for (auto* x : {&made.q, &made.p}) x->resize(to + d * static_cast<std::size_t>(more));
        member.walk(more, made.q.data() + to, made.p.data() + to);
        if (not member.is_well(0)) return {};
        done += more;
        made.interrupted = done < steps and not goes_on(done);
    }
    made.t = times_of(T, 0, done);
    return made;
}

} // namespace engine
