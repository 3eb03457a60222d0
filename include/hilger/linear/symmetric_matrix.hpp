// SPDX-License-Identifier: BSL-1.0
// Symmetric matrices in the pattern of a potential's second derivatives: tridiagonal, dense or sparse.
#pragma once

#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>

#include "hilger/linear/hessian_pattern.hpp"
#include "hilger/linear/patterned_matrix.hpp"

namespace hilger::detail {

/// Factors of one's own: a copy makes its own.
template <class Factors>
struct own : std::unique_ptr<Factors> {
    own() = default;
    own(own const&) : own() {}
    own(own&&) = default;
    own& operator=(own const&) { return *this; }
    own& operator=(own&&) = default;
};

template <class S>
class symmetric_matrix {
public:
    using vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;
    using matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;

    /// `list(put)` calls put(j, k, anything) for the entries that may be different from zero.
    template <class List>
    void prepare(hessian_pattern pattern, index_type d, List const& list) {
        std::vector<Eigen::Triplet<S>> entries;
        if (pattern == hessian_pattern::sparse)
            list([&](index_type j, index_type k, S const&) { entries.emplace_back(static_cast<int>(j), static_cast<int>(k), S(0)); });
        make_room(pattern, d, entries);
    }
    void set_zero();
    void add(index_type j, index_type k, S const& x) {
        if (pattern_ == hessian_pattern::tridiagonal)
            (j == k ? diagonal_(j) : below_(k)) += x;
        else if (pattern_ == hessian_pattern::dense)
            dense_(j, k) += x;
        else
            sparse_.coeffRef(static_cast<int>(j), static_cast<int>(k)) += x;
    }
    /// x in K x = r; false where K is not regular. The entries are used up.
    template <class V>
    bool solve(V& x) {
        if (pattern_ == hessian_pattern::tridiagonal) return thomas(x);
        unknown_ = x;
        if (not solve_by_factors()) return false;
        x = unknown_;
        return true;
    }

private:
    template <class V>
    bool thomas(V& x) {
        index_type const d = x.size();
        for (index_type k = 0; k < d; ++k) {
            S const entry = diagonal_(k);
            if (k > 0) {
                S const factor = below_(k - 1) * diagonal_(k - 1); // the diagonal holds inverse pivots up to k - 1
                diagonal_(k) -= factor * below_(k - 1);
                x(k) -= factor * x(k - 1);
            }
            if (not is_pivot(diagonal_(k), entry, 2)) return false;
            diagonal_(k) = S(1) / diagonal_(k);
        }
        x(d - 1) = x(d - 1) * diagonal_(d - 1);
        for (index_type k = d - 2; k >= 0; --k) x(k) = (x(k) - below_(k) * x(k + 1)) * diagonal_(k);
        return true;
    }
    void make_room(hessian_pattern pattern, index_type d, std::vector<Eigen::Triplet<S>>& entries);
    bool solve_by_factors();

    hessian_pattern pattern_ = hessian_pattern::dense;
    vector diagonal_, below_, room_, unknown_;
    matrix dense_;
    own<Eigen::LDLT<matrix, Eigen::Lower>> dense_factors_;
    Eigen::SparseMatrix<S> sparse_;
    own<Eigen::SimplicialLDLT<Eigen::SparseMatrix<S>, Eigen::Lower>> sparse_factors_;
};

template <class S>
void symmetric_matrix<S>::make_room(hessian_pattern pattern, index_type d, std::vector<Eigen::Triplet<S>>& entries) {
    pattern_ = pattern;
    if (pattern == hessian_pattern::tridiagonal) {
        diagonal_.setZero(d);
        below_.setZero(d);
    } else if (pattern == hessian_pattern::dense)
        dense_.setZero(d, d);
    else {
        for (int j = 0; j < d; ++j) entries.emplace_back(j, j, S(0));
        sparse_.resize(d, d);
        sparse_.setFromTriplets(entries.begin(), entries.end());
    }
}
template <class S>
void symmetric_matrix<S>::set_zero() {
    if (pattern_ == hessian_pattern::tridiagonal) {
        diagonal_.setZero();
        below_.setZero();
    } else if (pattern_ == hessian_pattern::dense)
        dense_.setZero();
    else
        for (index_type k = 0; k < sparse_.nonZeros(); ++k) sparse_.valuePtr()[k] = S(0);
}
template <class S>
bool symmetric_matrix<S>::solve_by_factors() {
    auto const solve_by = [&](auto const& factors, auto const& order, auto const& entries) {
        if (factors.info() != Eigen::Success) return false;
        room_ = order * entries.diagonal();
        for (index_type k = 0; k < room_.size(); ++k)
            if (not is_pivot(S(factors.vectorD()(k)), S(room_(k)), room_.size())) return false;
        unknown_ = factors.solve(unknown_);
        return true;
    };
    if (pattern_ == hessian_pattern::dense) {
        if (not dense_factors_) dense_factors_.reset(new Eigen::LDLT<matrix, Eigen::Lower>(dense_.rows()));
        dense_factors_->compute(dense_);
        return solve_by(*dense_factors_, dense_factors_->transpositionsP(), dense_);
    }
    if (not sparse_factors_) {
        sparse_factors_.reset(new Eigen::SimplicialLDLT<Eigen::SparseMatrix<S>, Eigen::Lower>);
        sparse_factors_->analyzePattern(sparse_);
    }
    sparse_factors_->factorize(sparse_);
    return solve_by(*sparse_factors_, sparse_factors_->permutationP(), sparse_);
}

} // namespace hilger::detail
