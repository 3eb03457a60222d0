// SPDX-License-Identifier: BSL-1.0
// Free problems of few coordinates. Each number of them is compiled in a file of its own, which takes its time (src/program.cmake).
#pragma once

#include "stated_walk.hpp"

namespace program {

template <class S, int D, method_kind Kind>
std::unique_ptr<walk> begin_small(stated_problem const& what, configuration const& c) {
    using V = Eigen::Matrix<S, D, 1>;
    auto const& begin = beginning_of<S>(what);
    auto const& L = known_to<engine::small_lagrangian<S, D>>(what, [&] { return engine::small_lagrangian<S, D>(what.of.lagrangian); });
    std::unique_ptr<walk> made;
    auto const use = [&](auto const& flow) { made = walk_along(flow.along(begin.scale(c.steps), begin.template from<V>()), begin.seen); };
    if constexpr (Kind == method_kind::without_inner_points) with_number<S>(what.of, begin, c, L, use);
    with_method<Kind, S>(c.embedding, L, use);
    return made;
}

} // namespace program

#define PROGRAM_SMALL(S, D, kind)                                                                                                          \
    template std::unique_ptr<program::walk> program::begin_small<S, D, program::method_kind::kind>(stated_problem const&,                  \
                                                                                                   configuration const&);
