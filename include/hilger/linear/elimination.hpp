// SPDX-License-Identifier: BSL-1.0
// K x = r by elimination with partial pivoting, for matrices that are small or have a narrow band. One type serves all sizes; Eigen's
// factorizations need one for each, and are not faster here.
#pragma once

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>
#include <vector>

#include "hilger/linear/regular.hpp"

namespace hilger::detail {

/// For d rows; if d is known (not Eigen::Dynamic) nothing is allocated.
template <class S, int D = -1>
class elimination {
    template <class X, int Size>
    using list = std::conditional_t<D == -1, std::vector<X>, std::array<X, static_cast<std::size_t>(D == -1 ? 1 : Size)>>;

public:
    elimination() = default;
    /// A full matrix.
    explicit elimination(int d) : d_(d), below_(d - 1), above_(d - 1), stride_(d) { make_room(); }
    /// A band matrix: entries reach so far below and above the diagonal. Pivoting adds `below` diagonals above.
    elimination(int d, int below, int above) : d_(d), below_(below), above_(above + below), stride_(2 * below + above), offset_(below) {
        make_room();
    }
    [[nodiscard]] int size() const { return d_; }
    /// Index of entry (j, k) in data().
    [[nodiscard]] int place(int j, int k) const { return j * stride_ + k + offset_; }
    [[nodiscard]] list<S, D*(D + 1)>& data() { return data_; }

    /// @returns false if the matrix is singular to rounding. Rows are weighed by their largest entry, as masses may differ in size.
    bool factorize() {
        factors_ = data_;
        for (int j = 0; j < d_; ++j) {
            S& most = scale_[at(j)];
            most = S(0);
            for (int k = std::max(0, j - below_), end = std::min(d_, j + above_ + 1); k < end; ++k) {
                S const size = magnitude(factors_[at(j, k)]);
                if (most < size) most = size;
            }
        }
        for (int k = 0; k < d_; ++k) {
            int const last_row = std::min(d_, k + below_ + 1), last_column = std::min(d_, k + above_ + 1);
            int best = k;
            S most = magnitude(factors_[at(k, k)]);
            for (int j = k + 1; j < last_row; ++j)
                if (S const size = magnitude(factors_[at(j, k)]); most < size) {
                    most = size;
                    best = j;
                }
            from_[at(k)] = best;
            if (best != k) {
                for (int c = k; c < last_column; ++c) std::swap(factors_[at(k, c)], factors_[at(best, c)]);
                std::swap(scale_[at(k)], scale_[at(best)]);
            }
            S& pivot = factors_[at(k, k)];
            if (not is_pivot(pivot, scale_[at(k)], d_)) return false;
            pivot = S(1) / pivot;
            for (int j = k + 1; j < last_row; ++j) {
                S& factor = factors_[at(j, k)];
                if (factor == S(0)) continue;
                factor = factor * pivot;
                for (int c = k + 1; c < last_column; ++c) factors_[at(j, c)] = factors_[at(j, c)] - factor * factors_[at(k, c)];
            }
        }
        return true;
    }
    /// Solves K x = r with the factors, with x in place of r.
    template <class X>
    void solve(X& x) const {
        if (below_ == 0 and above_ == 0) {
            for (int k = 0; k < d_; ++k) x(k) = x(k) * factors_[at(k, k)];
            return;
        }
        for (int k = 0; k < d_; ++k) {
            if (int const p = from_[at(k)]; p != k) std::swap(x(k), x(p));
            for (int j = k + 1, end = std::min(d_, k + below_ + 1); j < end; ++j) x(j) = x(j) - factors_[at(j, k)] * x(k);
        }
        for (int k = d_; k-- > 0;) {
            S sum = x(k);
            for (int c = k + 1, end = std::min(d_, k + above_ + 1); c < end; ++c) sum = sum - factors_[at(k, c)] * x(c);
            x(k) = sum * factors_[at(k, k)];
        }
    }

private:
    static std::size_t at(int j) { return static_cast<std::size_t>(j); }
    [[nodiscard]] std::size_t at(int j, int k) const { return static_cast<std::size_t>(place(j, k)); }
    void make_room() {
        if constexpr (D == -1) {
            data_.resize(d_ == 0 ? 0 : at(place(d_ - 1, d_ - 1) + above_ + 1));
            scale_.resize(at(d_));
            from_.resize(at(d_));
        }
        std::fill(data_.begin(), data_.end(), S(0));
    }
    int d_ = 0, below_ = 0, above_ = 0, stride_ = 0, offset_ = 0;
    list<S, D*(D + 1)> data_, factors_; ///< factors: L without its diagonal, U with the inverse of its own
    list<S, D> scale_;
    list<int, D> from_; ///< the row of each pivot
};

/// The elimination of a full matrix.
template <class S, class Matrix>
auto elimination_of(Matrix const& K) {
    int const d = static_cast<int>(K.rows());
    elimination<S, Matrix::RowsAtCompileTime> e(d);
    for (int j = 0; j < d; ++j)
        for (int k = 0; k < d; ++k) e.data()[static_cast<std::size_t>(e.place(j, k))] = K(j, k);
    return e;
}
/// Replaces K by its inverse. @returns false if it is singular to rounding
template <class Matrix>
bool invert(Matrix& K) {
    using S = typename Matrix::Scalar;
    auto e = elimination_of<S>(K);
    if (not e.factorize()) return false;
    for (int c = 0; c < e.size(); ++c) {
        auto column = K.col(c);
        for (int j = 0; j < e.size(); ++j) column(j) = S(j == c ? 1 : 0);
        e.solve(column);
    }
    return true;
}

} // namespace hilger::detail
