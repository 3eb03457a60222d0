// SPDX-License-Identifier: BSL-1.0
// A Fourier transform for convolutions, in any real scalar: the residues of a polynomial of length L = 2^k modulo x^L - i, i.e. its values
// at the L-th roots of i, in bit-reversed order. Real polynomials of length 2L are multiplied modulo x^{2L} + 1 by it: coefficients j and
// j + L are real and imaginary part. Each pass splits x^n - c into x^{n/4} - c_0, ..., c_3, so that one block has one constant (Fiduccia
// 1972), nothing is permuted, and one table of roots serves every length.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "hilger/fourier/pass.hpp"
#include "hilger/scalar.hpp"

namespace hilger::detail::memory {

/// exp(i theta_b / 4), theta_b = 2 pi (the bits of b behind the binary point in reversed order): the first quadrant.
template <class S>
class roots_of_unity {
public:
    S const* cosine() const { return cos_.data(); }
    S const* sine() const { return sin_.data(); }
    /// Computes the table for transforms of this length.
    void reserve(std::size_t length) {
        using std::atan;
        std::size_t const needed = length < 4 ? 4 : length;
        if (cos_.size() >= needed) return;
        // Each entry is one product of two correctly rounded factors: of the low bits of b, and of the others.
        std::vector<S> low_cos, low_sin;
        for (std::size_t b = 0; b < std::min(block, needed); ++b) exact(b, low_cos, low_sin);
        cos_.resize(needed);
        sin_.resize(needed);
        for (std::size_t high = 0; high < needed; high += block) {
            std::vector<S> c, s;
            exact(high, c, s);
            for (std::size_t b = 0; b < block and high + b < needed; ++b) {
                cos_[high + b] = low_cos[b] * c[0] - low_sin[b] * s[0];
                sin_[high + b] = low_sin[b] * c[0] + low_cos[b] * s[0];
            }
        }
    }

private:
    static constexpr std::size_t block = 1024;
    static void exact(std::size_t b, std::vector<S>& c, std::vector<S>& s) {
        using std::atan, std::cos, std::sin;
        S turn(0), bit = S(1) / S(2);
        for (; b > 0; b /= 2, bit = bit / S(2))
            if (b % 2 == 1) turn = turn + bit;
        S const angle = turn * S(2) * atan(S(1)); // pi/2 turn, below pi/2
        c.push_back(cos(angle));
        s.push_back(sin(angle));
    }
    line_vector<S> cos_, sin_;
};

/// The arrays of a transform: L real and L imaginary parts.
template <class S>
struct spectrum {
    line_vector<S> re, im;
};

template <class S>
class fourier {
public:
    /// Computes the roots for transforms of this length, to be called before the first: const transforms may be shared by threads.
    void reserve(std::size_t length) { roots_.reserve(length); }
    /// In place, length a power of two.
    void forward(spectrum<S>& x, std::size_t length) const {
        std::size_t n = length;
        if (odd_power(length)) {
            halve(x.re.data(), x.im.data(), n /= 2);
            for (std::size_t k = 0; k < 2; ++k) split(x.re.data() + k * n, x.im.data() + k * n, n, 4 + k);
        } else
            split(x.re.data(), x.im.data(), n, 2);
    }
    /// `length` times the inverse.
    void backward(spectrum<S>& x, std::size_t length) const {
        std::size_t n = length;
        if (odd_power(length)) {
            n /= 2;
            for (std::size_t k = 0; k < 2; ++k) join(x.re.data() + k * n, x.im.data() + k * n, n, 4 + k);
            unite(x.re.data(), x.im.data(), n);
        } else
            join(x.re.data(), x.im.data(), n, 2);
    }
    /// x <- x y
    static void multiply(spectrum<S>& x, spectrum<S> const& y, std::size_t length) {
        S *const a = x.re.data(), *const b = x.im.data();
        S const *const c = y.re.data(), *const d = y.im.data();
        for (std::size_t j = 0; j < length; ++j) {
            S const re = a[j] * c[j] - b[j] * d[j], im = a[j] * d[j] + b[j] * c[j];
            a[j] = re;
            b[j] = im;
        }
    }

private:
    static constexpr std::size_t in_cache = 1024; // larger blocks are finished one part after the other
    static bool odd_power(std::size_t length) {
        bool odd = false;
        for (; length > 1; length /= 2) odd = not odd;
        return odd;
    }
    void split(S* re, S* im, std::size_t n, std::size_t b) const {
        if (n > in_cache) {
            passes_.split(re, im, n, 1, b, roots_.cosine(), roots_.sine());
            for (std::size_t k = 0; k < 4; ++k) split(re + k * (n / 4), im + k * (n / 4), n / 4, 4 * b + k);
        } else
            for (std::size_t count = 1; n >= 4; n /= 4, count *= 4, b *= 4)
                passes_.split(re, im, n, count, b, roots_.cosine(), roots_.sine());
    }
    void join(S* re, S* im, std::size_t n, std::size_t b) const {
        if (n > in_cache) {
            for (std::size_t k = 0; k < 4; ++k) join(re + k * (n / 4), im + k * (n / 4), n / 4, 4 * b + k);
            passes_.join(re, im, n, 1, b, roots_.cosine(), roots_.sine());
        } else
            for (std::size_t part = 4; part <= n; part *= 4)
                passes_.join(re, im, part, n / part, b * (n / part), roots_.cosine(), roots_.sine());
    }
    /// Splits x^{2n} - i into x^n -+ sqrt(i), the second table entry.
    void halve(S* re, S* im, std::size_t n) const {
        S const c = roots_.cosine()[1], s = roots_.sine()[1];
        for (std::size_t j = 0; j < n; ++j) {
            S const p = c * re[j + n] - s * im[j + n], q = c * im[j + n] + s * re[j + n];
            re[j + n] = re[j] - p;
            im[j + n] = im[j] - q;
            re[j] = re[j] + p;
            im[j] = im[j] + q;
        }
    }
    void unite(S* re, S* im, std::size_t n) const {
        S const c = roots_.cosine()[1], s = roots_.sine()[1];
        for (std::size_t j = 0; j < n; ++j) {
            S const p = re[j] - re[j + n], q = im[j] - im[j + n];
            re[j] = re[j] + re[j + n];
            im[j] = im[j] + im[j + n];
            re[j + n] = c * p + s * q;
            im[j + n] = c * q - s * p;
        }
    }
    roots_of_unity<S> roots_;
    fourier_passes<S> passes_;
};

} // namespace hilger::detail::memory
