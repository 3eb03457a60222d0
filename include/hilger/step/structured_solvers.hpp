// SPDX-License-Identifier: BSL-1.0
// The linear algebra of structured systems: the inverse of a mass given as a number, a vector or a matrix, and symmetric matrices in the
// pattern of a potential's second derivatives - tridiagonal, dense or sparse.
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>

#include "hilger/linear/patterned_matrix.hpp"
#include "hilger/models/mechanical.hpp"

namespace hilger::detail {

/// M^-1 and M times a vector, for the three kinds of mass.
template <class Mass, class V>
class mass_solver {
    using S = scalar_of<V>;

public:
    mass_solver(Mass const& m, index_type d) {
        if constexpr (is_matrix) {
            if (m.rows() != d or m.cols() != d) wrong(m.rows(), d);
            matrix_ = m.template cast<S>();
            factors_.compute(matrix_);
            bool regular = factors_.info() == Eigen::Success;
            for (index_type k = 0; regular and k < d; ++k) {
                S const pivot = S(factors_.matrixLLT()(k, k)) * S(factors_.matrixLLT()(k, k));
                regular = is_pivot(pivot, S(matrix_(k, k)), d);
            }
            if (not regular) error::raise<error::singular>("the mass matrix is not positive definite, or not to the digits of its scalar");
        } else if constexpr (requires { m.size(); }) {
            if (m.size() != d) wrong(m.size(), d);
            inverse_ = m.template cast<S>().cwiseInverse();
        } else
            inverse_ = V::Constant(d, S(1) / S(m));
    }
    template <class R>
    void solve(R const& r, V& v) const {
        if constexpr (is_matrix) {
            tally<S>::add(work::solve);
            v = factors_.solve(r);
        } else
            v = inverse_.cwiseProduct(r);
    }
    template <class Put>
    void put(Put const& to) const {
        if constexpr (is_matrix) {
            for (index_type j = 0; j < matrix_.rows(); ++j)
                for (index_type k = 0; k <= j; ++k) to(j, k, S(matrix_(j, k)));
        } else
            for (index_type j = 0; j < inverse_.size(); ++j) to(j, j, S(S(1) / inverse_(j)));
    }

private:
    static constexpr bool is_matrix = requires { requires Mass::ColsAtCompileTime != 1; };
    struct nothing {};
    [[noreturn]] static void wrong(index_type m, index_type d) {
        error::raise<error::mismatch>("the mass has dimension ", m, ", and the state has ", d);
    }
    V inverse_;
    block_of<V> matrix_;
    std::conditional_t<is_matrix, Eigen::LLT<block_of<V>>, nothing> factors_;
};

/// A symmetric matrix in one of the patterns: zero(), add(j, k, x), factor(), solve(x).
template <class V>
class pattern_solver {
    using S = scalar_of<V>;

public:
    template <class List>
    void prepare(hessian_pattern pattern, index_type d, List const& list) {
        pattern_ = pattern;
        if (pattern == hessian_pattern::tridiagonal) {
            diagonal_.setZero(d);
            below_.setZero(d);
        } else if (pattern == hessian_pattern::dense)
            dense_ = block_of<V>::Zero(d, d);
        else {
            std::vector<Eigen::Triplet<S>> entries;
            list([&](index_type j, index_type k, S const&) { entries.emplace_back(static_cast<int>(j), static_cast<int>(k), S(0)); });
            for (int j = 0; j < d; ++j) entries.emplace_back(j, j, S(0));
            sparse_.resize(d, d);
            sparse_.setFromTriplets(entries.begin(), entries.end());
        }
    }
    void zero() {
        if (pattern_ == hessian_pattern::tridiagonal) {
            diagonal_.setZero();
            below_.setZero();
        } else if (pattern_ == hessian_pattern::dense)
            dense_.setZero();
        else
            for (index_type k = 0; k < sparse_.nonZeros(); ++k) sparse_.valuePtr()[k] = S(0);
    }
    void add(index_type j, index_type k, S const& x) {
        if (pattern_ == hessian_pattern::tridiagonal)
            (j == k ? diagonal_(j) : below_(k)) += x;
        else if (pattern_ == hessian_pattern::dense)
            dense_(j, k) += x;
        else
            sparse_.coeffRef(static_cast<int>(j), static_cast<int>(k)) += x;
    }
    /// x in K x = r; false where K is not regular.
    bool solve(V& x) {
        for (work const each : {work::factorization, work::solve}) tally<S>::add(each);
        if (pattern_ == hessian_pattern::tridiagonal) return thomas(x);
        if (pattern_ == hessian_pattern::dense) {
            if (not dense_factors_) dense_factors_.reset(new Eigen::LDLT<block_of<V>, Eigen::Lower>(dense_.rows()));
            dense_factors_->compute(dense_);
            if (dense_factors_->info() != Eigen::Success) return false;
            room_ = dense_factors_->transpositionsP() * dense_.diagonal();
            for (index_type k = 0; k < room_.size(); ++k)
                if (not is_pivot(S(dense_factors_->vectorD()(k)), S(room_(k)), room_.size())) return false;
            x = dense_factors_->solve(x);
        } else {
            if (not simplicial_) {
                simplicial_.reset(new Eigen::SimplicialLDLT<Eigen::SparseMatrix<S>, Eigen::Lower>);
                simplicial_->analyzePattern(sparse_);
            }
            simplicial_->factorize(sparse_);
            if (simplicial_->info() != Eigen::Success) return false;
            room_ = simplicial_->permutationP() * sparse_.diagonal();
            for (index_type k = 0; k < room_.size(); ++k)
                if (not is_pivot(S(simplicial_->vectorD()(k)), S(room_(k)), room_.size())) return false;
            x = simplicial_->solve(x);
        }
        return true;
    }

private:
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

    hessian_pattern pattern_ = hessian_pattern::dense;
    Eigen::Matrix<S, Eigen::Dynamic, 1> diagonal_, below_, room_;
    block_of<V> dense_;
    own<Eigen::LDLT<block_of<V>, Eigen::Lower>> dense_factors_;
    Eigen::SparseMatrix<S> sparse_;
    own<Eigen::SimplicialLDLT<Eigen::SparseMatrix<S>, Eigen::Lower>> simplicial_;
};

} // namespace hilger::detail
