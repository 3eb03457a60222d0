// SPDX-License-Identifier: BSL-1.0
// Powers of the difference quotient D of a Runge-Kutta method on any T as whole matrices in 50 digits: D is the inverse of the integral,
// D^{1/2} its block triangular square root (Bjoerck, Hammarling 1983), D^{1/4} the root of that, and all others are products.
#pragma once

#include <vector>

#include <Eigen/LU>

#include "hilger/history/runge_kutta.hpp"
#include "hilger/multiprecision.hpp"

namespace hilger::testing {

class stage_judge {
public:
    using matrix = Eigen::Matrix<float50, Eigen::Dynamic, Eigen::Dynamic>;

    stage_judge(runge_kutta<float50> const& method, std::vector<double> const& steps)
        : stages_(static_cast<index_type>(method.stages())), steps_(static_cast<index_type>(steps.size())) {
        matrix A(stages_, stages_), b(1, stages_);
        for (index_type i = 0; i < stages_; ++i) {
            b(0, i) = method.b[static_cast<std::size_t>(i)];
            for (index_type j = 0; j < stages_; ++j) A(i, j) = method.A[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
        }
        matrix const one = matrix::Ones(stages_, 1), inverse = A.partialPivLu().inverse();
        integral = difference = matrix::Zero(size(), size());
        for (index_type n = 0; n < steps_; ++n) {
            float50 const nu(steps[static_cast<std::size_t>(n)]);
            block(integral, n, n) = A * nu;
            block(difference, n, n) = inverse / nu;
            if (n > 0) block(difference, n, n - 1).rightCols(1) = -inverse * one / nu;
            for (index_type j = 0; j < n; ++j) block(integral, n, j) = one * b * float50(steps[static_cast<std::size_t>(j)]);
        }
        half = root(difference);
        quarter = root(half);
    }
    matrix integral, difference, half, quarter;

    /// D^{quarters/4}, quarters = 1, ..., 6.
    [[nodiscard]] matrix power(int quarters) const {
        matrix result = quarters % 2 == 1 ? quarter : matrix(matrix::Identity(size(), size()));
        if (quarters / 2 % 2 == 1) result = product(half, result);
        return quarters >= 4 ? product(difference, result) : result;
    }
    /// Of block triangles.
    [[nodiscard]] matrix product(matrix const& x, matrix const& y) const {
        matrix result = matrix::Zero(size(), size());
        for (index_type n = 0; n < steps_; ++n)
            for (index_type j = 0; j <= n; ++j)
                result.block(n * stages_, j * stages_, stages_, stages_) =
                    x.block(n * stages_, j * stages_, stages_, (n - j + 1) * stages_)
                        .lazyProduct(y.block(j * stages_, j * stages_, (n - j + 1) * stages_, stages_));
        return result;
    }
    [[nodiscard]] index_type size() const { return stages_ * steps_; }

private:
    [[nodiscard]] Eigen::Block<matrix> block(matrix& x, index_type n, index_type j) const {
        return x.block(n * stages_, j * stages_, stages_, stages_);
    }
    /// R_nn R_nj + R_nj R_jj = X_nj - sum of R_nk R_kj over j < k < n.
    [[nodiscard]] matrix root(matrix x) const {
        matrix r = matrix::Zero(size(), size());
        for (index_type n = 0; n < steps_; ++n) {
            block(r, n, n) = root_of_block(block(x, n, n));
            matrix const left = block(r, n, n);
            for (index_type j = n; j-- > 0;) {
                matrix right = block(x, n, j), const_of_j = block(r, j, j);
                for (index_type k = j + 1; k < n; ++k) right -= block(r, n, k).lazyProduct(block(r, k, j));
                matrix kronecker = matrix::Zero(stages_ * stages_, stages_ * stages_); // of columns
                for (index_type c = 0; c < stages_; ++c)
                    for (index_type d = 0; d < stages_; ++d) {
                        if (c == d) kronecker.block(c * stages_, c * stages_, stages_, stages_) += left;
                        kronecker.block(c * stages_, d * stages_, stages_, stages_).diagonal().array() += const_of_j(d, c);
                    }
                matrix const columns = Eigen::Map<matrix>(right.data(), stages_ * stages_, 1);
                matrix solved = kronecker.partialPivLu().solve(columns);
                block(r, n, j) = Eigen::Map<matrix>(solved.data(), stages_, stages_);
            }
        }
        return r;
    }
    /// Denman, Beavers 1976.
    static matrix root_of_block(matrix y) {
        matrix z = matrix::Identity(y.rows(), y.rows());
        for (int k = 0; k < 40; ++k) {
            matrix const next = (y + z.partialPivLu().inverse()) / 2;
            z = (z + y.partialPivLu().inverse()).eval() / 2;
            y = next;
        }
        return y;
    }
    index_type stages_, steps_;
};

/// Scales with N steps on [0, 1]: equal, graded, uneven without order, and growing by 10^6.
inline std::vector<std::vector<double>> steps_of_scales(int N) {
    std::vector<std::vector<double>> scales(4);
    unsigned state = 7;
    for (int i = 0; i < N; ++i) {
        state = state * 1664525U + 1013904223U;
        double const t = static_cast<double>(i) / N, next = static_cast<double>(i + 1) / N;
        scales[0].push_back(1.0 / N);
        scales[1].push_back(next * next * next - t * t * t);
        scales[2].push_back((0.1 + static_cast<double>(state >> 16) / 65536) / N);
        scales[3].push_back(std::pow(10.0, 6.0 * i / (N - 1) - 7));
    }
    return scales;
}

} // namespace hilger::testing
