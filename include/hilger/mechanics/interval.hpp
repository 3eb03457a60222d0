// SPDX-License-Identifier: BSL-1.0
// A step by itself: a scale of two points, and a function given by its values at them. What an operator makes of these is what it does in
// every step.
#pragma once

#include "hilger/mechanics/action.hpp"

namespace hilger {

/// A scale of one step h; what an operator needs of it and no more.
template <class S>
struct single_step {
    using scalar_type = S;
    static constexpr bool is_uniform = true;
    static constexpr index_type extent = 1;
    S h;
    static constexpr index_type steps() { return 1; }
    constexpr S const& step(index_type) const { return h; }
    static constexpr bool same_points(single_step const&) { return true; }
};

namespace detail {
/// The function with values x and y at the two ends of a step; it refers to both.
template <class S, class V>
struct two_values : discrete_function_tag {
    using root_type = single_step<S>;
    using domain_type = hilger::domain<nodes>;
    root_type const* step;
    V const* x;
    V const* y;
    constexpr two_values(root_type const& T, V const& at_start, V const& at_end) : step(&T), x(&at_start), y(&at_end) {}
    constexpr root_type const& root() const { return *step; }
    static constexpr domain_type domain() { return {}; }
    constexpr V const& get(index_type i) const { return i == 0 ? *x : *y; }
};
} // namespace detail

} // namespace hilger
