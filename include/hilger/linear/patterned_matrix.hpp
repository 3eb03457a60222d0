// SPDX-License-Identifier: BSL-1.0
// A square matrix with a sparsity pattern that is known before its numbers. The pattern selects the solver: the inverse of a diagonal,
// elimination with partial pivoting for a small size or a narrow band, otherwise Eigen.
#pragma once

#include <utility>
#include <vector>

#include "hilger/linear/elimination.hpp"
#include "hilger/linear/large_matrix.hpp"

namespace hilger::detail {

/// `Most`: upper bound of the size, if known.
template <class S, int Most = Eigen::Dynamic>
class patterned_matrix {
    enum class solver { diagonal, elimination, large };
    static constexpr int small = 16; // up to here Eigen's blocks are not worth their setup
    static constexpr bool may_be_large = Most == Eigen::Dynamic or Most > small;

public:
    /// Sets the pattern: `entries` and the diagonal.
    void prepare(int d, std::vector<std::pair<int, int>> const& entries) {
        d_ = d;
        int below = 0, above = 0;
        for (auto const& [j, k] : entries) {
            below = std::max(below, j - k);
            above = std::max(above, k - j);
        }
        how_ = solver::elimination;
        if (below == 0 and above == 0) {
            how_ = solver::diagonal;
            diagonal_.assign(static_cast<std::size_t>(d), S(0));
        } else if (2 * (2 * below + above + 1) < d)
            few_ = elimination<S>(d, below, above);
        else if (d <= small)
            few_ = elimination<S>(d);
        else if constexpr (may_be_large) {
            how_ = solver::large;
            large_.prepare(d, entries);
        }
    }
    [[nodiscard]] int size() const { return d_; }
    /// Index of entry (j, k).
    [[nodiscard]] int place(int j, int k) const {
        if constexpr (may_be_large)
            if (how_ == solver::large) return large_.place(j, k);
        return how_ == solver::diagonal ? j : few_.place(j, k);
    }
    void set_zero() {
        factorized_ = false;
        for (S *x = data(), *end = x + length(); x != end; ++x) *x = S(0);
    }
    S& operator[](int place) { return data()[place]; }
    /// The largest magnitude of an entry.
    [[nodiscard]] S largest() {
        S most(0);
        for (S *x = data(), *end = x + length(); x != end; ++x)
            if (S const size = magnitude(*x); most < size) most = size;
        return most;
    }

    /// @returns false if the matrix is singular to rounding
    bool factorize() {
        if constexpr (may_be_large)
            if (how_ == solver::large) return factorized_ = large_.factorize();
        return factorized_ = how_ == solver::diagonal ? inverted() : few_.factorize();
    }
    /// Whether the factors are those of the current entries.
    [[nodiscard]] bool is_factorized() const {
        if constexpr (may_be_large)
            if (how_ == solver::large) return factorized_ and large_.has_factors();
        return factorized_;
    }
    /// Solves K x = r with the factors, with x in place of r.
    template <class X>
    void solve(X& x) const {
        if constexpr (may_be_large)
            if (how_ == solver::large) {
                x = large_.solution(x);
                return;
            }
        if (how_ == solver::elimination) return few_.solve(x);
        for (int k = 0; k < d_; ++k) x(k) = x(k) * inverse_[static_cast<std::size_t>(k)];
    }
    /// x = K^-1 r
    template <class R, class X>
    void solve(R const& r, X& x) const {
        x = r;
        solve(x);
    }

private:
    bool inverted() {
        inverse_ = diagonal_;
        for (S& x : inverse_) {
            if (not is_divisor(x)) return false;
            x = S(1) / x;
        }
        return true;
    }
    S* data() {
        if constexpr (may_be_large)
            if (how_ == solver::large) return large_.data();
        return how_ == solver::elimination ? few_.data().data() : diagonal_.data();
    }
    std::ptrdiff_t length() {
        if constexpr (may_be_large)
            if (how_ == solver::large) return large_.length();
        return static_cast<std::ptrdiff_t>(how_ == solver::elimination ? few_.data().size() : diagonal_.size());
    }

    struct never {};
    solver how_ = solver::elimination;
    bool factorized_ = false;
    int d_ = 0;
    elimination<S> few_;
    std::vector<S> diagonal_, inverse_;
    [[no_unique_address]] std::conditional_t<may_be_large, large_matrix<S>, never> large_;
};

} // namespace hilger::detail
