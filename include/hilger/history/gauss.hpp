// SPDX-License-Identifier: BSL-1.0
// Few nodes for many: the Gauss quadrature of a positive discrete measure, by Lanczos' recurrence and the implicit QL iteration
// (Golub, Welsch 1969; Gautschi, Orthogonal Polynomials, 2.2.3 and 3.1.1).
#pragma once

#include <cmath>
#include <vector>

#include "hilger/scalar.hpp"

namespace hilger::detail::memory {

template <class S>
struct quadrature {
    std::vector<S> node, weight;
};

template <class S>
S dot(std::vector<S> const& x, std::vector<S> const& y) {
    S sum(0);
    for (std::size_t i = 0; i < x.size(); ++i) sum = sum + x[i] * y[i];
    return sum;
}

/// The eigenvalues of the symmetric tridiagonal matrix with the diagonal d and e beside it, and the squares of the first components of its
/// eigenvectors times `mass`.
template <class S>
quadrature<S> nodes_of_jacobi_matrix(std::vector<S> d, std::vector<S> e, S const& mass) {
    using std::abs, std::sqrt;
    std::size_t const n = d.size();
    std::vector<S> z(n, S(0));
    z[0] = S(1);
    e.resize(n, S(0));
    for (std::size_t l = 0; l < n; ++l)
        for (int sweep = 0; sweep < 200; ++sweep) {
            std::size_t m = l;
            while (m + 1 < n and abs(e[m]) > epsilon<S>() * (abs(d[m]) + abs(d[m + 1]))) ++m;
            if (m == l) break;
            S g = (d[l + 1] - d[l]) / (S(2) * e[l]), r = sqrt(g * g + S(1)), s(1), c(1), p(0);
            g = d[m] - d[l] + e[l] / (g < S(0) ? S(g - r) : S(g + r));
            std::size_t i = m;
            while (i-- > l) {
                S const f = s * e[i], b = c * e[i];
                r = sqrt(f * f + g * g);
                e[i + 1] = r;
                if (r == S(0)) {
                    d[i + 1] = d[i + 1] - p;
                    break;
                }
                s = f / r;
                c = g / r;
                g = d[i + 1] - p;
                r = (d[i] - g) * s + S(2) * c * b;
                p = s * r;
                d[i + 1] = g + p;
                g = c * r - b;
                S const y = z[i + 1];
                z[i + 1] = s * z[i] + c * y;
                z[i] = c * z[i] - s * y;
            }
            if (not(r == S(0))) {
                d[l] = d[l] - p;
                e[l] = g;
            }
            e[m] = S(0);
        }
    for (auto& y : z) y = mass * y * y;
    return {d, z};
}

/// The Gauss quadrature with `count` nodes (fewer if there are no more) of the measure with these nodes and positive weights.
template <class S>
quadrature<S> gauss(quadrature<S> const& measure, std::size_t count) {
    using std::sqrt;
    std::size_t const n = measure.node.size();
    if (n <= count) return measure;
    S mass(0);
    for (auto const& w : measure.weight) mass = mass + w;
    std::vector<std::vector<S>> basis(1);
    for (auto const& w : measure.weight) basis[0].push_back(sqrt(S(w / mass)));
    std::vector<S> d, e;
    while (true) {
        std::vector<S> next = basis.back();
        for (std::size_t i = 0; i < n; ++i) next[i] = next[i] * measure.node[i];
        d.push_back(dot(next, basis.back()));
        if (d.size() == count) break;
        for (int twice = 0; twice < 2; ++twice) // orthogonal to rounding
            for (auto const& b : basis) {
                S const along = dot(next, b);
                for (std::size_t i = 0; i < n; ++i) next[i] = next[i] - along * b[i];
            }
        e.push_back(sqrt(dot(next, next)));
        for (auto& x : next) x = x / e.back();
        basis.push_back(std::move(next));
    }
    return nodes_of_jacobi_matrix(std::move(d), std::move(e), mass);
}

} // namespace hilger::detail::memory
