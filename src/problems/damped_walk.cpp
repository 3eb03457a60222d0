// SPDX-License-Identifier: BSL-1.0
// Systems in text with fractional damping, along the embedding that has it. In double: of many digits Newmark's schemes are exact enough to
// compare with.
#include "engine/methods/damped.hpp"
#include "stated_walk.hpp"

namespace program {

std::unique_ptr<walk> begin_damped(stated_problem const& what, configuration const& c) {
    std::unique_ptr<walk> made;
    if (c.embedding != "mid-point") return made;
    auto const& begin = beginning_of<double>(what);
    engine::problem of = what.of;
    of.history = c.history;
    engine::with_damped(of, engine::with_any_force(of), c.steps,
                        [&](auto const& flow) { made = walk_along(flow.along(begin.scale(c.steps), begin.from()), begin.seen); });
    return made;
}

} // namespace program
