// SPDX-License-Identifier: BSL-1.0
// An embedding on one step, in numbers: the ends U_0 = q_i and U_1 = q_{i+1} of the step give the position and the velocity at each node
// of the integral, A_k = sum_j position[k][j] U_j and B_k = sum_j velocity[k][j] U_j, and L_h = sum_k weight[k] L(A_k, B_k)
// (Cresson-Safi (47), (48) for mid-point). The numbers are what the embedding's operators make of unit functions; nothing is written per
// scheme.
#pragma once

#include <array>
#include <vector>

#include "hilger/embedding/embedding.hpp"
#include "hilger/embedding/galerkin.hpp"
#include "hilger/embedding/one_step.hpp"

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

/// What is known of an embedding before any number is: computed by its operators over a finite field, where equal means equal.
struct embedding_facts {
    bool one_node = false; ///< one node; constants have themselves as position and no velocity; weight and velocity cancel
    bool at_start = false; ///< and the position is q_i
    bool at_end = false;   ///< and the position is q_{i+1}
};
namespace detail {
template <class E>
inline constexpr embedding_facts facts_ = {};
template <linear_map A, linear_map B, class W, bool Checked>
    requires(not has_numbers<A, B> and reads_one_step<A, B>)
inline constexpr embedding_facts facts_<embedding<A, B, W, Checked>> = [] {
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

namespace detail {
/// Of an embedding: each value depends on few points; and they are the ends of one step.
template <class E>
inline constexpr bool is_local = true;
template <linear_map A, linear_map B, class W, bool Checked>
inline constexpr bool is_local<embedding<A, B, W, Checked>> = reads_few_points<A, B>;
template <class E>
inline constexpr bool is_on_one_step = true;
template <linear_map A, linear_map B, class W, bool Checked>
inline constexpr bool is_on_one_step<embedding<A, B, W, Checked>> = reads_one_step<A, B>;

/// @throws error::invalid_parameter when the numbers of an embedding are not consistent, in more than their rounding
template <class W, class S, linear_map A, linear_map B>
void require_consistent(A const& a, B const& b, S const& h, char const* name) {
    auto const near = [](S const& x, S const& y) { return magnitude(S(x - y)) <= S(16) * epsilon<S>(); };
    auto const refuse = [&](auto const&... what) {
        error::raise<error::invalid_parameter>(
            "the ", what..., ", and of the embedding \"", name,
            "\" not, so that it integrates another "
            "system; if that is meant, say make_embedding<Weight>(position, velocity, name, inconsistent)");
    };
    switch (examine<W>(a, b, h, near)) {
    case consistency::holds:
        return;
    case consistency::weights:
        refuse("weights of an embedding add up to the step h");
        break;
    case consistency::position_of_one:
        refuse("position operator of an embedding makes 1 of the constant 1");
        break;
    case consistency::velocity_of_one:
        refuse("velocity operator of an embedding makes 0 of the constant 1");
        break;
    case consistency::velocity_of_time:
        refuse("velocity operator of an embedding makes 1 of the function t");
        break;
    }
}
} // namespace detail

/// @throws error::invalid_parameter when numbers of the embedding that are known at run time only are not consistent
template <class S, linear_map A, linear_map B, class W, bool Checked>
tableau<S> tableau_of(embedding<A, B, W, Checked> const& e, S const& h) {
    if constexpr (Checked and detail::has_numbers<A, B> and ordered_scalar<S>)
        detail::require_consistent<W>(e.position, e.velocity, h, e.name);
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
/// Two Lobatto nodes are the ends of the step; more of any kind have control values inside (step/galerkin_table.hpp).
template <class S>
tableau<S> tableau_of(galerkin_embedding<2, lobatto> const&, S const& h) {
    S const slope = S(1) / h, half = h / S(2);
    return {2, {S(1), S(0), S(0), S(1)}, {-slope, slope, -slope, slope}, {half, half}};
}

} // namespace hilger
