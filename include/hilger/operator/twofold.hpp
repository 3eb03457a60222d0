// SPDX-License-Identifier: BSL-1.0
// A number as the unevaluated sum of two floats, with twice the digits (Dekker 1971; the operations of Joldes, Muller, Popescu 2017): for
// the few recurrences whose cancellation a result in one float must not show.
#pragma once

#include <cmath>
#include <concepts>

#include "hilger/scalar.hpp"

namespace hilger::detail {

template <std::floating_point S>
class twofold {
public:
    constexpr twofold() = default;
    constexpr explicit(false) twofold(S x) : high_(x) {}
    constexpr explicit(false) twofold(int n) : high_(static_cast<S>(n)) { // an int may have more digits than a float
        low_ = static_cast<S>(n - static_cast<long long>(high_));
    }
    constexpr explicit operator S() const { return high_ + low_; }

    friend constexpr twofold operator+(twofold x, twofold y) {
        twofold s = two_sum(x.high_, y.high_), t = two_sum(x.low_, y.low_);
        s = fast_two_sum(s.high_, s.low_ + t.high_);
        return fast_two_sum(s.high_, s.low_ + t.low_);
    }
    friend constexpr twofold operator-(twofold x) { return {-x.high_, -x.low_}; }
    friend constexpr twofold operator-(twofold x, twofold y) { return x + -y; }
    friend constexpr twofold operator*(twofold x, twofold y) {
        twofold const p = two_product(x.high_, y.high_);
        return fast_two_sum(p.high_, p.low_ + (x.high_ * y.low_ + x.low_ * y.high_));
    }
    friend constexpr twofold operator*(twofold x, S y) {
        twofold const p = two_product(x.high_, y);
        return fast_two_sum(p.high_, p.low_ + x.low_ * y);
    }
    friend constexpr twofold operator/(twofold x, S y) {
        S const q = x.high_ / y;
        twofold const p = two_product(q, y);
        return fast_two_sum(q, (((x.high_ - p.high_) - p.low_) + x.low_) / y);
    }
    friend constexpr twofold operator/(twofold x, twofold y) {
        S const q = x.high_ / y.high_;
        twofold const rest = x - y * q;
        return fast_two_sum(q, (rest.high_ + rest.low_) / y.high_);
    }

private:
    constexpr twofold(S high, S low) : high_(high), low_(low) {}
    static constexpr twofold two_sum(S x, S y) {
        S const s = x + y, part = s - x;
        return {s, (x - (s - part)) + (y - part)};
    }
    /// For |x| >= |y|.
    static constexpr twofold fast_two_sum(S x, S y) {
        S const s = x + y;
        return {s, y - (s - x)};
    }
    /// By splitting (Veltkamp, Dekker): without an instruction for it std::fma is a slow function.
    static constexpr twofold two_product(S x, S y) {
        constexpr int digits = std::numeric_limits<S>::digits;
        constexpr S factor = static_cast<S>((1ULL << ((digits + 1) / 2)) + 1);
        S const p = x * y, a = factor * x, b = factor * y;
        S const x1 = a - (a - x), x2 = x - x1, y1 = b - (b - y), y2 = y - y1;
        return {p, ((x1 * y1 - p) + x1 * y2 + x2 * y1) + x2 * y2};
    }
    S high_{}, low_{};
};

/// Where a recurrence in S runs: twofold for the processor's floats, S itself for numbers that are as wide or exact as asked for.
template <class S>
struct wider {
    using type = S;
};
template <std::floating_point S>
struct wider<S> {
    using type = twofold<S>;
};

} // namespace hilger::detail
