// SPDX-License-Identifier: BSL-1.0
// How tests compare a run with the same one stopped, written down, read back and resumed.
#pragma once

#include <sstream>

#include <doctest/doctest.h>

#include "hilger/trajectory/checkpoint.hpp"
#include "support/systems.hpp"

namespace hilger::testing {

/// The number of states that differ between one run and the same stopped after `first` steps.
template <class Path>
int differences(Path const& path, hilger::index_type first) {
    auto at = path.begin();
    std::stringstream text;
    for (hilger::index_type i = 0; i < first; ++i) ++at;
    auto const kept = at.checkpoint();
    write_checkpoint(text, path, kept);
    auto const read = read_checkpoint(text, path);
    CHECK(read.number == first);
    auto const from_memory = path.resume(kept), from_text = path.resume(read);
    auto x = from_memory.begin(), y = from_text.begin();
    int count = 0;
    for (; at != path.end(); ++at, ++x, ++y) count += not(*x == *at) or not(*y == *at);
    CHECK((x == from_memory.end() and y == from_text.end()));
    return count;
}
template <class S>
auto pendulum_path(auto const& flow, hilger::index_type steps) {
    return flow.along(uniform(S(0), S(1) / S(10), steps), S(1), S(1) / S(3));
}

} // namespace hilger::testing
