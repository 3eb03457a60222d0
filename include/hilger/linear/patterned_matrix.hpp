// SPDX-License-Identifier: BSL-1.0
// A square matrix of which it is known before any number is what of it is not zero. That decides how it is solved with: by its inverse
// where it is diagonal, by elimination with partial pivots where it is small or has a narrow band; otherwise by Eigen, dense or sparse.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <Eigen/LU>
#include <Eigen/SparseLU>

#include "hilger/linear/elimination.hpp"

namespace hilger::detail {

/// A factorization of one's own: Eigen's cannot be copied, or not before they are used, and a copy makes its own.
template <class Factors>
struct own : std::unique_ptr<Factors> {
    own() = default;
    own(own const&) : own() {}
    own(own&&) = default;
    own& operator=(own const&) { return *this; }
    own& operator=(own&&) = default;
};

template <class S>
class patterned_matrix {
    enum class solver { diagonal, elimination, dense, sparse };
    static constexpr int small = 16; // up to here a library's blocks are not worth their setting up

public:
    using vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;

    /// Entries that may be different from zero, and the diagonal.
    void prepare(int d, std::vector<std::pair<int, int>> const& entries);
    [[nodiscard]] int size() const { return d_; }
    /// Where an entry is kept.
    [[nodiscard]] int place(int j, int k) const {
        if (how_ == solver::diagonal) return j;
        if (how_ == solver::elimination) return few_.place(j, k);
        if (how_ == solver::dense) return k * d_ + j;
        int const *first = sparse_.innerIndexPtr() + sparse_.outerIndexPtr()[k],
                  *last = sparse_.innerIndexPtr() + sparse_.outerIndexPtr()[k + 1];
        return static_cast<int>(std::lower_bound(first, last, j) - sparse_.innerIndexPtr());
    }
    void set_zero() {
        factorized_ = false;
        for (S *x = data(), *end = x + length(); x != end; ++x) *x = S(0);
    }
    S& operator[](int place) { return data()[place]; }
    /// The largest entry.
    [[nodiscard]] S largest() {
        S most(0);
        for (S *x = data(), *end = x + length(); x != end; ++x)
            if (S const size = magnitude(*x); most < size) most = size;
        return most;
    }

    /// False where it is singular to rounding.
    bool factorize() { return factorized_ = makes_factors(); }
    /// Since the entries were set.
    [[nodiscard]] bool is_factorized() const { return factorized_ and (how_ != solver::sparse or sparse_factors_); }
    /// x in K x = r, with the factors.
    template <class X>
    void solve(X& x) const {
        if (how_ == solver::diagonal) return solve(x, x);
        if (how_ == solver::elimination)
            few_.solve(x);
        else
            x = solution(weight_.cwiseProduct(x));
    }

    /// x = K^-1 r
    template <class R, class X>
    void solve(R const& r, X& x) const {
        if (how_ == solver::diagonal) {
            for (int k = 0; k < d_; ++k) x(k) = r(k) * weight_(k);
        } else {
            x = r;
            solve(x);
        }
    }

private:
    S* data() { return how_ == solver::sparse ? sparse_.valuePtr() : how_ == solver::elimination ? few_.data().data() : data_.data(); }
    std::ptrdiff_t length() {
        return how_ == solver::sparse ? sparse_.nonZeros()
                                      : static_cast<std::ptrdiff_t>(how_ == solver::elimination ? few_.data().size() : data_.size());
    }
    bool makes_factors();
    vector solution(vector const& weighed) const;
    solver how_ = solver::elimination;
    bool factorized_ = false;
    int d_ = 0;
    elimination<S> few_;
    std::vector<S> data_;
    vector weight_; ///< of each row, 1 / its largest entry
    Eigen::PartialPivLU<Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>> dense_factors_;
    Eigen::SparseMatrix<S> sparse_;
    own<Eigen::SparseLU<Eigen::SparseMatrix<S>>> sparse_factors_;
};

template <class S>
void patterned_matrix<S>::prepare(int d, std::vector<std::pair<int, int>> const& entries) {
    d_ = d;
    int below = 0, above = 0;
    for (auto const& [j, k] : entries) {
        below = std::max(below, j - k);
        above = std::max(above, k - j);
    }
    int const width = 2 * below + above + 1;
    if (below == 0 and above == 0) {
        how_ = solver::diagonal;
        data_.assign(static_cast<std::size_t>(d), S(0));
    } else if (2 * width < d) {
        how_ = solver::elimination;
        few_ = elimination<S>(d, below, above);
    } else if (d <= small) {
        how_ = solver::elimination;
        few_ = elimination<S>(d);
    } else
        how_ = 8 * entries.size() < static_cast<std::size_t>(d) * static_cast<std::size_t>(d) ? solver::sparse : solver::dense;
    if (how_ == solver::dense)
        data_.assign(static_cast<std::size_t>(d) * static_cast<std::size_t>(d), S(0));
    else if (how_ == solver::sparse) {
        std::vector<Eigen::Triplet<S>> all;
        for (auto const& [j, k] : entries) all.emplace_back(j, k, S(0));
        for (int k = 0; k < d; ++k) all.emplace_back(k, k, S(0));
        sparse_.resize(d, d);
        sparse_.setFromTriplets(all.begin(), all.end());
        sparse_.makeCompressed();
        sparse_factors_.reset(); // made for the pattern where they are first asked for
    }
}
/// Rows are weighed by their largest entry, as elimination weighs them.
template <class S>
bool patterned_matrix<S>::makes_factors() {
    if (how_ == solver::elimination) return few_.factorize();
    if (how_ == solver::diagonal) {
        weight_.resize(d_);
        for (int k = 0; k < d_; ++k) {
            S const& x = data_[static_cast<std::size_t>(k)];
            if (not is_divisor(x)) return false;
            weight_(k) = S(1) / x;
        }
        return true;
    }
    weight_.setZero(d_);
    auto const weigh = [&](index_type row, S const& x) {
        if (S const size = magnitude(x); weight_(row) < size) weight_(row) = size;
    };
    if (how_ == solver::dense) {
        Eigen::Map<Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> const> const K(data_.data(), d_, d_);
        for (index_type k = 0; k < d_; ++k)
            for (index_type j = 0; j < d_; ++j) weigh(j, K(j, k));
        if (not(S(0) < weight_.minCoeff())) return false;
        weight_ = weight_.cwiseInverse();
        dense_factors_.compute(weight_.asDiagonal() * K);
        return is_regular(dense_factors_);
    }
    using entries = typename Eigen::SparseMatrix<S>::InnerIterator;
    for (int k = 0; k < d_; ++k)
        for (entries x(sparse_, k); x; ++x) weigh(x.row(), x.value());
    if (not(S(0) < weight_.minCoeff())) return false;
    weight_ = weight_.cwiseInverse();
    Eigen::SparseMatrix<S> weighed = sparse_;
    for (int k = 0; k < d_; ++k)
        for (entries x(weighed, k); x; ++x) x.valueRef() = x.value() * weight_(x.row());
    if (not sparse_factors_) {
        sparse_factors_.reset(new Eigen::SparseLU<Eigen::SparseMatrix<S>>);
        sparse_factors_->analyzePattern(weighed);
    }
    sparse_factors_->factorize(weighed);
    if (sparse_factors_->info() != Eigen::Success) return false;
    // Its pivots are not to be seen; the inverse is, and is too large where one of them has no digit left.
    vector x(d_);
    for (int k = 0; k < d_; ++k) x(k) = S(1) + S(k % 7) / S(7);
    x = sparse_factors_->solve(x);
    return x.cwiseAbs().maxCoeff() * S(d_) * epsilon<S>() < S(1);
}
template <class S>
auto patterned_matrix<S>::solution(vector const& weighed) const -> vector {
    if (how_ == solver::dense) return dense_factors_.solve(weighed);
    return sparse_factors_->solve(weighed);
}

} // namespace hilger::detail
