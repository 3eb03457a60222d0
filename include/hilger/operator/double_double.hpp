// SPDX-License-Identifier: BSL-1.0
// A number as the unevaluated sum of two floats, with twice the digits (Dekker 1971; the operations of Joldes, Muller, Popescu 2017): for
// the few recurrences that cancel.
#pragma once

#include <concepts>

#include "hilger/error_free.hpp"

namespace hilger::detail {

template <std::floating_point S>
class double_double {
public:
    constexpr double_double() = default;
    constexpr explicit(false) double_double(S x) : high_(x) {}
    constexpr explicit(false) double_double(int n) : high_(static_cast<S>(n)) { // an int may have more digits than a float
        low_ = static_cast<S>(n - static_cast<long long>(high_));
    }
    constexpr explicit operator S() const { return high_ + low_; }

    friend constexpr double_double operator+(double_double x, double_double y) {
        double_double s = two_sum(x.high_, y.high_), t = two_sum(x.low_, y.low_);
        s = fast_two_sum(s.high_, s.low_ + t.high_);
        return fast_two_sum(s.high_, s.low_ + t.low_);
    }
    friend constexpr double_double operator-(double_double x) { return {-x.high_, -x.low_}; }
    friend constexpr double_double operator-(double_double x, double_double y) { return x + -y; }
    friend constexpr double_double operator*(double_double x, double_double y) {
        double_double const p = two_product(x.high_, y.high_);
        return fast_two_sum(p.high_, p.low_ + (x.high_ * y.low_ + x.low_ * y.high_));
    }
    friend constexpr double_double operator*(double_double x, S y) {
        double_double const p = two_product(x.high_, y);
        return fast_two_sum(p.high_, p.low_ + x.low_ * y);
    }
    friend constexpr double_double operator/(double_double x, S y) {
        S const q = x.high_ / y;
        double_double const p = two_product(q, y);
        return fast_two_sum(q, (((x.high_ - p.high_) - p.low_) + x.low_) / y);
    }
    friend constexpr double_double operator/(double_double x, double_double y) {
        S const q = x.high_ / y.high_;
        double_double const rest = x - y * q;
        return fast_two_sum(q, (rest.high_ + rest.low_) / y.high_);
    }

private:
    constexpr double_double(S high, S low) : high_(high), low_(low) {}
    static constexpr double_double two_sum(S x, S y) {
        detail::two_sum(x, y, x, y);
        return {x, y};
    }
    static constexpr double_double fast_two_sum(S x, S y) {
        detail::fast_two_sum(x, y, x, y);
        return {x, y};
    }
    static constexpr double_double two_product(S x, S y) {
        detail::two_product(x, y, x, y);
        return {x, y};
    }
    S high_{}, low_{};
};

/// The numbers of a recurrence for S: double_double for the processor's floats, S itself for wide or exact numbers.
template <class S>
struct wider {
    using type = S;
};
template <std::floating_point S>
struct wider<S> {
    using type = double_double<S>;
};

} // namespace hilger::detail
