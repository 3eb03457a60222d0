// SPDX-License-Identifier: BSL-1.0
// Systems in text that remember: fractional damping along the embeddings that have it, and linear structures by Newmark's scheme.
#pragma once

#include "engine/methods/damped.hpp"
#include "engine/methods/newmark.hpp"
#include "engine/motions.hpp"
#include "stated_walk.hpp"

namespace program {

/// What is damped may be driven too.
inline engine::forced_problem with_any_force(engine::problem const& of) {
    if (of.force) return {of.lagrangian, *of.force};
    auto const words = std::make_shared<hilger::text::vocabulary>(of.lagrangian.formula().words());
    std::vector<hilger::text::stated> const none(static_cast<std::size_t>(words->dimension()),
                                                 hilger::text::stated(hilger::text::expression(), words, "the force"));
    return {of.lagrangian, hilger::text::stated_force(none)};
}
/// Calls use(flow) with the one that is chosen, where there is one in numbers S.
template <class S, class Use>
void with_memory_flow(engine::problem of, configuration const& c, Use const& use) {
    of.history = c.history;
    if (engine::is_newmark(c.embedding)) {
        engine::structure_of_problem<S> const structure(of);
        engine::with_history(of.history, c.steps, [&](auto const& policy) { structure.with_scheme(c.embedding, policy, use); });
    }
    if constexpr (std::same_as<S, double>) // of many digits Newmark's schemes are exact enough to compare with
        if (c.embedding == "mid-point")
            engine::with_damped(of, with_any_force(of), c.steps, [&](auto const& how) { use(hilger::embed(how, hilger::mid_point)); });
}
template <class S>
std::unique_ptr<walk> begin_with_memory(stated_problem const& what, configuration const& c) {
    std::unique_ptr<walk> made;
    auto const& begin = beginning_of<S>(what);
    with_memory_flow<S>(what.of, c, [&](auto const& flow) {
        made = walk_along(flow.along(begin.scale(c.steps), engine::taken_by<S>(flow, begin.q), engine::taken_by<S>(flow, begin.p)),
                          begin.seen);
    });
    return made;
}

} // namespace program

/// In numbers S, compiled in a file of its own.
#define PROGRAM_WITH_MEMORY(S)                                                                                                             \
    template std::unique_ptr<program::walk> program::begin_with_memory<S>(program::stated_problem const&, program::configuration const&);
