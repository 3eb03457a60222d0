// SPDX-License-Identifier: BSL-1.0
// GMRES (Saad, Schultz 1986), restarted, for large linear systems known by what they do to a vector: values of type V, one per point.
#pragma once

#include <cmath>
#include <vector>

#include "hilger/shape.hpp"

namespace hilger::detail {

/// sum_i f(i) for first <= i < last, halves first: the rounding grows like log n.
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
/// Of values up to the ends of the scalar's range: their squares may be beyond them.
template <class V>
scalar_of<V> euclidean_norm(std::vector<V> const& x) {
    using std::sqrt;
    using S = scalar_of<V>;
    S const square = inner_product(x, x), smallest = (std::numeric_limits<S>::min)() / (epsilon<S>() * epsilon<S>());
    if (smallest < square and is_finite(square)) return S(sqrt(square));
    S largest(0);
    for (auto const& value : x) largest = std::max(largest, S(magnitude(value)));
    if (largest == S(0) or not is_finite(largest)) return largest;
    using std::frexp, std::ldexp;
    int exponent = 0;
    (void)frexp(largest, &exponent);
    S const unit = ldexp(S(1), exponent - 1); // no digit of a value is touched
    S const sum = pairwise_sum(0, x.size(), [&](std::size_t i) {
        V const part = x[i] / unit;
        return S(dot_product(part, part));
    });
    return unit * S(sqrt(sum));
}
/// x + c y
template <class V>
void add_multiple(std::vector<V>& x, scalar_of<V> const& c, std::vector<V> const& y) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = x[i] + c * y[i];
}

/// The limits of an iteration: columns kept before a restart, and how many of them in all.
struct krylov_limits {
    int columns, total;
};
template <class V>
struct krylov_solution {
    std::vector<V> x;
    scalar_of<V> residual; ///< relative to the right-hand side
    int iterations;
};

/// A x = b up to |b - A x| <= tolerance |b|, or as far as the limits let it come. b is not zero.
template <class V, class Apply>
krylov_solution<V> gmres(Apply const& A, std::vector<V> const& b, scalar_of<V> const& tolerance, krylov_limits limits) {
    using S = scalar_of<V>;
    using std::sqrt;
    S const size = euclidean_norm(b);
    krylov_solution<V> solution{{}, S(1), 0};
    std::vector<V> rest = b;
    for (auto const& value : b) solution.x.push_back(zero_like(value));
    while (tolerance < solution.residual and solution.iterations < limits.total) {
        S const start = euclidean_norm(rest);
        std::vector<std::vector<V>> basis{rest};
        for (auto& value : basis[0]) value = value / start;
        std::vector<std::vector<S>> R;                 // columns of the triangle
        std::vector<S> cosine, sine, target{S(start)}; // rotations, and the rotated right-hand side
        bool complete = false;
        while (not complete and static_cast<int>(R.size()) < limits.columns and solution.iterations < limits.total) {
            std::size_t const n = R.size();
            std::vector<V> next = A(basis[n]);
            ++solution.iterations;
            S const before = euclidean_norm(next);
            std::vector<S> column;
            for (std::size_t i = 0; i <= n; ++i) {
                column.push_back(inner_product(basis[i], next));
                add_multiple(next, S(-column[i]), basis[i]);
            }
            S const below = euclidean_norm(next);
            for (std::size_t i = 0; i < n; ++i) {
                S const upper = cosine[i] * column[i] + sine[i] * column[i + 1];
                column[i + 1] = cosine[i] * column[i + 1] - sine[i] * column[i];
                column[i] = upper;
            }
            S const length = S(sqrt(S(column[n] * column[n] + below * below)));
            if (not(S(0) < length)) break; // A maps the basis into less than itself: it is singular there
            cosine.push_back(column[n] / length);
            sine.push_back(below / length);
            column[n] = length;
            target.push_back(S(-sine[n] * target[n]));
            target[n] = cosine[n] * target[n];
            R.push_back(std::move(column));
            complete = not(tolerance * size < magnitude(target[n + 1])) or not(epsilon<S>() * before < below);
            for (auto& value : next) value = value / below;
            if (not complete) basis.push_back(std::move(next));
        }
        if (R.empty()) break;
        for (std::size_t i = R.size(); i-- > 0;) {
            for (std::size_t j = i + 1; j < R.size(); ++j) target[i] = target[i] - R[j][i] * target[j];
            target[i] = target[i] / R[i][i];
            add_multiple(solution.x, target[i], basis[i]);
        }
        S const previous = solution.residual;
        solution.residual = magnitude(target[R.size()]) / size;
        if (complete) break;
        rest = A(solution.x);
        for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = b[i] - rest[i];
        if (not(solution.residual < previous)) break;
    }
    return solution;
}

} // namespace hilger::detail
