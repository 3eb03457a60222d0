// SPDX-License-Identifier: BSL-1.0
// Theorem 4 of J. Cresson and R. Safi (2022) in values: the action (97) with its derivatives, and the discrete Hamiltonian system (94).
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "slope.hpp"

namespace hilger::papers {

/// (97)
template <class H, class P, class X>
auto hamiltonian_action(H const& energy, P const& p, X const& x) {
    auto const p_o = on_half[extend[p]];
    auto const q_o = on_half[extend[x]];
    return integral(dot(p_o, on_half[Delta_o_plus[extend[x]]]) - apply_pointwise(energy, p_o, q_o), half(p.scale()));
}
/// The two lines of (94), the left-hand side minus the right-hand one: on T_half^- and on T_half.
template <class H, class P, class X>
auto first_line(H const& energy, P const& p, X const& x) {
    auto const p_o = on_half[extend[p]];
    auto const force = apply_pointwise([=](auto const& y, auto const& z) { return energy.by_position(y, z); }, p_o, on_half[extend[x]]);
    return Delta_h_minus[p_o] + mean_h_minus[force];
}
template <class H, class P, class X>
auto second_line(H const& energy, P const& p, X const& x) {
    auto const velocity =
        apply_pointwise([=](auto const& y, auto const& z) { return energy.by_momentum(y, z); }, on_half[extend[p]], on_half[extend[x]]);
    return on_half[Delta_o_plus[extend[x]]] - velocity;
}
/// The derivative of (97) in the direction (w, v), w a variation of p and v one of q.
template <class V, class H, class P, class X, class W, class Z>
scalar_of<V> slope_along(H const& energy, P const& p, X const& x, W const& w, Z const& v) {
    using S = scalar_of<V>;
    return slope_at_zero<S>([&](S const& e) { return hamiltonian_action(energy, p + e * w, x + e * v); });
}
/// The derivatives of (97) along all unit variations: they span the space that (98) is about.
template <class V, class H, class P, class X>
std::vector<scalar_of<V>> all_slopes(H const& energy, P const& p, X const& x) {
    auto const T = p.scale();
    auto const none = unit<V>(T, 0) - unit<V>(T, 0);
    std::vector<scalar_of<V>> all;
    for (int c = 0; c < detail::shape<V>::dimension(p[0]); ++c) {
        for (index_type k = 0; k <= T.last(); ++k) all.push_back(slope_along<V>(energy, p, x, unit<V>(T, k, c), none));
        for (index_type k = 1; k < T.last(); ++k) all.push_back(slope_along<V>(energy, p, x, none, unit<V>(T, k, c)));
    }
    return all;
}
template <class S>
S largest(std::vector<S> const& xs) {
    S most(0);
    for (S const& x : xs) most = std::max(most, magnitude(x));
    return most;
}

/// The number of independent rows, by elimination.
inline std::size_t rank(std::vector<std::vector<Q>> rows) {
    std::size_t done = 0;
    for (std::size_t column = 0; not rows.empty() and column < rows[0].size(); ++column) {
        std::size_t pivot = done;
        while (pivot < rows.size() and rows[pivot][column] == 0) ++pivot;
        if (pivot == rows.size()) continue;
        std::swap(rows[done], rows[pivot]);
        for (std::size_t r = done + 1; r < rows.size(); ++r) {
            Q const f = rows[r][column] / rows[done][column];
            for (std::size_t c = column; c < rows[r].size(); ++c) rows[r][c] -= f * rows[done][c];
        }
        ++done;
    }
    return done;
}

/// For a quadratic H both are linear in (p, q), and so are spaces of solutions: the numbers of independent equations that the derivatives
/// of (97) make, that (94) makes, and that both make together. Equal numbers say that critical points and solutions are one space.
struct ranks {
    std::size_t critical, system, both;
};
template <class H, class Scale>
ranks ranks_of_theorem_4(H const& energy, Scale const& T) {
    std::size_t const N = static_cast<std::size_t>(T.steps());
    // The columns are the values of the two linear maps at the unit vectors (p, q); the rows are kept.
    std::vector<std::vector<Q>> critical(2 * N), system(2 * N - 1);
    for (index_type j = 0; j < 2 * T.size(); ++j) {
        auto const one = unit<Q>(T, j % T.size());
        auto const p = Q(j < T.size() ? 1 : 0) * one;
        auto const x = Q(j < T.size() ? 0 : 1) * one;
        auto const s = all_slopes<Q>(energy, p, x);
        for (std::size_t k = 0; k < critical.size(); ++k) critical[k].push_back(s.at(k));
        std::size_t k = 0;
        for (Q const& r : first_line(energy, p, x)) system.at(k++).push_back(r);
        for (Q const& r : second_line(energy, p, x)) system.at(k++).push_back(r);
    }
    auto both = critical;
    both.insert(both.end(), system.begin(), system.end());
    return {rank(critical), rank(system), rank(both)};
}

} // namespace hilger::papers
