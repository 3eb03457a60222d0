// SPDX-License-Identifier: BSL-1.0
// The step of a sum of actions: the nodes of all of them, each with the Lagrangian that is read there.
#pragma once

#include "hilger/step/tableau.hpp"
#include "hilger/variational/nodes/node_derivatives.hpp"
#include "hilger/variational/sum_of_actions.hpp"

namespace hilger {

/// One embedding for the first Lagrangian of a sum, and another one for the second.
template <class First, class Second>
struct embedding_sum {
    [[no_unique_address]] First first;
    [[no_unique_address]] Second second;
    static constexpr char const* name = "the embeddings of a sum of actions";
};
template <class First, class Second>
inline constexpr int controls_of<embedding_sum<First, Second>> = controls_of<First>;

/// The nodes of both.
template <class S, class First, class Second>
tableau<S> tableau_of(embedding_sum<First, Second> const& e, S const& h) {
    tableau<S> t = tableau_of(e.first, h);
    tableau<S> const u = tableau_of(e.second, h);
    auto const append = [](auto& to, auto const& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(t.position, u.position);
    append(t.velocity, u.velocity);
    append(t.weight, u.weight);
    append(t.inside, u.inside);
    if (t.part.empty()) t.part.assign(static_cast<std::size_t>(t.nodes), 0);
    int const next = t.part.back() + 1;
    for (int k = 0; k < u.nodes; ++k) t.part.push_back(next + u.part_of(k));
    t.nodes += u.nodes;
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

/// The derivatives of one of several Lagrangians.
template <class Problem, class V>
class node_of_sum;
template <class F, class G, class Force, class V>
class node_of_sum<problem<lagrangian_by_node<F, G>, Force>, V> {
    using S = scalar_of<V>;
    using what_type = problem<lagrangian_by_node<F, G>, Force>;

public:
    static constexpr bool has_room = false;
    /// To be of the Lagrangian with this number.
    void take(int part) {
        is_second_ = part >= parts_of<F>;
        if constexpr (requires { first_.take(part); })
            if (not is_second_) first_.take(part);
    }
    bool evaluate(what_type const& what, S const& t, V const& q, V const& v, wanted which) {
        return is_second_ ? second_.evaluate(what.second, t, q, v, which) : first_.evaluate(what.first, t, q, v, which);
    }
    [[nodiscard]] S const& value(int place) const { return is_second_ ? second_.value(place) : first_.value(place); }
    [[nodiscard]] S const& by_q(int k) const { return is_second_ ? second_.by_q(k) : first_.by_q(k); }
    [[nodiscard]] S const& by_v(int k) const { return is_second_ ? second_.by_v(k) : first_.by_v(k); }
    [[nodiscard]] derivative_places const& places() const { return is_second_ ? second_.places() : first_.places(); }
    [[nodiscard]] bool has_branches() const { return is_second_ ? second_.has_branches() : first_.has_branches(); }
    template <class X>
    void put_by_q(S const& c, X& to) const {
        is_second_ ? second_.put_by_q(c, to) : first_.put_by_q(c, to);
    }
    template <class X>
    void add_both(S const& a, S const& b, X& to) const {
        is_second_ ? second_.add_both(a, b, to) : first_.add_both(a, b, to);
    }
    template <class X>
    void add_by_q(S const& c, X& to) const {
        is_second_ ? second_.add_by_q(c, to) : first_.add_by_q(c, to);
    }
    template <class X>
    void add_by_v(S const& c, X& to) const {
        is_second_ ? second_.add_by_v(c, to) : first_.add_by_v(c, to);
    }

private:
    node_derivatives<problem<F, Force>, V> first_;
    node_derivatives<problem<G, no_force>, V> second_;
    bool is_second_ = false;
};
template <class F, class G, class Force, class V>
struct node_of<problem<lagrangian_by_node<F, G>, Force>, V> {
    using type = node_of_sum<problem<lagrangian_by_node<F, G>, Force>, V>;
};

} // namespace detail
} // namespace hilger
