// SPDX-License-Identifier: BSL-1.0
// The interval Lagrangian L_h(x, y): the action on a scale of one step with x at its start and y at its end (Cresson-Safi (47), (48)). Its
// derivatives are the two momenta, p_i = -d_1 L_h(q_i, q_{i+1}) and p_{i+1} = d_2 L_h(q_i, q_{i+1}).
#pragma once

#include "hilger/mechanics/action.hpp"

namespace hilger {

/// A scale of one step h; what an operator needs of it and no more.
template <class S>
struct single_step {
    using scalar_type = S;
    static constexpr bool is_uniform = true;
    static constexpr index extent = 1;
    S h;
    static constexpr index steps() { return 1; }
    constexpr S const& step(index) const { return h; }
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
    constexpr V const& get(index i) const { return i == 0 ? *x : *y; }
};
} // namespace detail

/// L_h of the embedding (A, B, int with weights W) of L, as a generic function of two states.
template <class F, linear_map A, linear_map B, class W, class S>
struct interval_lagrangian {
    F function;
    [[no_unique_address]] A position;
    [[no_unique_address]] B velocity;
    single_step<S> T;

    template <class V>
    constexpr auto operator()(V const& x, V const& y) const {
        detail::two_values<S, V> const q(T, x, y);
        auto const Aq = position.image(q.domain());
        auto const Bq = velocity.image(q.domain());
        auto const both = intersect(Aq, Bq);
        using image = std::remove_cvref_t<decltype(both)>;
        constexpr index first = image::front;
        constexpr index last = image::base_type::last(1) - image::back;
        static_assert(first <= last, "the position and velocity operators of an embedding reach over one step");
        auto const term = [&](index i) {
            auto const at = plain_t<decltype(position.evaluate(q, i))>(position.evaluate(q, i));
            auto const v = plain_t<decltype(velocity.evaluate(q, i))>(velocity.evaluate(q, i));
            return function(at, v) * W::at(T, both.base, i);
        };
        auto total = term(first);
        for (index i = first + 1; i <= last; ++i) total = total + term(i);
        return total;
    }
};

} // namespace hilger
