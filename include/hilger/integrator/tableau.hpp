// SPDX-License-Identifier: BSL-1.0
// An embedding on one step, in numbers: the ends U_0 = q_i and U_1 = q_{i+1} of the step give the position and the velocity at each node
// of the integral, A_k = sum_j position[k][j] U_j and B_k = sum_j velocity[k][j] U_j, and L_h = sum_k weight[k] L(A_k, B_k)
// (Cresson-Safi (47), (48) for mid-point). The numbers are what the embedding's operators make of unit functions; nothing is written per
// scheme.
#pragma once

#include <array>
#include <vector>

#include "hilger/adjoint/prime_field.hpp"
#include "hilger/embedding/embedding.hpp"
#include "hilger/embedding/galerkin.hpp"
#include "hilger/mechanics/interval.hpp"

namespace hilger {

template <class S>
struct tableau {
    int nodes = 1;
    std::vector<S> position, velocity; ///< nodes x 2, row by row; velocities carry 1/h
    std::vector<S> weight;             ///< carry h
    [[nodiscard]] S const& a(int k, int j) const { return position[static_cast<std::size_t>(2 * k + j)]; }
    [[nodiscard]] S const& b(int k, int j) const { return velocity[static_cast<std::size_t>(2 * k + j)]; }
    [[nodiscard]] S const& w(int k) const { return weight[static_cast<std::size_t>(k)]; }
    /// The time of node k in a step from t to t + h: the position operator on the function t -> t.
    [[nodiscard]] S time(int k, S const& t, S const& h) const { return t + a(k, 1) * h; }
};

namespace detail {

template <linear_map A, linear_map B, class W, class S>
struct on_one_step {
    using both = std::remove_cvref_t<decltype(intersect(std::declval<A const&>().image(domain<nodes>{}),
                                                        std::declval<B const&>().image(domain<nodes>{})))>;
    static constexpr index_type first = both::front;
    static constexpr index_type last = both::base_type::last(1) - both::back;
    static_assert(first <= last, "the position and velocity operators of an embedding reach over one step");
    static constexpr int nodes_ = static_cast<int>(last - first + 1);

    /// Op on the function with values x and y at the ends of a step h, at the node k.
    template <linear_map Op>
    static constexpr S value(Op const& op, S const& h, S const& x, S const& y, int k) {
        single_step<S> const T{h};
        two_values<S, S> const q(T, x, y);
        return S(op.evaluate(q, first + k));
    }
    static constexpr S weight(A const& a, B const& b, S const& h, int k) {
        single_step<S> const T{h};
        domain<nodes> const here;
        return S(W::at(T, intersect(a.image(here), b.image(here)).base, first + k));
    }
};

} // namespace detail

/// What is known of an embedding before any number is: computed by its operators over a finite field, where equal means equal.
struct embedding_facts {
    bool one_node = false; ///< one node; constants have themselves as position and no velocity; weight and velocity cancel
    bool at_start = false; ///< and the position is q_i
    bool at_end = false;   ///< and the position is q_{i+1}
};
namespace detail {
template <class E>
inline constexpr embedding_facts facts_ = {};
template <linear_map A, linear_map B, class W>
    requires(std::is_empty_v<A>and std::is_empty_v<B>)
inline constexpr embedding_facts facts_<embedding<A, B, W>> = [] {
    using F = prime_field;
    using step = on_one_step<A, B, W, F>;
    if (step::nodes_ != 1) return embedding_facts{};
    F const h(7919), one(1), zero(0);
    bool const plain = step::value(A{}, h, one, one, 0) == one and step::value(B{}, h, one, one, 0) == zero and
                       step::value(B{}, h, zero, one, 0) * step::weight(A{}, B{}, h, 0) == one;
    return embedding_facts{plain, plain and step::value(A{}, h, zero, one, 0) == zero, plain and step::value(A{}, h, one, zero, 0) == zero};
}();
} // namespace detail
template <class E>
inline constexpr embedding_facts facts_of = detail::facts_<std::remove_cvref_t<E>>;

/// The number of control values of a step, known by the type.
template <class E>
inline constexpr int controls_of = 2;

template <class S, linear_map A, linear_map B, class W>
tableau<S> tableau_of(embedding<A, B, W> const& e, S const& h) {
    using step = detail::on_one_step<A, B, W, S>;
    tableau<S> t;
    t.nodes = step::nodes_;
    for (int k = 0; k < t.nodes; ++k) {
        t.weight.push_back(step::weight(e.position, e.velocity, h, k));
        for (int j = 0; j < 2; ++j) {
            S const x(1 - j), y(j);
            t.position.push_back(step::value(e.position, h, x, y, k));
            t.velocity.push_back(step::value(e.velocity, h, x, y, k));
        }
    }
    return t;
}

template <int Stages, class Quadrature>
inline constexpr int controls_of<galerkin_embedding<Stages, Quadrature>> = galerkin_embedding<Stages, Quadrature>::degree + 1;

/// One Gauss node is mid-point.
namespace detail {
template <>
inline constexpr embedding_facts facts_<galerkin_embedding<1, gauss>> = facts_of<decltype(mid_point)>;
}
template <class S>
tableau<S> tableau_of(galerkin_embedding<1, gauss> const&, S const& h) {
    return tableau_of(mid_point, h);
}
/// Two Lobatto nodes are the ends of the step; more of any kind have control values inside (integrator/galerkin_table.hpp).
template <class S>
tableau<S> tableau_of(galerkin_embedding<2, lobatto> const&, S const& h) {
    S const slope = S(1) / h, half = h / S(2);
    return {2, {S(1), S(0), S(0), S(1)}, {-slope, slope, -slope, slope}, {half, half}};
}

} // namespace hilger
