// SPDX-License-Identifier: BSL-1.0
// A square matrix with a sparsity pattern that is known before its numbers. The pattern selects the solver: elimination with partial
// pivoting for a small size or a narrow band, as a diagonal, otherwise Eigen.
#pragma once

#include <utility>
#include <vector>

#include "hilger/linear/elimination.hpp"
#include "hilger/linear/large_matrix.hpp"

namespace hilger::detail {

/// `Most`: upper bound of the size, if known.
template <class S, int Most = Eigen::Dynamic>
class patterned_matrix {
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
        is_large_ = false;
        if (below + above == 0 or 2 * (2 * below + above + 1) < d)
            few_ = elimination<S>(d, below, above);
        else if (d <= small)
            few_ = elimination<S>(d);
        else if constexpr (may_be_large) {
            is_large_ = true;
            large_.prepare(d, entries);
        }
    }
    [[nodiscard]] int size() const { return d_; }
    /// Index of entry (j, k).
    [[nodiscard]] int place(int j, int k) const {
        if constexpr (may_be_large)
            if (is_large_) return large_.place(j, k);
        return few_.place(j, k);
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
            if (is_large_) return factorized_ = large_.factorize();
        return factorized_ = few_.factorize();
    }
    /// Whether the factors are those of the current entries.
    [[nodiscard]] bool is_factorized() const {
        if constexpr (may_be_large)
            if (is_large_) return factorized_ and large_.has_factors();
        return factorized_;
    }
    /// Solves K x = r with the factors, with x in place of r.
    template <class X>
    void solve(X& x) const {
        if constexpr (may_be_large)
            if (is_large_) {
                x = large_.solution(x);
                return;
            }
        few_.solve(x);
    }
    /// x = K^-1 r
    template <class R, class X>
    void solve(R const& r, X& x) const {
        x = r;
        solve(x);
    }

private:
    S* data() {
        if constexpr (may_be_large)
            if (is_large_) return large_.data();
        return few_.data().data();
    }
    std::ptrdiff_t length() {
        if constexpr (may_be_large)
            if (is_large_) return large_.length();
        return static_cast<std::ptrdiff_t>(few_.data().size());
    }

    struct never {};
    bool is_large_ = false, factorized_ = false;
    int d_ = 0;
    elimination<S> few_;
    [[no_unique_address]] std::conditional_t<may_be_large, large_matrix<S>, never> large_;
};

} // namespace hilger::detail
