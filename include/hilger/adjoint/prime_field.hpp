// SPDX-License-Identifier: BSL-1.0
// The integers modulo a prime: an exact field whose random elements satisfy no accidental identity. The prime is the largest below 2^61 /
// 1.618..., so that no power of a small number is a quotient of small numbers, as 2^61 is modulo 2^61 - 1.
#pragma once

#include <cstdint>

#include "hilger/scalar.hpp"

namespace hilger {

/// An element of the field; integers convert to their residues.
class prime_field {
public:
    static constexpr std::uint64_t prime = 1'425'089'352'415'399'919;

    constexpr prime_field() = default;
    template <std::integral N>
    constexpr explicit(false) prime_field(N n)
        : residue_(n < 0 ? prime - reduce(-static_cast<std::uint64_t>(n)) : reduce(static_cast<std::uint64_t>(n))) {
        if (residue_ == prime) residue_ = 0;
    }
    /// The residue of n.
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
        __extension__ using wide = unsigned __int128;
        return residue(static_cast<std::uint64_t>(static_cast<wide>(a.residue_) * b.residue_ % prime));
    }
    friend constexpr prime_field operator/(prime_field a, prime_field b) { return a * b.inverse(); }
    friend constexpr bool operator==(prime_field, prime_field) = default;

private:
    static constexpr std::uint64_t reduce(std::uint64_t n) { return n % prime; }
    /// By Euclid's algorithm; the inverse of zero is zero, by which no operator divides.
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
