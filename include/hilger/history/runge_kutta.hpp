// SPDX-License-Identifier: BSL-1.0
// A Runge-Kutta method (A, b, c) as an integral on any T: on a step of length nu that begins with the value z, the integral of g has at the
// stages t + c_i nu the values
//   G_i = z + nu sum_j a_ij g_j,   and z <- z + nu sum_j b_j g_j at the end of the step.
// A stiffly accurate method ends its last stage there, c_s = 1 and b the last row of A. If A is regular too, the integral has an inverse,
// which is a difference quotient, and powers of it (history/stages.hpp; Lubich, Ostermann 1993). This file has the matrices of stages.
#pragma once

#include <cmath>
#include <vector>

#include "hilger/error.hpp"
#include "hilger/operator/double_double.hpp"

namespace hilger {

/// The coefficients of a method with s stages: A row by row, s x s, and b and c of length s.
template <class W>
struct runge_kutta {
    std::vector<std::vector<W>> A;
    std::vector<W> b, c;
    [[nodiscard]] std::size_t stages() const { return A.size(); }
};

namespace detail::memory {

template <class W>
using stage_matrix = std::vector<std::vector<W>>;

template <class W>
stage_matrix<W> scaled_identity(std::size_t n, W const& x) {
    stage_matrix<W> m(n, std::vector<W>(n, W(0)));
    for (std::size_t i = 0; i < n; ++i) m[i][i] = x;
    return m;
}
/// x + y a b
template <class W>
stage_matrix<W> multiply_add(stage_matrix<W> x, W const& y, stage_matrix<W> const& a, stage_matrix<W> const& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < a.size(); ++k)
            for (std::size_t j = 0; j < a.size(); ++j) x[i][j] = x[i][j] + y * (a[i][k] * b[k][j]);
    return x;
}
/// The inverse by elimination with row pivots, whose sizes are compared in S. @throws error::invalid_parameter if it is singular to
/// rounding
template <class S, class W>
stage_matrix<W> inverse(stage_matrix<W> a) {
    std::size_t const n = a.size();
    auto x = scaled_identity(n, W(1));
    auto const size = [](W const& entry) { return magnitude(static_cast<S>(entry)); };
    S largest(0);
    for (auto const& row : a)
        for (auto const& entry : row) largest = std::max(largest, size(entry));
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t best = k;
        for (std::size_t i = k + 1; i < n; ++i)
            if (size(a[best][k]) < size(a[i][k])) best = i;
        std::swap(a[k], a[best]);
        std::swap(x[k], x[best]);
        if (not(S(static_cast<int>(n)) * epsilon<S>() * largest < size(a[k][k])))
            error::raise<error::invalid_parameter>("the matrix A of a Runge-Kutta method with powers is regular, and this one is singular");
        W const pivot = W(1) / a[k][k];
        for (std::size_t j = 0; j < n; ++j) a[k][j] = a[k][j] * pivot, x[k][j] = x[k][j] * pivot;
        for (std::size_t i = 0; i < n; ++i) {
            if (i == k) continue;
            W const factor = a[i][k];
            for (std::size_t j = 0; j < n; ++j) {
                a[i][j] = a[i][j] - factor * a[k][j];
                x[i][j] = x[i][j] - factor * x[k][j];
            }
        }
    }
    return x;
}
/// e^y - 1 by its series, |y| <= 1.
template <class W>
W series_of_expm1(W const& y) {
    W sum(0), term(1);
    for (int k = 1; k <= 100; ++k) {
        term = term * y / W(k);
        sum = sum + term;
    }
    return sum;
}

/// A^-beta, 0 <= beta < 1, for eigenvalues in the right half plane: by the trapezoidal rule in ln x,
///   A^-beta = (sin(pi beta) / pi) Int_0^inf x^{beta-1} (1 + x A)^{-1} dx,
/// with a factor that makes 1^-beta = 1. Beyond the rule's ends (1 + x A)^{-1} is 1 and A^{-1}/x to rounding, and sums are geometric.
template <class S, class W>
stage_matrix<W> inverse_power(stage_matrix<W> const& A, S const& beta) {
    using std::log;
    std::size_t const s = A.size();
    if (beta == S(0)) return scaled_identity(s, W(1));
    double const digits = 10 - (std::is_same_v<S, W> ? 1 : 2) * static_cast<double>(log(epsilon<S>())), step = 9.8 / digits; // pi^2
    W const h = W(S(step)), ratio = W(1) + series_of_expm1(h), lift = W(1) + series_of_expm1(W(W(beta) * h));
    auto const one = scaled_identity(s, W(1));
    auto sum = scaled_identity(s, W(0));
    W factor(0);
    auto const add = [&](W const& weight, stage_matrix<W> const& matrix, W const& number) {
        for (std::size_t i = 0; i < s; ++i)
            for (std::size_t j = 0; j < s; ++j) sum[i][j] = sum[i][j] + weight * matrix[i][j];
        factor = factor + weight * number;
    };
    auto const add_node = [&](W const& x, W const& weight) { add(weight, inverse<S>(multiply_add(one, x, A, one)), W(W(1) / (W(1) + x))); };
    add_node(W(1), W(1));
    W low(1), high(1), low_weight(1), high_weight(1);
    for (double at = step; at < digits; at += step) {
        add_node(low = low / ratio, low_weight = low_weight / lift);
        add_node(high = high * ratio, high_weight = high_weight * lift);
    }
    add(low_weight / (lift - W(1)), one, W(1));
    add(high_weight / high / series_of_expm1(W((W(1) - W(beta)) * h)), inverse<S>(A), W(1));
    for (auto& row : sum)
        for (W& entry : row) entry = entry / factor;
    return sum;
}

/// (1 + x A)^{-1} 1 and x b (1 + x A)^{-1} as quotients of polynomials in x with one denominator (Faddeev, LeVerrier).
template <class S>
class stage_functions {
public:
    template <class W>
    explicit stage_functions(runge_kutta<W> const& method) : stages_(method.stages()) {
        auto const zero = scaled_identity(stages_, W(0));
        auto adjugate = scaled_identity(stages_, W(1)); // of 1 + x A is the sum of x^k times these
        W coefficient(1);                               // of x^k in the determinant
        for (std::size_t k = 0; k < stages_; ++k) {
            denominator_.push_back(static_cast<S>(coefficient));
            for (std::size_t i = 0; i < stages_; ++i) {
                W row(0), column(0);
                for (std::size_t j = 0; j < stages_; ++j) {
                    row = row + adjugate[i][j];
                    column = column + method.b[j] * adjugate[j][i];
                }
                answer_.push_back(static_cast<S>(row));
                gain_.push_back(static_cast<S>(column));
            }
            auto const product = multiply_add(zero, W(1), method.A, adjugate);
            coefficient = W(0);
            for (std::size_t i = 0; i < stages_; ++i) coefficient = coefficient + product[i][i];
            coefficient = coefficient / W(static_cast<int>(k + 1));
            adjugate = multiply_add(scaled_identity(stages_, coefficient), W(-1), product, scaled_identity(stages_, W(1)));
        }
        denominator_.push_back(static_cast<S>(coefficient));
    }
    /// answer and gain: arrays of s numbers.
    void evaluate(S const& x, S* answer, S* gain) const {
        for (std::size_t i = 0; i < stages_; ++i) answer[i] = gain[i] = S(0);
        S determinant = denominator_[stages_];
        for (std::size_t k = stages_; k-- > 0;) {
            determinant = determinant * x + denominator_[k];
            for (std::size_t i = 0; i < stages_; ++i) {
                answer[i] = answer[i] * x + answer_[k * stages_ + i];
                gain[i] = gain[i] * x + gain_[k * stages_ + i];
            }
        }
        for (std::size_t i = 0; i < stages_; ++i) {
            answer[i] = answer[i] / determinant;
            gain[i] = x * gain[i] / determinant;
        }
    }
    [[nodiscard]] std::size_t stages() const { return stages_; }
    /// The determinant of A.
    [[nodiscard]] S const& determinant() const { return denominator_[stages_]; }

private:
    std::size_t stages_;
    std::vector<S> denominator_, answer_, gain_;
};

/// The method in numbers W. @throws error::mismatch for A, b and c of several sizes, error::invalid_parameter if it is not stiffly accurate
template <class S, class W, class Given>
runge_kutta<W> require_stiffly_accurate(runge_kutta<Given> const& given) {
    std::size_t const s = given.stages();
    runge_kutta<W> method;
    for (auto const& row : given.A) {
        if (row.size() != s or given.b.size() != s or given.c.size() != s)
            error::raise<error::mismatch>("a Runge-Kutta method has s x s, s and s numbers, and this one has a row of ", row.size(), " in ",
                                          s, ", then ", given.b.size(), " and ", given.c.size());
        method.A.emplace_back(row.begin(), row.end());
    }
    method.b.assign(given.b.begin(), given.b.end());
    method.c.assign(given.c.begin(), given.c.end());
    auto const same = [](W const& x, W const& y) { return magnitude(static_cast<S>(x - y)) <= S(16) * epsilon<S>(); };
    bool is = s > 0 and same(method.c[s - 1], W(1));
    for (std::size_t j = 0; is and j < s; ++j) is = same(method.A[s - 1][j], method.b[j]);
    if (not is)
        error::raise<error::invalid_parameter>("powers of an integral need a stiffly accurate Runge-Kutta method, whose last stage is the "
                                               "end of the step: c_s = 1 and the last row of A is b");
    return method;
}

} // namespace detail::memory
} // namespace hilger
