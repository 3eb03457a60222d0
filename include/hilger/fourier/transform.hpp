// SPDX-License-Identifier: BSL-1.0
// A Fourier transform for convolutions, in any real scalar: the residues of a polynomial of length L = 2^k modulo x^L - i, i.e. its values
// at the L-th roots of i, in bit-reversed order. Real polynomials of length 2L are multiplied modulo x^{2L} + 1 by it: coefficients j and
// j + L are real and imaginary part. Each pass splits x^{2n} - r^2 into x^n - r and x^n + r, so that one block has one constant (Fiduccia
// 1972), nothing is permuted, and one table of roots serves every length.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "hilger/scalar.hpp"
#include "hilger/simd.hpp"

namespace hilger::detail::memory {

/// The arrays of a transform: L real and L imaginary parts.
template <class S>
struct spectrum {
    line_vector<S> re, im;
};

template <class S>
class fourier {
public:
    /// Computes the roots for transforms of this length, to be called before the first: const transforms may be shared by threads.
    void reserve(std::size_t length) {
        using std::atan, std::cos, std::sin;
        for (std::size_t m = cosine_.size(); m < length; ++m) {
            S turn(0), bit = S(1) / S(2); // the bits of m behind the binary point in reversed order
            for (std::size_t rest = m; rest > 0; rest /= 2, bit = bit / S(2))
                if (rest % 2 == 1) turn = turn + bit;
            S const angle = turn * S(2) * atan(S(1)); // below pi/2
            cosine_.push_back(cos(angle));
            sine_.push_back(sin(angle));
        }
    }
    /// In place, length a power of two.
    void forward(spectrum<S>& x, std::size_t length) const { split(x.re.data(), x.im.data(), length, 2); }
    /// `length` times the inverse.
    void backward(spectrum<S>& x, std::size_t length) const { join(x.re.data(), x.im.data(), length, 2); }
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
    /// The constant r = c + i s of block b, whose parts are the blocks 2b and 2b + 1; sqrt(r) and sqrt(-r) are theirs. Block 2 is the
    /// first.
    std::pair<S, S> root(std::size_t b) const {
        S const c = cosine_[b / 2], s = sine_[b / 2];
        return b % 2 == 0 ? std::pair(c, s) : std::pair(S(-s), c);
    }
    void split(S* re, S* im, std::size_t length, std::size_t b) const {
        if (length > in_cache) {
            std::size_t const n = length / 2;
            split_block(re, im, n, b);
            split(re, im, n, 2 * b);
            split(re + n, im + n, n, 2 * b + 1);
        } else
            for (std::size_t n = length / 2, count = 1; n > 0; n /= 2, count *= 2)
                for (std::size_t k = 0; k < count; ++k) split_block(re + 2 * n * k, im + 2 * n * k, n, b * count + k);
    }
    void join(S* re, S* im, std::size_t length, std::size_t b) const {
        if (length > in_cache) {
            std::size_t const n = length / 2;
            join(re, im, n, 2 * b);
            join(re + n, im + n, n, 2 * b + 1);
            join_block(re, im, n, b);
        } else
            for (std::size_t n = 1, count = length / 2; count > 0; n *= 2, count /= 2)
                for (std::size_t k = 0; k < count; ++k) join_block(re + 2 * n * k, im + 2 * n * k, n, b * count + k);
    }
    void split_block(S* re, S* im, std::size_t n, std::size_t b) const {
        auto const [c, s] = root(b);
        for (std::size_t j = 0; j < n; ++j) {
            S const p = c * re[j + n] - s * im[j + n], q = c * im[j + n] + s * re[j + n];
            re[j + n] = re[j] - p;
            im[j + n] = im[j] - q;
            re[j] = re[j] + p;
            im[j] = im[j] + q;
        }
    }
    void join_block(S* re, S* im, std::size_t n, std::size_t b) const {
        auto const [c, s] = root(b);
        for (std::size_t j = 0; j < n; ++j) {
            S const p = re[j] - re[j + n], q = im[j] - im[j + n];
            re[j] = re[j] + re[j + n];
            im[j] = im[j] + im[j + n];
            re[j + n] = c * p + s * q;
            im[j + n] = c * q - s * p;
        }
    }
    std::vector<S> cosine_, sine_; ///< exp(2 pi i t / 4), t the bits of the index behind the binary point in reversed order
};

} // namespace hilger::detail::memory
