// SPDX-License-Identifier: BSL-1.0
// Galerkin embeddings (Marsden-West; Cresson-Safi, section 5): on each step a position is the polynomial through s + 1 control values, read
// together with its derivative at the nodes of a quadrature, which is the integral.
//   galerkin<s, gauss>     degree s, s Gauss nodes: order 2s; s = 1 is mid-point, and s is the Gauss collocation method
//   galerkin<s, lobatto>   degree s - 1, s Lobatto nodes: order 2s - 2; s = 2 is Stoermer-Verlet for a separable Lagrangian
// Nodes and weights are computed in the scalar's own digits.
#pragma once

#include <cmath>
#include <vector>

#include "hilger/scalar.hpp"

namespace hilger {

namespace detail {

/// P_n(x) and P_{n-1}(x), Legendre.
template <class S>
constexpr std::pair<S, S> legendre(int n, S const& x) {
    S before(1), p(x);
    if (n == 0) return {S(1), S(0)};
    for (int k = 2; k <= n; ++k) {
        S next = (S(2 * k - 1) * x * p - S(k - 1) * before) / S(k);
        before = p;
        p = next;
    }
    return {p, before};
}
/// Newton's iteration, as far as the scalar's digits go. Step maps x to f(x) / f'(x).
template <class S, class Step>
S polished(double start, Step const& step) {
    S x(start), last(1);
    for (int k = 0; k < 20; ++k) {
        S const d = step(x);
        x = x - d;
        S const size = magnitude(d);
        if (size == S(0) or (k > 3 and not(size < last))) break;
        last = size;
    }
    return x;
}

template <class S>
struct quadrature {
    std::vector<S> node, weight; ///< on [0, 1], increasing
};

} // namespace detail

struct gauss {
    static constexpr char const* name = "Gauss";
    static constexpr int degree(int stages) { return stages; }
    /// n nodes, exact up to degree 2n - 1.
    template <class S>
    static detail::quadrature<S> on_unit_interval(int n) {
        detail::quadrature<S> q;
        for (int i = 0; i < n; ++i) {
            double const start = -std::cos(3.14159265358979 * (i + 0.75) / (n + 0.5));
            auto const slope = [n](S const& x) {
                auto const [p, before] = detail::legendre(n, x);
                return S(S(n) * (x * p - before) / (x * x - S(1)));
            };
            S const x = detail::polished<S>(start, [&](S const& y) { return S(detail::legendre(n, y).first / slope(y)); });
            S const d = slope(x);
            q.node.push_back((S(1) + x) / S(2));
            q.weight.push_back(S(1) / ((S(1) - x * x) * d * d));
        }
        return q;
    }
};

struct lobatto {
    static constexpr char const* name = "Lobatto";
    static constexpr int degree(int stages) { return stages - 1; }
    /// n >= 2 nodes, both ends among them, exact up to degree 2n - 3.
    template <class S>
    static detail::quadrature<S> on_unit_interval(int n) {
        detail::quadrature<S> q;
        int const m = n - 1;
        for (int i = 0; i < n; ++i) {
            // The inner nodes are the roots of P_m'; (1 - x^2) P_m'' = 2 x P_m' - m (m + 1) P_m.
            S x(i == 0 ? -1 : 1);
            if (i > 0 and i < m)
                x = detail::polished<S>(-std::cos(3.14159265358979 * i / m), [m](S const& y) {
                    auto const [p, before] = detail::legendre(m, y);
                    S const first = S(m) * (y * p - before) / (y * y - S(1));
                    S const second = (S(2) * y * first - S(m * (m + 1)) * p) / (S(1) - y * y);
                    return S(first / second);
                });
            S const p = detail::legendre(m, x).first;
            q.node.push_back((S(1) + x) / S(2));
            q.weight.push_back(S(1) / (S(n * m) * p * p));
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
