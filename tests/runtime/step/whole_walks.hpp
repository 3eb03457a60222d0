// SPDX-License-Identifier: BSL-1.0
// Walks that are to come to their ends, whatever kind of state they are of.
#pragma once

#include <algorithm>
#include <concepts>
#include <optional>

#include <doctest/doctest.h>

#include "hilger/hilger.hpp"

namespace hilger::testing {

template <class V>
V all(int d, double x) {
    if constexpr (std::same_as<V, double>)
        return x;
    else
        return V::Constant(d, x);
}

/// The largest position and momentum of a walk.
struct extent {
    double q = 0, p = 0;
};
/// Checks that a walk has all of its states. Nothing where it has not.
template <class Walk>
std::optional<extent> walked_whole(Walk const& walk, int steps) {
    extent most;
    int points = 0;
    CHECK_NOTHROW([&] {
        for (auto const& x : walk) {
            ++points;
            most.q = std::max(most.q, magnitude(x.q));
            most.p = std::max(most.p, magnitude(x.p));
        }
    }());
    CHECK(points == steps + 1);
    return points == steps + 1 ? std::optional(most) : std::nullopt;
}

} // namespace hilger::testing
