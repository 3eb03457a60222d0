// SPDX-License-Identifier: BSL-1.0
// The Gauss quadrature of a positive discrete measure, by the Jacobi matrix of Lanczos' recurrence (Golub, Welsch 1969; Gautschi,
// Orthogonal Polynomials, 2.2.3 and 3.1.1).
#pragma once

#include <vector>

#include <Eigen/Eigenvalues>

namespace hilger::detail::memory {

template <class S>
struct quadrature {
    std::vector<S> node, weight;
};

/// The Gauss quadrature with `count` nodes (fewer if there are no more) of the measure with these nodes and positive weights.
template <class S>
quadrature<S> gauss(quadrature<S> const& measure, std::size_t count) {
    using vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;
    using matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;
    if (measure.node.size() <= count) return measure;
    auto const n = static_cast<Eigen::Index>(measure.node.size()), few = static_cast<Eigen::Index>(count);
    Eigen::Map<vector const> const node(measure.node.data(), n), weight(measure.weight.data(), n);
    S const mass = weight.sum(), scale = node.maxCoeff(); // Eigen treats numbers that are small beside 1 as zero
    matrix basis(n, few);
    vector diagonal(few), beside(few - 1);
    basis.col(0) = (weight / mass).cwiseSqrt();
    for (Eigen::Index k = 0; k < few; ++k) {
        vector next = node.cwiseProduct(basis.col(k)) / scale;
        diagonal(k) = next.dot(basis.col(k));
        if (k + 1 == few) break;
        auto const known = basis.leftCols(k + 1);
        for (int twice = 0; twice < 2; ++twice) next -= known * (known.transpose() * next).eval(); // orthogonal to rounding
        beside(k) = next.norm();
        basis.col(k + 1) = next / beside(k);
    }
    Eigen::SelfAdjointEigenSolver<matrix> jacobi;
    jacobi.computeFromTridiagonal(diagonal, beside);
    quadrature<S> result;
    for (Eigen::Index j = 0; j < few; ++j) {
        S const first = jacobi.eigenvectors()(0, j);
        result.node.push_back(scale * jacobi.eigenvalues()(j));
        result.weight.push_back(mass * first * first);
    }
    return result;
}

} // namespace hilger::detail::memory
