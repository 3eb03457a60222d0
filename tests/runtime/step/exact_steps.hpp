// SPDX-License-Identifier: BSL-1.0
// How tests of adjoints and compositions compare steps with ==, in the rationals.
#pragma once

#include "hilger/composition/composition.hpp"
#include "support/systems.hpp"

namespace hilger::testing {

/// Quadratic with a gyroscopic term and the time in it: steps are exact in the rationals.
inline constexpr auto driven = [](auto const& t, auto const& x, auto const& v) {
    return v * v / 2 + v * x * t / 3 - x * x / 2 + t * t * x;
};

inline state<Q, Q> const start{Q(1, 7), Q(1), Q(1, 2)};
inline Q const h(1, 5);

template <class Flow>
bool undoes(Flow const& f) {
    return adjoint(f).step(f.step(start, h), Q(-h)) == start and f.step(adjoint(f).step(start, h), Q(-h)) == start;
}
template <class F, class G>
bool steps_as(F const& f, G const& g) {
    return f.step(start, h) == g.step(start, h);
}

} // namespace hilger::testing
