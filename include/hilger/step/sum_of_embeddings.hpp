// SPDX-License-Identifier: BSL-1.0
// The step of a sum of actions: the nodes of all of them, each with its own Lagrangian.
#pragma once

#include "hilger/step/tableau.hpp"
#include "hilger/variational/nodes/node_derivatives.hpp"
#include "hilger/variational/sum_of_actions.hpp"

namespace hilger {

/// The embedding of a sum of two Lagrangians: one for each.
template <class First, class Second>
struct embedding_sum {
    [[no_unique_address]] First first;
    [[no_unique_address]] Second second;
    static constexpr char const* name = "the embeddings of a sum of actions";
};
template <class First, class Second>
inline constexpr int controls_of<embedding_sum<First, Second>> = controls_of<First>;

namespace detail {
/// Appends the nodes of u to those of t, with the next numbers of Lagrangians.
template <class S>
void append_nodes(tableau<S>& t, tableau<S> const& u) {
    auto const append = [](auto& to, auto const& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(t.position, u.position);
    append(t.velocity, u.velocity);
    append(t.weight, u.weight);
    append(t.inside, u.inside);
    if (t.part.empty()) t.part.assign(static_cast<std::size_t>(t.nodes), 0);
    int const next = t.part.back() + 1;
    for (int k = 0; k < u.nodes; ++k) t.part.push_back(next + u.part_of(k));
    t.nodes += u.nodes;
    t.integrates_slopes = false; // each Lagrangian gives only a part of the momentum
}
} // namespace detail
/// The tableau of both for steps of length h: nodes of the first, then of the second.
template <class S, class First, class Second>
tableau<S> tableau_of(embedding_sum<First, Second> const& e, S const& h) {
    tableau<S> t = tableau_of(e.first, h);
    detail::append_nodes(t, tableau_of(e.second, h));
    return t;
}

namespace detail {

template <class First, class Second>
inline constexpr bool is_local<embedding_sum<First, Second>> = is_local<First>and is_local<Second>;
template <class First, class Second>
inline constexpr bool is_on_one_step<embedding_sum<First, Second>> = is_on_one_step<First>and is_on_one_step<Second>;

template <class S>
constexpr auto embedding_of(S const& s) {
    if constexpr (is_action_sum<S>) {
        auto const first = embedding_of(s.first);
        auto const second = embedding_of(s.second);
        return embedding_sum<std::remove_const_t<decltype(first)>, std::remove_const_t<decltype(second)>>{first, second};
    } else
        return make_embedding<typename S::weight>(s.position, s.velocity, "the embedding of an action");
}

/// Each node evaluates one of the Lagrangians; the whole is their sum.
template <class F, class G, class Force, class V>
struct problems_at_nodes<problem<lagrangian_by_node<F, G>, Force>, V> {
    given<problem<F, Force>, V> first;
    given<problem<G, no_force>, V> second;
    explicit problems_at_nodes(problem<lagrangian_by_node<F, G>, Force> const& what) : first(what.first), second(what.second) {}
    given_problem<V> const* operator()(int k) const { return k < parts_of<F> ? &first.part(k) : &second; }
};

} // namespace detail
} // namespace hilger
