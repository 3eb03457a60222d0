// SPDX-License-Identifier: BSL-1.0
// K x = r for the values at and inside the steps of a scale, where each step couples its own values only: the sum of one block for each
// step. The values inside a step are eliminated first (static condensation), and what is left couples neighbouring points:
//   x_i = K_ii^-1 (r_i - K_ie x_e),   (K_ee - K_ei K_ii^-1 K_ie) x_e = r_e - K_ei K_ii^-1 r_i
// with i the values inside a step and e those at its ends; the sum of the blocks on the left over all steps is a band matrix. Values at
// both ends of the scale are given, and have no rows.
#pragma once

#include <algorithm>
#include <vector>

#include "hilger/linear/elimination.hpp"

namespace hilger::detail {

/// For states of D components (or Eigen::Dynamic) and `Parts` values in a step, the one at its end included.
template <class S, int D, int Parts>
class condensed_matrix {
    template <int Rows, int Columns>
    using block = Eigen::Matrix<S, D == Eigen::Dynamic ? D : Rows * D, D == Eigen::Dynamic ? D : Columns * D>;
    static constexpr int one = D, two = D == Eigen::Dynamic ? D : 2 * D, within = D == Eigen::Dynamic ? D : (Parts - 1) * D;
    struct inside {
        block<Parts - 1, Parts - 1> inverse; ///< of K_ii
        block<Parts - 1, 2> by_ends;         ///< K_ii^-1 K_ie
        block<2, Parts - 1> on_ends;         ///< K_ei
    };

public:
    using vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;

    condensed_matrix(index_type steps, int d)
        : d_(d), steps_(static_cast<int>(steps)), inner_((Parts - 1) * d), inside_(Parts > 1 ? static_cast<std::size_t>(steps) : 0),
          on_T_((steps_ - 1) * d, 2 * d - 1, 2 * d - 1), at_ends_(block<2, 2>::Zero(2 * d, 2 * d)) {}
    void set_zero() {
        std::fill(on_T_.data().begin(), on_T_.data().end(), S(0));
        largest_ = S(0);
        is_regular_ = true;
    }
    /// Adds the block of step i, for its Parts + 1 values in order.
    template <class Block>
    void add(index_type i, Block const& K) {
        int const end = Parts * d_;
        for (int const row : {0, 1})
            for (int const column : {0, 1}) at_ends_.block(row * d_, column * d_, d_, d_) = K.block(row * end, column * end, d_, d_);
        if constexpr (Parts > 1) {
            inside& e = inside_[static_cast<std::size_t>(i)];
            e.inverse = K.block(d_, d_, inner_, inner_);
            e.by_ends.resize(inner_, 2 * d_);
            e.on_ends.resize(2 * d_, inner_);
            e.by_ends << K.block(d_, 0, inner_, d_), K.block(d_, end, inner_, d_);
            e.on_ends << K.block(0, d_, d_, inner_), K.block(end, d_, d_, inner_);
            is_regular_ = invert(e.inverse) and is_regular_;
            e.by_ends = (e.inverse * e.by_ends).eval();
            at_ends_.noalias() -= e.on_ends * e.by_ends;
        }
        int const first = (static_cast<int>(i) - 1) * d_, size = (steps_ - 1) * d_;
        for (int row = 0; row < 2 * d_; ++row)
            for (int column = 0; column < 2 * d_; ++column)
                if (0 <= first + row and first + row < size and 0 <= first + column and first + column < size)
                    on_T_.data()[static_cast<std::size_t>(on_T_.place(first + row, first + column))] += at_ends_(row, column);
        largest_ = std::max(largest_, S(K.cwiseAbs().maxCoeff()));
    }
    /// The largest magnitude of an entry of a block.
    [[nodiscard]] S const& largest() const { return largest_; }
    /// @returns false if the matrix, or that of the values inside a step, is singular to rounding
    bool factorize() { return is_regular_ and on_T_.factorize(); }
    /// Solves K x = r with the factors, with x in place of r.
    void solve(vector& x) const {
        if constexpr (Parts == 1)
            on_T_.solve(x);
        else {
            vector ends = vector::Zero((steps_ + 1) * d_);
            for (int i = 0; i < steps_; ++i) {
                if (i > 0) ends.template segment<one>(i * d_, d_) += x.template segment<one>((Parts * i - 1) * d_, d_);
                inside const& e = inside_[static_cast<std::size_t>(i)];
                auto inner = x.template segment<within>(Parts * i * d_, inner_);
                inner = (e.inverse * inner).eval();
                ends.template segment<two>(i * d_, 2 * d_).noalias() -= e.on_ends * inner;
            }
            vector between = ends.segment(d_, (steps_ - 1) * d_);
            on_T_.solve(between);
            ends.setZero();
            ends.segment(d_, (steps_ - 1) * d_) = between;
            for (int i = 0; i < steps_; ++i) {
                if (i > 0) x.template segment<one>((Parts * i - 1) * d_, d_) = ends.template segment<one>(i * d_, d_);
                x.template segment<within>(Parts * i * d_, inner_).noalias() -=
                    inside_[static_cast<std::size_t>(i)].by_ends * ends.template segment<two>(i * d_, 2 * d_);
            }
        }
    }

private:
    int d_, steps_, inner_;
    std::vector<inside> inside_;
    elimination<S> on_T_;
    block<2, 2> at_ends_; ///< of one step, condensed
    S largest_{0};
    bool is_regular_ = true;
};

} // namespace hilger::detail
