// SPDX-License-Identifier: BSL-1.0
// The discrete Fourier transform X_k = sum_j x_j exp(-2 pi i j k / n) for n a power of two, in any scalar that has a sine: float to a
// hundred digits. Roots of unity are computed one by one, each to half an ulp (a recurrence for them would lose log n digits), so the error
// of a transform is a few epsilon times log n times the root mean square of the data. Passes take two levels at once and go
// depth first, so that a transform larger than the cache still works inside it.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "hilger/error.hpp"
#include "hilger/scalar.hpp"

namespace hilger {

/// Real and imaginary part. std::complex is specified for the processor's floats only, and its product looks for infinities.
template <class S>
struct complex_number {
    S re{0}, im{0};

    friend constexpr complex_number operator+(complex_number const& x, complex_number const& y) { return {x.re + y.re, x.im + y.im}; }
    friend constexpr complex_number operator-(complex_number const& x, complex_number const& y) { return {x.re - y.re, x.im - y.im}; }
    friend constexpr complex_number operator*(complex_number const& x, complex_number const& y) {
        return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
    }
    friend constexpr complex_number operator*(S const& c, complex_number const& x) { return {c * x.re, c * x.im}; }
    friend constexpr complex_number conj(complex_number const& x) { return {x.re, -x.im}; }
    [[nodiscard]] constexpr complex_number times_i() const { return {-im, re}; }
};

namespace detail {

/// Where a sine is computed, so that rounding it to S leaves half an ulp.
template <class S>
struct finer {
    using type = S;
};
template <>
struct finer<float> {
    using type = double;
};
template <>
struct finer<double> {
    using type = long double;
};

} // namespace detail

/// A transform of one size, with its roots of unity: those of the m-th order are in roots_[m/2 + j] = exp(-2 pi i j / m).
template <class S>
class fourier_transform {
    using C = complex_number<S>;

public:
    /// @throws error::invalid_parameter when the size is no power of two.
    explicit fourier_transform(std::size_t size) : size_(size), roots_(std::max<std::size_t>(size, 1)) {
        if (not std::has_single_bit(size))
            error::raise<error::invalid_parameter>("the size of a Fourier transform is a power of two, and this one is ", size);
        using std::atan, std::cos, std::sin;
        using fine = typename detail::finer<S>::type;
        fine const pi = fine(4) * atan(fine(1));
        std::size_t const half = size / 2;
        for (std::size_t j = 0; j <= size / 8; ++j) { // an eighth of the circle; the rest is its mirror image
            fine const angle = fine(2) * pi * fine(static_cast<long long>(j)) / fine(static_cast<long long>(size));
            S const c(cos(angle)), s(sin(angle));
            if (half > 0) roots_[half + j] = {c, S(-s)};
            if (size < 4) continue;
            roots_[half + size / 4 - j] = {s, S(-c)};
            roots_[half + size / 4 + j] = {S(-s), S(-c)};
            if (j > 0) roots_[half + half - j] = {S(-c), S(-s)};
        }
        for (std::size_t m = half; m > 1; m /= 2)
            for (std::size_t j = 0; j < m / 2; ++j) roots_[m / 2 + j] = roots_[m + 2 * j];
    }
    [[nodiscard]] std::size_t size() const { return size_; }
    /// exp(-2 pi i j / size), 0 <= j < size / 2
    [[nodiscard]] C const& root(std::size_t j) const { return roots_[size_ / 2 + j]; }

    /// X_k at the place whose binary digits are those of k reversed: what products of transforms need.
    void forward(std::vector<C>& x) const { forward(x.data(), size_); }
    /// The inverse of forward, times the size.
    void backward(std::vector<C>& x) const { backward(x.data(), size_); }

private:
    static constexpr std::size_t in_cache = 4096;

    void forward(C* x, std::size_t m) const {
        if (m > in_cache) {
            forward_pass(x, m);
            for (std::size_t part = 0; part < 4; ++part) forward(x + part * (m / 4), m / 4);
            return;
        }
        std::size_t length = m;
        for (; length >= 4; length /= 4)
            for (std::size_t at = 0; at < m; at += length) forward_pass(x + at, length);
        if (length == 2) pairs(x, m);
    }
    void backward(C* x, std::size_t m) const {
        if (m > in_cache) {
            for (std::size_t part = 0; part < 4; ++part) backward(x + part * (m / 4), m / 4);
            backward_pass(x, m);
            return;
        }
        std::size_t length = 4;
        if (std::countr_zero(m) % 2 == 1) {
            pairs(x, m);
            length = 8;
        }
        for (; length <= m; length *= 4)
            for (std::size_t at = 0; at < m; at += length) backward_pass(x + at, length);
    }
    void forward_pass(C* x, std::size_t m) const {
        std::size_t const q = m / 4;
        C const *const w = &roots_[m / 2], *const w2 = &roots_[m / 4];
        for (std::size_t j = 0; j < q; ++j) {
            C const a = x[j] + x[j + 2 * q], b = x[j] - x[j + 2 * q];
            C const c = x[j + q] + x[j + 3 * q], d = (x[j + q] - x[j + 3 * q]).times_i();
            x[j] = a + c;
            x[j + q] = (a - c) * w2[j];
            x[j + 2 * q] = (b - d) * w[j];
            x[j + 3 * q] = (b + d) * (w[j] * w2[j]);
        }
    }
    void backward_pass(C* x, std::size_t m) const {
        std::size_t const q = m / 4;
        C const *const w = &roots_[m / 2], *const w2 = &roots_[m / 4];
        for (std::size_t j = 0; j < q; ++j) {
            C const u = x[j + q] * conj(w2[j]), v = x[j + 2 * q] * conj(w[j]), z = x[j + 3 * q] * conj(w[j] * w2[j]);
            C const a = x[j] + u, b = v + z, c = x[j] - u, d = (v - z).times_i();
            x[j] = a + b;
            x[j + 2 * q] = a - b;
            x[j + q] = c + d;
            x[j + 3 * q] = c - d;
        }
    }
    static void pairs(C* x, std::size_t m) {
        for (std::size_t j = 0; j < m; j += 2) {
            C const a = x[j], b = x[j + 1];
            x[j] = a + b;
            x[j + 1] = a - b;
        }
    }
    std::size_t size_;
    std::vector<C> roots_;
};

namespace detail {
/// Calls visit(j, k), k the number whose digits are those of j reversed, for j = 0 ... size - 1.
template <class Visit>
void in_reversed_order(std::size_t size, Visit const& visit) {
    for (std::size_t j = 0, k = 0; j < size; ++j) {
        visit(j, k);
        std::size_t bit = size / 2;
        for (; bit > 0 and (k & bit) != 0; bit /= 2) k ^= bit;
        k |= bit;
    }
}
} // namespace detail

/// x becomes its transform; inverse: x_j = 1/n sum_k X_k exp(2 pi i j k / n). @throws error::invalid_parameter as above.
template <class S>
void fft(std::vector<complex_number<S>>& x, bool inverse) {
    fourier_transform<S> const transform(x.size());
    if (inverse)
        for (auto& value : x) value = conj(value);
    transform.forward(x);
    detail::in_reversed_order(x.size(), [&](std::size_t j, std::size_t k) {
        if (j < k) std::swap(x[j], x[k]);
    });
    if (inverse)
        for (auto& value : x) value = (S(1) / S(static_cast<long long>(x.size()))) * conj(value);
}

} // namespace hilger
