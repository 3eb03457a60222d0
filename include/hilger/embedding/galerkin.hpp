// SPDX-License-Identifier: BSL-1.0
// Galerkin embeddings (Marsden-West; Cresson-Safi, section 5): on each step a position is the polynomial through s + 1 control values, read
// together with its derivative at the nodes of a quadrature, which is the integral.
//   galerkin<s, gauss>     degree s, s Gauss nodes: order 2s; s = 1 is mid-point, and s is the Gauss collocation method
//   galerkin<s, lobatto>   degree s - 1, s Lobatto nodes: order 2s - 2; s = 2 is Stoermer-Verlet for a separable Lagrangian
// Nodes and weights are computed with more digits than the scalar has, for what is made of them to be rounded once.
#pragma once

#include <cmath>
#include <vector>

#include "hilger/error.hpp"
#include "hilger/operator/double_double.hpp"

namespace hilger {

namespace detail {

/// P_0(x), ..., P_n(x), Legendre.
template <class W>
std::vector<W> legendre(int n, W const& x) {
    std::vector<W> p{W(1), x};
    for (int k = 2; k <= n; ++k) {
        auto const last = static_cast<std::size_t>(k - 1);
        p.push_back((W(2 * k - 1) * (x * p[last]) - W(k - 1) * p[last - 1]) / W(k));
    }
    return p;
}
/// P_n'(x) from P_n(x) and P_{n-1}(x), |x| < 1.
template <class W>
W legendre_slope(int n, W const& x, std::vector<W> const& p) {
    auto const last = static_cast<std::size_t>(n);
    return W(n) * (x * p[last] - p[last - 1]) / (x * x - W(1));
}
/// Newton's iteration from a start with two right digits: they double in every round, and 2^9 are more than any scalar has. Step maps x to
/// f(x) / f'(x). @throws error::invalid_parameter where an exact scalar does not reach the root
template <class S, class Step>
typename wider<S>::type polished(double start, Step const& step) {
    using W = typename wider<S>::type;
    W x = W(S(start));
    if constexpr (std::numeric_limits<S>::is_exact) {
        for (int k = 0; k < 2; ++k) x = x - step(x);
        if (not(step(x) == W(0))) error::raise<error::invalid_parameter>("these nodes are irrational: take a scalar that is not exact");
    } else
        for (int k = 0; k < 8; ++k) x = x - step(x);
    return x;
}

template <class W>
struct quadrature {
    std::vector<W> node, weight; ///< on [0, 1], increasing
};

} // namespace detail

struct gauss {
    static constexpr char const* name = "Gauss";
    static constexpr int degree(int stages) { return stages; }
    /// n nodes, exact up to degree 2n - 1, for numbers S.
    template <class S>
    static auto on_unit_interval(int n) {
        using W = typename detail::wider<S>::type;
        detail::quadrature<W> q;
        for (int i = 0; i < n; ++i) {
            W const x = detail::polished<S>(-std::cos(3.14159265358979 * (i + 0.75) / (n + 0.5)), [n](W const& y) {
                auto const p = detail::legendre(n, y);
                return W(p[static_cast<std::size_t>(n)] / detail::legendre_slope(n, y, p));
            });
            W const d = detail::legendre_slope(n, x, detail::legendre(n, x));
            q.node.push_back((W(1) + x) / W(2));
            q.weight.push_back(W(1) / ((W(1) - x * x) * (d * d)));
        }
        return q;
    }
};

struct lobatto {
    static constexpr char const* name = "Lobatto";
    static constexpr int degree(int stages) { return stages - 1; }
    /// n >= 2 nodes, both ends among them, exact up to degree 2n - 3, for numbers S.
    template <class S>
    static auto on_unit_interval(int n) {
        using W = typename detail::wider<S>::type;
        detail::quadrature<W> q;
        int const m = n - 1;
        for (int i = 0; i < n; ++i) {
            // The inner nodes are the roots of P_m'; (1 - x^2) P_m'' = 2 x P_m' - m (m + 1) P_m.
            W x(i == 0 ? -1 : 1);
            if (i > 0 and i < m)
                x = detail::polished<S>(-std::cos(3.14159265358979 * i / m), [m](W const& y) {
                    auto const p = detail::legendre(m, y);
                    W const first = detail::legendre_slope(m, y, p);
                    W const second = (W(2) * (y * first) - W(m * (m + 1)) * p[static_cast<std::size_t>(m)]) / (W(1) - y * y);
                    return W(first / second);
                });
            W const p = detail::legendre(m, x)[static_cast<std::size_t>(m)];
            q.node.push_back((W(1) + x) / W(2));
            q.weight.push_back(W(1) / (W(n * m) * (p * p)));
        }
        return q;
    }
};

/// The position operator is the interpolation polynomial's value at the nodes, the velocity operator its derivative there, and the integral
/// the quadrature.
template <int Stages, class Quadrature>
struct galerkin_embedding {
    static_assert(Stages >= (std::is_same_v<Quadrature, lobatto> ? 2 : 1),
                  "a Galerkin embedding has one Gauss node or more, or two Lobatto nodes or more");
    static constexpr int stages = Stages;
    static constexpr int degree = Quadrature::degree(Stages);
    char const* name = Quadrature::name;
};
template <int Stages, class Quadrature>
inline constexpr galerkin_embedding<Stages, Quadrature> galerkin{};

} // namespace hilger
