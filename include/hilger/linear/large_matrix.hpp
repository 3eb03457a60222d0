// SPDX-License-Identifier: BSL-1.0
// A matrix too large for elimination.hpp, dense or sparse by its pattern, with Eigen's factors. A file of its own: these factors take half
// of the time in which a step is compiled, and small matrices do without them.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include <Eigen/LU>
#include <Eigen/SparseLU>

#include "hilger/linear/regular.hpp"

namespace hilger::detail {

/// Factors of a sparse matrix. Eigen's cannot be copied: a copied matrix makes its own.
template <class S>
struct sparse_factors : std::unique_ptr<Eigen::SparseLU<Eigen::SparseMatrix<S>>> {
    sparse_factors() = default;
    sparse_factors(sparse_factors const&) : sparse_factors() {}
    sparse_factors(sparse_factors&&) noexcept = default;
    sparse_factors& operator=(sparse_factors from) noexcept {
        this->swap(from);
        return *this;
    }
};

template <class S>
class large_matrix {
public:
    using vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;

    /// Sets the pattern: `entries` and the diagonal.
    void prepare(int d, std::vector<std::pair<int, int>> const& entries) {
        d_ = d;
        is_sparse_ = 8 * entries.size() < static_cast<std::size_t>(d) * static_cast<std::size_t>(d);
        if (not is_sparse_) {
            dense_.setZero(d, d);
            return;
        }
        std::vector<Eigen::Triplet<S>> all;
        for (auto const& [j, k] : entries) all.emplace_back(j, k, S(0));
        for (int k = 0; k < d; ++k) all.emplace_back(k, k, S(0));
        sparse_.resize(d, d);
        sparse_.setFromTriplets(all.begin(), all.end());
        sparse_.makeCompressed();
        factors_.reset();
    }
    [[nodiscard]] int place(int j, int k) const {
        if (not is_sparse_) return k * d_ + j;
        int const *first = sparse_.innerIndexPtr() + sparse_.outerIndexPtr()[k],
                  *last = sparse_.innerIndexPtr() + sparse_.outerIndexPtr()[k + 1];
        return static_cast<int>(std::lower_bound(first, last, j) - sparse_.innerIndexPtr());
    }
    S* data() { return is_sparse_ ? sparse_.valuePtr() : dense_.data(); }
    [[nodiscard]] std::ptrdiff_t length() const { return is_sparse_ ? sparse_.nonZeros() : dense_.size(); }

    /// @returns false if the matrix is singular to rounding. Rows are weighed by their largest entry, as in elimination.
    bool factorize() {
        weight_.setZero(d_);
        auto const weigh = [&](index_type row, S const& x) {
            if (S const size = magnitude(x); weight_(row) < size) weight_(row) = size;
        };
        using entries = typename Eigen::SparseMatrix<S>::InnerIterator;
        if (is_sparse_)
            for (int k = 0; k < d_; ++k)
                for (entries x(sparse_, k); x; ++x) weigh(x.row(), x.value());
        else
            for (index_type k = 0; k < d_; ++k)
                for (index_type j = 0; j < d_; ++j) weigh(j, dense_(j, k));
        if (not(S(0) < weight_.minCoeff())) return false;
        weight_ = weight_.cwiseInverse();
        if (is_sparse_) return factorize_sparse();
        dense_factors_.compute(weight_.asDiagonal() * dense_);
        return is_regular(dense_factors_);
    }
    /// False for a copied sparse matrix that is not factorized itself.
    [[nodiscard]] bool has_factors() const { return not is_sparse_ or factors_ != nullptr; }
    [[nodiscard]] vector solution(vector const& r) const {
        vector const weighed = weight_.cwiseProduct(r);
        if (is_sparse_) return factors_->solve(weighed);
        return dense_factors_.solve(weighed);
    }

private:
    bool factorize_sparse() {
        Eigen::SparseMatrix<S> weighed = sparse_;
        for (int k = 0; k < d_; ++k)
            for (typename Eigen::SparseMatrix<S>::InnerIterator x(weighed, k); x; ++x) x.valueRef() = x.value() * weight_(x.row());
        if (not factors_) {
            factors_.reset(new Eigen::SparseLU<Eigen::SparseMatrix<S>>);
            factors_->analyzePattern(weighed);
        }
        factors_->factorize(weighed);
        if (factors_->info() != Eigen::Success) return false;
        // Its pivots are not accessible; a pivot without correct digits makes the inverse too large.
        vector x(d_);
        for (int k = 0; k < d_; ++k) x(k) = S(1) + S(k % 7) / S(7);
        x = factors_->solve(x);
        return x.cwiseAbs().maxCoeff() * S(d_) * epsilon<S>() < S(1);
    }

    int d_ = 0;
    bool is_sparse_ = false;
    vector weight_; ///< of each row, 1 / its largest entry
    Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> dense_;
    Eigen::PartialPivLU<Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>> dense_factors_;
    Eigen::SparseMatrix<S> sparse_;
    sparse_factors<S> factors_;
};

} // namespace hilger::detail
