// SPDX-License-Identifier: BSL-1.0
// A Runge-Kutta method (A, b, c) as an integral on any T: on a step of length nu that begins with the value z, the integral of g has at the
// stages t + c_i nu the values
//   G_i = z + nu sum_j a_ij g_j,   and z <- z + nu sum_j b_j g_j at the end of the step.
// A stiffly accurate method ends its last stage there: c_s = 1 and b is the last row of A. If A is regular too, the integral has an
// inverse, a difference quotient, and powers of it (history/stages.hpp). This file has functions of A, by
//   (1 + x A)^{-1} = sum_k x^k B_k / sum_k x^k d_k   (Faddeev, LeVerrier).
#pragma once

#include <cmath>
#include <vector>

#include "hilger/error.hpp"
#include "hilger/operator/double_double.hpp"
#include "hilger/scalar.hpp"

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

/// sum + y a b
template <class W>
stage_matrix<W> multiply_add(stage_matrix<W> sum, W const& y, stage_matrix<W> const& a, stage_matrix<W> const& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < a.size(); ++k)
            for (std::size_t j = 0; j < a.size(); ++j) sum[i][j] = sum[i][j] + y * (a[i][k] * b[k][j]);
    return sum;
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

/// Of a matrix of stages, in W, a type with more digits than S if there is one.
template <class S, class W>
struct stage_resolvent {
    std::vector<stage_matrix<W>> B;
    std::vector<W> d; ///< d_0 = 1, ..., d_s, the determinant of A

    /// @throws error::invalid_parameter if A is singular to rounding
    explicit stage_resolvent(stage_matrix<W> const& A) : d{W(1)} {
        std::size_t const s = A.size();
        for (std::size_t k = 0; k < s; ++k) { // B_k = d_k - A B_{k-1}, and k d_k is the trace of A B_{k-1}
            stage_matrix<W> next(s, std::vector<W>(s, W(0)));
            for (std::size_t i = 0; i < s; ++i) next[i][i] = d[k];
            B.push_back(k == 0 ? next : multiply_add(next, W(-1), A, B[k - 1]));
            W trace(0);
            for (std::size_t i = 0; i < s; ++i)
                for (std::size_t j = 0; j < s; ++j) trace = trace + A[i][j] * B[k][j][i];
            d.push_back(trace / W(static_cast<int>(k + 1)));
        }
        auto const size = [this](std::size_t k) { return magnitude(static_cast<S>(d[k])); };
        if (not(S(static_cast<int>(s)) * epsilon<S>() * size(s - 1) < size(s)))
            error::raise<error::invalid_parameter>(
                "powers of an integral need a regular matrix A of the Runge-Kutta method, and this one is "
                "singular");
    }
    /// sum_k factor_k B_k
    stage_matrix<W> combination(std::vector<W> const& factor) const {
        stage_matrix<W> sum(B.size(), std::vector<W>(B.size(), W(0)));
        for (std::size_t k = 0; k < B.size(); ++k) sum = multiply_add(sum, factor[k], B[0], B[k]); // B_0 = 1
        return sum;
    }
    stage_matrix<W> inverse() const {
        std::vector<W> factor(B.size(), W(0));
        factor.back() = W(1) / d.back();
        return combination(factor);
    }
    /// A^-beta, 0 <= beta < 1, for eigenvalues in the right half plane: by the trapezoidal rule in ln x,
    ///   A^-beta = (sin(pi beta) / pi) Int_0^inf x^{beta-1} (1 + x A)^{-1} dx,
    /// with a factor that makes 1^-beta = 1. Beyond the rule's ends (1 + x A)^{-1} is 1 and A^{-1}/x to rounding, and sums are geometric.
    stage_matrix<W> inverse_power(S const& beta) const {
        using std::log;
        if (beta == S(0)) return B[0];
        std::size_t const s = B.size();
        std::vector<W> factor(s, W(0));
        W of_one(0);
        auto const add_node = [&](W const& y, W const& weight, bool is_far) { // at x = y, or far away at 1/y
            W determinant(0), power(1);
            for (std::size_t k = s + 1; k-- > 0;) determinant = determinant * y + d[is_far ? s - k : k];
            for (std::size_t k = 0; k < s; ++k) {
                std::size_t const at = is_far ? s - 1 - k : k;
                factor[at] = factor[at] + weight * (is_far ? power * y : power) / determinant;
                power = power * y;
            }
            of_one = of_one + weight * (is_far ? y : W(1)) / (W(1) + y);
        };
        double const digits = 10 - (std::is_same_v<S, W> ? 1 : 1.25) * static_cast<double>(log(epsilon<S>())), step = 9.8 / digits; // pi^2
        W const h = W(S(step)), down = W(1) / (W(1) + series_of_expm1(h));
        W const lift = series_of_expm1(W(W(beta) * h)), drop = series_of_expm1(W((W(1) - W(beta)) * h));
        W y(1), near(1), far(1);
        add_node(y, near, false);
        for (double at = step; at < digits; at += step) {
            y = y * down;
            add_node(y, near = near / (W(1) + lift), false);
            add_node(y, far = far * (W(1) + lift), true);
        }
        factor.front() = factor.front() + near / lift;
        factor.back() = factor.back() + far * y / drop / d.back();
        of_one = of_one + near / lift + far * y / drop;
        for (W& f : factor) f = f / of_one;
        return combination(factor);
    }
};

/// (1 + x A)^{-1} 1 and x b (1 + x A)^{-1} in numbers S.
template <class S>
class stage_functions {
public:
    template <class T, class W>
    stage_functions(stage_resolvent<T, W> const& of, std::vector<W> const& b) : stages_(b.size()) {
        for (W const& d : of.d) determinant_.push_back(static_cast<S>(static_cast<T>(d)));
        for (auto const& B : of.B)
            for (std::size_t i = 0; i < stages_; ++i) {
                W row(0), column(0);
                for (std::size_t j = 0; j < stages_; ++j) {
                    row = row + B[i][j];
                    column = column + b[j] * B[j][i];
                }
                answer_.push_back(static_cast<S>(static_cast<T>(row)));
                gain_.push_back(static_cast<S>(static_cast<T>(column)));
            }
    }
    /// At nu x for all x, stage after stage: answer[i n + j] at stage i and x_j. In powers of 1/(nu x) beyond 1, which do not overflow.
    /// Loops over x, for compilers that make packs.
    void evaluate(std::vector<S> const& x, S const& nu, std::vector<S>& answer, std::vector<S>& gain) const {
        std::size_t const n = x.size(), last = stages_ - 1;
        std::vector<S> at(n), y(n), determinant(n);
        for (std::size_t j = 0; j < n; ++j) {
            at[j] = nu * x[j];
            y[j] = S(1) < at[j] ? S(S(1) / at[j]) : at[j];
            determinant[j] = S(1) < at[j] ? determinant_[0] : determinant_[stages_];
        }
        answer.assign(n * stages_, S(0));
        gain.assign(n * stages_, S(0));
        auto const horner = [&at, &y, n](S* value, S far, S near) {
            for (std::size_t j = 0; j < n; ++j) value[j] = value[j] * y[j] + (S(1) < at[j] ? far : near);
        };
        for (std::size_t k = 0; k < stages_; ++k) {
            horner(determinant.data(), determinant_[k + 1], determinant_[last - k]);
            for (std::size_t i = 0; i < stages_; ++i) {
                horner(answer.data() + i * n, answer_[k * stages_ + i], answer_[(last - k) * stages_ + i]);
                horner(gain.data() + i * n, gain_[k * stages_ + i], gain_[(last - k) * stages_ + i]);
            }
        }
        for (std::size_t j = 0; j < n; ++j) determinant[j] = S(1) / determinant[j];
        for (std::size_t i = 0; i < stages_; ++i) {
            S *const a = answer.data() + i * n, *const g = gain.data() + i * n;
            for (std::size_t j = 0; j < n; ++j) {
                S const small = y[j] * determinant[j];
                a[j] = a[j] * (S(1) < at[j] ? small : determinant[j]);
                g[j] = g[j] * (S(1) < at[j] ? determinant[j] : small);
            }
        }
    }
    [[nodiscard]] std::size_t stages() const { return stages_; }
    [[nodiscard]] S const& determinant() const { return determinant_.back(); } ///< of A

private:
    std::size_t stages_;
    std::vector<S> determinant_, answer_, gain_;
};

/// The method in numbers W. @throws error::mismatch for A, b and c of several sizes, error::invalid_parameter if it is not stiffly accurate
template <class S, class W, class Given>
runge_kutta<W> require_stiffly_accurate(runge_kutta<Given> const& given) {
    std::size_t const s = given.stages();
    runge_kutta<W> method{{}, {given.b.begin(), given.b.end()}, {given.c.begin(), given.c.end()}};
    for (auto const& row : given.A) {
        if (row.size() != s or given.b.size() != s or given.c.size() != s)
            error::raise<error::mismatch>("a Runge-Kutta method has s x s, s and s numbers, and this one has a row of ", row.size(), " in ",
                                          s, ", then ", given.b.size(), " and ", given.c.size());
        method.A.emplace_back(row.begin(), row.end());
    }
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
