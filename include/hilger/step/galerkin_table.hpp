// SPDX-License-Identifier: BSL-1.0
// The numbers of a Galerkin step. Its velocity is the polynomial through values V_j at the R Gauss points g_j of [0, 1], R its degree plus
// one, and with nodes c_k and weights w_k, k = 1, ..., N, l_j the polynomial that is 1 at g_j and 0 at the others, and gamma_j its
// integral,
//   A_k = q_0 + h sum_j alpha_kj V_j,   B_k = sum_j beta_kj V_j,   alpha_kj = integral of l_j from 0 to c_k,   beta_kj = l_j(c_k).
// That L_h is stationary for q_0 and q_1 = q_0 + h sum_j gamma_j V_j given, with p_0 = -d_1 L_h, says for j = 1, ..., R
//   1/gamma_j sum_k w_k beta_kj dL/dv(A_k, B_k) = p_0 + h sum_k momentum_jk dL/dq(A_k, B_k),   momentum_jk = w_k (1 - alpha_kj / gamma_j),
// and p_1 = p_0 + h sum_k w_k dL/dq. For Gauss nodes (c = g) that is Gauss collocation: momentum = alpha, beta = 1. Where dL/dv = Mv the
// left side is M V_j, both quadratures being exact for l_i l_j, and then (Nystroem's form)
//   A_k = q_0 + h c_k v_0 + h^2 sum_m twice_km M^-1 dL/dq(A_m),   twice = alpha momentum.
// Every number is of the size of 1, and is computed with more digits than the scalar has and rounded once: what its rounding breaks, in
// symplecticity or order, is there in every step (Hairer, McLachlan, Razakarivony 2008).
#pragma once

#include <array>

#include "hilger/step/tableau.hpp"

namespace hilger::detail {

template <class S, int Stages, class Quadrature>
struct galerkin_table {
    static constexpr std::size_t N = Stages, R = Quadrature::degree(Stages);
    static constexpr bool collocated = std::is_same_v<Quadrature, gauss>;
    template <std::size_t Rows, std::size_t Columns>
    using matrix = std::array<std::array<S, Columns>, Rows>;

    std::array<S, N> node, weight;
    std::array<S, R> gamma;
    matrix<N, R> alpha, beta;
    matrix<R, N> momentum;
    matrix<N, N> twice;
    std::array<S, N> reach; ///< w_k (1 - c_k): q_1 = q_0 + h v_0 + h^2 sum_k reach_k M^-1 dL/dq(A_k)
    matrix<N, N> next_node; ///< the polynomial through the values at the nodes, read at the nodes of the next step
    matrix<R, R> next;      ///< the same for values at the Gauss points

    /// Made once for all steps of all flows.
    static galerkin_table const& here() {
        static galerkin_table const table;
        return table;
    }

private:
    using W = typename wider<S>::type;
    static std::size_t at(int k) { return static_cast<std::size_t>(k); }
    /// The Gauss points. Two of them are irrational: exact scalars take Radau's, which serve as well, for l_i l_j has degree 2.
    static quadrature<W> velocity_points() {
        if constexpr (std::numeric_limits<S>::is_exact and R == 2)
            return {{S(1) / S(3), S(1)}, {S(3) / S(4), S(1) / S(4)}};
        else
            return gauss::on_unit_interval<S>(static_cast<int>(R));
    }

    galerkin_table() {
        constexpr int n = static_cast<int>(N), r = static_cast<int>(R);
        auto const nodes = Quadrature::template on_unit_interval<S>(n);
        auto const points = velocity_points();
        std::vector<std::vector<W>> at_node, at_point, alpha_wide(N, std::vector<W>(R)), momentum_wide(R, std::vector<W>(N));
        for (W const& c : nodes.node) at_node.push_back(legendre(r + 1, W(W(2) * c - W(1))));
        for (W const& g : points.node) at_point.push_back(legendre(r + 1, W(W(2) * g - W(1))));
        for (int j = 0; j < r; ++j) gamma[at(j)] = S(points.weight[at(j)]);
        for (int k = 0; k < n; ++k) {
            W const& w = nodes.weight[at(k)];
            node[at(k)] = S(nodes.node[at(k)]);
            weight[at(k)] = S(w);
            reach[at(k)] = S(W(w * (W(1) - nodes.node[at(k)])));
            for (int j = 0; j < r; ++j) {
                // l_j = gamma_j sum_m (2m + 1) P_m(g_j) P_m, and (2m + 1) P_m = P_{m+1}' - P_{m-1}', all of them on [-1, 1]
                auto const &at_c = at_node[at(k)], &at_g = at_point[at(j)];
                W value(1), part = nodes.node[at(k)] + nodes.node[at(k)];
                for (std::size_t m = 1; m < R; ++m) {
                    value = value + W(2 * static_cast<int>(m) + 1) * (at_g[m] * at_c[m]);
                    part = part + at_g[m] * (at_c[m + 1] - at_c[m - 1]);
                }
                part = part / W(2);
                alpha_wide[at(k)][at(j)] = points.weight[at(j)] * part;
                momentum_wide[at(j)][at(k)] = w * (W(1) - part);
                alpha[at(k)][at(j)] = S(alpha_wide[at(k)][at(j)]);
                momentum[at(j)][at(k)] = S(momentum_wide[at(j)][at(k)]);
                beta[at(k)][at(j)] = collocated ? S(k == j ? 1 : 0) : S(W(points.weight[at(j)] * value));
            }
        }
        for (std::size_t k = 0; k < N; ++k)
            for (std::size_t m = 0; m < N; ++m) {
                W sum(0);
                for (std::size_t j = 0; j < R; ++j) sum = sum + alpha_wide[k][j] * momentum_wide[j][m];
                twice[k][m] = S(sum);
            }
        extrapolate(nodes.node, next_node);
        extrapolate(points.node, next);
    }
    /// Lagrange's polynomials of the points at the points one step further.
    template <std::size_t Count>
    static void extrapolate(std::vector<W> const& x, matrix<Count, Count>& to) {
        for (std::size_t k = 0; k < Count; ++k)
            for (std::size_t j = 0; j < Count; ++j) {
                W value(1);
                for (std::size_t m = 0; m < Count; ++m)
                    if (m != j) value = value * (W(W(1) + x[k]) - x[m]) / W(x[j] - x[m]);
                to[k][j] = S(value);
            }
    }
};

/// The table of an embedding; `void` where it is no Galerkin embedding.
template <class E, class S>
struct table_of_galerkin {
    using type = void;
};
template <int Stages, class Quadrature, class S>
    requires(not facts_of<galerkin_embedding<Stages, Quadrature>>.one_node)
struct table_of_galerkin<galerkin_embedding<Stages, Quadrature>, S> {
    using type = galerkin_table<S, Stages, Quadrature>;
};

} // namespace hilger::detail
