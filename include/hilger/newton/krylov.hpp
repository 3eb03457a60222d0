// SPDX-License-Identifier: BSL-1.0
// GMRES (Saad, Schultz 1986) for large linear systems given by a matrix-vector product: values of type V, one per point.
#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Jacobi>

#include "hilger/shape.hpp"

namespace hilger::detail {

/// The sum of f(i), first <= i < last, pairwise: its rounding grows like log n.
template <class Term>
auto pairwise_sum(std::size_t first, std::size_t last, Term const& term) -> plain_t<decltype(term(first))> {
    if (last - first > 16) {
        std::size_t const middle = first + (last - first) / 2;
        return pairwise_sum(first, middle, term) + pairwise_sum(middle, last, term);
    }
    plain_t<decltype(term(first))> sum = term(first);
    for (std::size_t i = first + 1; i < last; ++i) sum = sum + term(i);
    return sum;
}

template <class V>
scalar_of<V> inner_product(std::vector<V> const& x, std::vector<V> const& y) {
    return pairwise_sum(0, x.size(), [&](std::size_t i) { return scalar_of<V>(dot_product(x[i], y[i])); });
}
/// For values up to the ends of the scalar's range: they are scaled by a power of two near the largest before they are squared.
template <class V>
scalar_of<V> euclidean_norm(std::vector<V> const& x) {
    using S = scalar_of<V>;
    S largest(0);
    for (auto const& value : x) largest = std::max(largest, S(magnitude(value)));
    if (largest == S(0) or not is_finite(largest)) return largest;
    if constexpr (not std::numeric_limits<S>::is_exact) { // exact scalars have no roots, and the largest is a norm too
        using std::frexp, std::ldexp, std::sqrt;
        int exponent = 0;
        (void)frexp(largest, &exponent);
        S const unit = ldexp(S(1), exponent - 1);
        S const square = pairwise_sum(0, x.size(), [&](std::size_t i) {
            V const part = x[i] / unit;
            return S(dot_product(part, part));
        });
        return unit * S(sqrt(square));
    }
    return largest;
}
/// x + c y
template <class V>
void add_multiple(std::vector<V>& x, scalar_of<V> const& c, std::vector<V> const& y) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = x[i] + c * y[i];
}

template <class V>
struct krylov_solution {
    std::vector<V> x;
    scalar_of<V> residual; ///< relative to the right-hand side
};

/// Solves A x = b to |b - A x| <= tolerance |b|, or with `most` applications of A, each of which stores a vector. b is not zero.
template <class V, class Apply>
krylov_solution<V> gmres(Apply const& A, std::vector<V> const& b, scalar_of<V> const& tolerance, int most) {
    using S = scalar_of<V>;
    using column = Eigen::Matrix<S, Eigen::Dynamic, 1>;
    auto const divided = [](std::vector<V> x, S const& by) {
        for (auto& value : x) value = value / by;
        return x;
    };
    S const size = euclidean_norm(b);
    std::vector<std::vector<V>> basis{divided(b, size)};
    std::vector<column> R; // columns of the triangle
    std::vector<Eigen::JacobiRotation<S>> rotations;
    column target = size * column::Unit(most + 1, 0); // the rotated right-hand side
    for (bool complete = false; not complete and static_cast<int>(R.size()) < most;) {
        int const n = static_cast<int>(R.size());
        std::vector<V> next = A(basis.back());
        S const before = euclidean_norm(next);
        column c(n + 2);
        for (int i = 0; i <= n; ++i) {
            auto const& direction = basis[static_cast<std::size_t>(i)];
            c(i) = inner_product(direction, next);
            add_multiple(next, S(-c(i)), direction);
        }
        S const below = c(n + 1) = euclidean_norm(next);
        for (int i = 0; i < n; ++i) c.applyOnTheLeft(i, i + 1, rotations[static_cast<std::size_t>(i)].adjoint());
        if (not(S(0) < S(magnitude(c(n)) + below))) break; // A is singular on the basis
        rotations.emplace_back().makeGivens(c(n), below);
        c.applyOnTheLeft(n, n + 1, rotations.back().adjoint());
        target.applyOnTheLeft(n, n + 1, rotations.back().adjoint());
        R.push_back(std::move(c));
        complete = not(tolerance * size < magnitude(target(n + 1))) or not(epsilon<S>() * before < below);
        if (not complete) basis.push_back(divided(std::move(next), below));
    }
    int const n = static_cast<int>(R.size());
    krylov_solution<V> solution{std::vector<V>(b.size(), zero_like(b.front())), S(magnitude(target(n)) / size)};
    for (int i = n; i-- > 0;) {
        column const& c = R[static_cast<std::size_t>(i)];
        S const share = target(i) / c(i);
        target.head(i) -= share * c.head(i);
        add_multiple(solution.x, share, basis[static_cast<std::size_t>(i)]);
    }
    return solution;
}

} // namespace hilger::detail
