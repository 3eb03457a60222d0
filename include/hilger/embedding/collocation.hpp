// SPDX-License-Identifier: BSL-1.0
// Runge-Kutta methods made from quadratures (Hairer, Wanner, Solving Ordinary Differential Equations II, IV.5):
//   collocation<S, Q>(s)   a_ij = integral of l_j from 0 to c_i, b_j = w_j; Q = radau is Radau IIA, order 2s - 1, stiffly accurate
//   lobatto_3c<S>(s)       Lobatto's nodes and weights, a_i1 = b_1, exact up to degree s - 2; order 2s - 2, stiffly accurate
// The numbers have more digits than S.
#pragma once

#include "hilger/embedding/quadrature.hpp"
#include "hilger/history/runge_kutta.hpp"

namespace hilger {

namespace detail {
/// The polynomial that is 1 at node j and 0 at the other nodes from `first` on.
template <class W>
W lagrange(std::vector<W> const& node, std::size_t first, std::size_t j, W const& x) {
    W product(1);
    for (std::size_t m = first; m < node.size(); ++m)
        if (m != j) product = product * (x - node[m]) / (node[j] - node[m]);
    return product;
}
/// Its integral from 0 to x.
template <class S, class W>
W lagrange_integral(std::vector<W> const& node, std::size_t first, std::size_t j, W const& x) {
    auto const exact = wide_quadrature<S, gauss>(static_cast<int>(node.size() - first + 1) / 2);
    W sum(0);
    for (std::size_t k = 0; k < exact.node.size(); ++k) sum = sum + exact.weight[k] * lagrange(node, first, j, W(x * exact.node[k]));
    return x * sum;
}
} // namespace detail

/// The collocation method at s nodes of a quadrature. @throws error::invalid_parameter where an exact scalar does not have the nodes
template <class S, class Quadrature>
auto collocation(int s) {
    using W = typename detail::wider<S>::type;
    auto const q = detail::wide_quadrature<S, Quadrature>(s);
    runge_kutta<W> method{{}, q.weight, q.node};
    for (W const& c : q.node) {
        auto& row = method.A.emplace_back();
        for (std::size_t j = 0; j < q.node.size(); ++j) row.push_back(detail::lagrange_integral<S>(q.node, 0, j, c));
    }
    return method;
}

/// Lobatto IIIC with s >= 2 stages. @throws error::invalid_parameter for fewer
template <class S>
auto lobatto_3c(int s) {
    using W = typename detail::wider<S>::type;
    if (s < 2) error::raise<error::invalid_parameter>("Lobatto IIIC has two stages or more, not ", s);
    auto const q = detail::wide_quadrature<S, lobatto>(s);
    runge_kutta<W> method{{}, q.weight, q.node};
    for (W const& c : q.node) {
        auto& row = method.A.emplace_back();
        row.push_back(q.weight[0]);
        for (std::size_t j = 1; j < q.node.size(); ++j) // exact at the nodes from the second on, less what the first node has
            row.push_back(detail::lagrange_integral<S>(q.node, 1, j, c) - q.weight[0] * detail::lagrange(q.node, 1, j, q.node[0]));
    }
    return method;
}

namespace detail {
/// The stiffly accurate method whose stages are these nodes.
template <class S, class Quadrature>
auto stage_method(int stages) {
    if constexpr (std::same_as<Quadrature, lobatto>)
        return lobatto_3c<S>(stages);
    else
        return collocation<S, Quadrature>(stages);
}
} // namespace detail

} // namespace hilger
