// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Cholesky>

namespace hilger::detail {

/// x becomes A^-1 x; false where A is not positive definite.
template <class S>
bool solve_positive_definite(Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> const& A, Eigen::Matrix<S, Eigen::Dynamic, 1>& x) {
    Eigen::LDLT<Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>> const factors(A); // no roots: of rationals too
    if (factors.info() != Eigen::Success or not(factors.vectorD().array() > S(0)).all()) return false;
    x = factors.solve(x);
    return true;
}

} // namespace hilger::detail
