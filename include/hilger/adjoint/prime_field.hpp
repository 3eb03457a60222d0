// SPDX-License-Identifier: BSL-1.0
// The integers modulo the prime 2^61 - 1: an exact field whose random elements satisfy no accidental identity.
#pragma once

#include <cstdint>

#include "hilger/scalar.hpp"

namespace hilger {

class prime_field {
public:
    static constexpr std::uint64_t prime = (std::uint64_t(1) << 61) - 1;

    constexpr prime_field() = default;
    constexpr explicit(false) prime_field(long long n)
        : residue_(n < 0 ? prime - reduce(static_cast<std::uint64_t>(-n)) : reduce(static_cast<std::uint64_t>(n))) {
        if (residue_ == prime) residue_ = 0;
    }
    static constexpr prime_field residue(std::uint64_t n) {
        prime_field x;
        x.residue_ = reduce(n);
        return x;
    }
    [[nodiscard]] constexpr std::uint64_t value() const { return residue_; } ///< from 0 to prime - 1
    friend constexpr prime_field operator+(prime_field a, prime_field b) { return residue(a.residue_ + b.residue_); }
    friend constexpr prime_field operator-(prime_field a, prime_field b) { return residue(a.residue_ + prime - b.residue_); }
    friend constexpr prime_field operator-(prime_field a) { return residue(prime - a.residue_); }
    friend constexpr prime_field operator*(prime_field a, prime_field b) {
        // Two 61-bit numbers: the high and the low part of the product, which 2^61 = 1 lets us add.
        std::uint64_t const a1 = a.residue_ >> 31, a0 = a.residue_ & mask31;
        std::uint64_t const b1 = b.residue_ >> 31, b0 = b.residue_ & mask31;
        std::uint64_t const middle = a1 * b0 + a0 * b1; // a b = a1 b1 2^62 + middle 2^31 + a0 b0
        return residue(reduce(2 * (a1 * b1)) + (middle >> 30) + ((middle & mask30) << 31) + reduce(a0 * b0));
    }
    friend constexpr prime_field operator/(prime_field a, prime_field b) { return a * b.inverse(); }
    friend constexpr bool operator==(prime_field, prime_field) = default;

private:
    static constexpr std::uint64_t mask30 = (std::uint64_t(1) << 30) - 1;
    static constexpr std::uint64_t mask31 = (std::uint64_t(1) << 31) - 1;

    static constexpr std::uint64_t reduce(std::uint64_t n) {
        n = (n & prime) + (n >> 61);
        return n >= prime ? n - prime : n;
    }
    /// By Euclid's algorithm; of zero it is zero, which no operator divides by.
    [[nodiscard]] constexpr prime_field inverse() const {
        std::int64_t r0 = static_cast<std::int64_t>(prime), r1 = static_cast<std::int64_t>(residue_), s0 = 0, s1 = 1;
        while (r1 != 0) {
            std::int64_t const quotient = r0 / r1;
            r0 -= quotient * r1;
            s0 -= quotient * s1;
            std::int64_t const r = r0, s = s0;
            r0 = r1, s0 = s1;
            r1 = r, s1 = s;
        }
        return prime_field(s0);
    }
    std::uint64_t residue_ = 0;
};

} // namespace hilger
