// SPDX-License-Identifier: BSL-1.0
// The numbers of a Galerkin step for L = v.Mv/2 + a.v - U(q). Its velocity is the polynomial through values V_j at the R Gauss points g_j
// of [0, 1], R its degree plus one, and with nodes c_k and weights w_k, k = 1, ..., N, l_j the polynomial that is 1 at g_j and 0 at the
// others,
//   A_k = q_0 + h sum_j alpha_kj V_j,   alpha_kj = integral of l_j from 0 to c_k.
// Stationarity of L_h for given q_0 and q_1, with p_0 = -d_1 L_h, gives for j = 1, ..., R
//   M V_j = p_0 - a + h sum_k momentum_jk F_k,   F_k = -U'(A_k),   momentum_jk = w_k (1 - alpha_kj / gamma_j),
// gamma_j the integral of l_j over [0, 1], as both quadratures are exact for l_i l_j; for Gauss nodes (c = g) momentum = alpha. Hence
// (Nystroem's form)
//   A_k = q_0 + h c_k v_0 + h^2 sum_m twice_km M^-1 F_m,   twice = alpha momentum,   p_1 = p_0 + h sum_k w_k F_k.
// All numbers are of order 1, computed with more digits than the scalar has and rounded once: their rounding violates symplecticity or
// order in every step, and accumulates. Compensated sums use two-part numbers with few digits in the first: the rounding of a sum of
// products with both is unbiased (Hairer, McLachlan, Razakarivony 2008).
#pragma once

#include <array>
#include <cmath>

#include "hilger/embedding/galerkin.hpp"
#include "hilger/step/tableau.hpp"

namespace hilger::detail {

template <class S, int Stages, class Quadrature, int Degree = Quadrature::degree(Stages)>
struct galerkin_table {
    static constexpr std::size_t N = Stages, R = Degree;
    /// Whether the numbers are known to more digits than S has.
    static constexpr bool has_parts = not std::is_same_v<typename wider<S>::type, S>;
    template <std::size_t Rows, std::size_t Columns>
    using matrix = std::array<std::array<S, Columns>, Rows>;

    struct numbers {
        std::array<S, N> node, weight;
        std::array<S, N> reach; ///< w_k (1 - c_k): q_1 = q_0 + h v_0 + h^2 sum_k reach_k M^-1 dL/dq(A_k)
        matrix<N, N> twice;
    };
    numbers whole, leading, rest; ///< rounded once; in two parts, if S has a wider type
    matrix<N, R> alpha;
    matrix<R, N> momentum;
    matrix<N, N> next_node; ///< extrapolates values at the nodes to the nodes of the next step

    /// Shared by all steps of all flows.
    static galerkin_table const& here() {
        static galerkin_table const table;
        return table;
    }

private:
    using W = typename wider<S>::type;
    static std::size_t at(int k) { return static_cast<std::size_t>(k); }
    /// The Gauss points. Two of them are irrational: exact scalars use Radau's, which suffice as l_i l_j has degree 2.
    static quadrature<W> velocity_points() {
        if constexpr (std::numeric_limits<S>::is_exact and R == 2)
            return {{S(1) / S(3), S(1)}, {S(3) / S(4), S(1) / S(4)}};
        else
            return gauss::on_unit_interval<S>(static_cast<int>(R));
    }

    template <class Place>
    void put(W const& x, Place const& place) {
        place(whole) = S(x);
        if constexpr (has_parts) {
            using std::round;
            S const few = S(1024);
            place(leading) = round(S(x) * few) / few;
            place(rest) = S(W(x - W(place(leading))));
        }
    }

    // Not inlined into a flattened step: it is longer than ten of them.
    [[gnu::noinline, gnu::cold]] galerkin_table() {
        constexpr int n = static_cast<int>(N), r = static_cast<int>(R);
        auto const nodes = wide_quadrature<S, Quadrature>(n);
        auto const points = velocity_points();
        std::vector<std::vector<W>> at_node, at_point, alpha_wide(N, std::vector<W>(R)), momentum_wide(R, std::vector<W>(N));
        for (W const& c : nodes.node) at_node.push_back(legendre(r + 1, W(W(2) * c - W(1))));
        for (W const& g : points.node) at_point.push_back(legendre(r + 1, W(W(2) * g - W(1))));
        for (int k = 0; k < n; ++k) {
            W const& w = nodes.weight[at(k)];
            put(nodes.node[at(k)], [k](numbers& to) -> S& { return to.node[at(k)]; });
            put(w, [k](numbers& to) -> S& { return to.weight[at(k)]; });
            put(W(w * (W(1) - nodes.node[at(k)])), [k](numbers& to) -> S& { return to.reach[at(k)]; });
            for (int j = 0; j < r; ++j) {
                // l_j = gamma_j sum_m (2m + 1) P_m(g_j) P_m, and (2m + 1) P_m = P_{m+1}' - P_{m-1}', all of them on [-1, 1]
                auto const &at_c = at_node[at(k)], &at_g = at_point[at(j)];
                W part = nodes.node[at(k)] + nodes.node[at(k)];
                for (std::size_t m = 1; m < R; ++m) part = part + at_g[m] * (at_c[m + 1] - at_c[m - 1]);
                part = part / W(2);
                alpha_wide[at(k)][at(j)] = points.weight[at(j)] * part;
                momentum_wide[at(j)][at(k)] = w * (W(1) - part);
                alpha[at(k)][at(j)] = S(alpha_wide[at(k)][at(j)]);
                momentum[at(j)][at(k)] = S(momentum_wide[at(j)][at(k)]);
            }
        }
        for (std::size_t k = 0; k < N; ++k)
            for (std::size_t m = 0; m < N; ++m) {
                W sum(0);
                for (std::size_t j = 0; j < R; ++j) sum = sum + alpha_wide[k][j] * momentum_wide[j][m];
                put(sum, [k, m](numbers& to) -> S& { return to.twice[k][m]; });
            }
        extrapolate(nodes.node);
    }
    /// Lagrange polynomials of the points, evaluated one step further.
    void extrapolate(std::vector<W> const& x) {
        for (std::size_t k = 0; k < N; ++k)
            for (std::size_t j = 0; j < N; ++j) {
                W value(1);
                for (std::size_t m = 0; m < N; ++m)
                    if (m != j) value = value * (W(W(1) + x[k]) - x[m]) / W(x[j] - x[m]);
                next_node[k][j] = S(value);
            }
    }
};

/// The table of an embedding; `void` if it is no Galerkin embedding.
template <class E, class S>
struct table_of_galerkin {
    using type = void;
};
/// Whether n nodes integrate the products l_i l_j exactly, of degree 2d - 2 for positions of degree d: Gauss up to 2n - 1, Lobatto up to 2n
/// - 3. A user's own quadrature has no table.
template <class Quadrature>
constexpr bool is_exact_for_velocities(int degree, int nodes) {
    if (std::is_same_v<Quadrature, gauss>) return degree <= nodes;
    return std::is_same_v<Quadrature, lobatto> and degree < nodes;
}
template <int Degree, class Quadrature, int Count, bool Checked, class S>
    requires(Degree > 1 and is_exact_for_velocities<Quadrature>(Degree, Count))
struct table_of_galerkin<
    embedding<polynomial_value<Degree, Quadrature, Count>, polynomial_slope<Degree, Quadrature, Count>, step_weight, Checked>, S> {
    using type = galerkin_table<S, Count, Quadrature, Degree>;
};

} // namespace hilger::detail
