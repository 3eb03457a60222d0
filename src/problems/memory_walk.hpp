// SPDX-License-Identifier: BSL-1.0
// Linear structures in text that remember, by Newmark's scheme.
#pragma once

#include "engine/methods/histories.hpp"
#include "engine/methods/newmark.hpp"
#include "stated_walk.hpp"

namespace program {

template <class S>
std::unique_ptr<walk> begin_with_memory(stated_problem const& what, configuration const& c) {
    std::unique_ptr<walk> made;
    auto const& begin = beginning_of<S>(what);
    engine::structure_of_problem<S> const structure(what.of);
    engine::with_history(c.history, c.steps, [&](auto const& policy) {
        structure.with_scheme(c.embedding, policy, [&](auto const& scheme) {
            made = walk_along(
                scheme.along(begin.scale(c.steps), engine::taken_by<S>(scheme, begin.q), engine::taken_by<S>(scheme, begin.p)), begin.seen);
        });
    });
    return made;
}

} // namespace program

/// In numbers S, compiled in a file of its own.
#define PROGRAM_WITH_MEMORY(S)                                                                                                             \
    template std::unique_ptr<program::walk> program::begin_with_memory<S>(program::stated_problem const&, program::configuration const&);
