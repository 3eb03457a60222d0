// SPDX-License-Identifier: BSL-1.0
// A double that counts: what a step made of such numbers computes and keeps is known exactly, whatever method makes it. Every operation is
// written down; counted are those on which the numbers that are asked for, or a branch that was taken, depend, and those that are made
// twice from the same operands once. That is what is left of a formula once an optimiser has seen it, so that a derivative which nobody
// reads costs nothing here either. Constants are folded, as far as IEEE rules allow; signs and absolute values are free.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>
#include <ostream>

#include <Eigen/Core>

#include "hilger/history/modes.hpp"
#include "hilger/simd.hpp"
#include "support/operation_record.hpp"

namespace hilger::testing {

/// A double whose operations are counted, on the thread that makes them.
class counted {
    using kind = operation_kind;

public:
    counted() noexcept : counted(0.0, 0) {}
    template <class C>
        requires std::is_arithmetic_v<C>
    explicit(false) counted(C constant) noexcept : counted(static_cast<double>(constant), 0) {}
    counted(counted const& x) noexcept : counted(x.value_, x.made_) {}
    counted& operator=(counted const&) noexcept = default;
    ~counted() { ends(); }

    /// A number that no compiler knows: an initial value, a step.
    static counted variable(double x) { return {x, record().variable()}; }
    [[nodiscard]] double value() const { return value_; }
    [[nodiscard]] bool is_constant() const { return made_ == 0; }
    /// Says that what made this number was needed.
    void need() const { record().need(made_); }
    template <class C>
        requires std::is_arithmetic_v<C>
    explicit operator C() const { return static_cast<C>(value_); }

    friend counted operator+(counted const& x, counted const& y) noexcept { return made(kind::plus, x.value_ + y.value_, x, y); }
    friend counted operator-(counted const& x, counted const& y) noexcept {
        return y.is_constant(0) ? x : made(kind::minus, x.value_ - y.value_, x, y);
    }
    friend counted operator*(counted const& x, counted const& y) noexcept {
        if (x.is_constant(1) or x.is_constant(-1)) return x.value_ < 0 ? -y : y;
        if (y.is_constant(1) or y.is_constant(-1)) return y.value_ < 0 ? -x : x;
        return made(kind::times, x.value_ * y.value_, x, y);
    }
    friend counted operator/(counted const& x, counted const& y) noexcept {
        return y.is_constant(1) ? x : made(kind::over, x.value_ / y.value_, x, y);
    }
    friend counted operator-(counted const& x) noexcept { return made(kind::sign, -x.value_, x, counted(), 0); }
    friend counted operator+(counted const& x) noexcept { return x; }
    counted& operator+=(counted const& y) noexcept { return *this = *this + y; }
    counted& operator-=(counted const& y) noexcept { return *this = *this - y; }
    counted& operator*=(counted const& y) noexcept { return *this = *this * y; }
    counted& operator/=(counted const& y) noexcept { return *this = *this / y; }
    /// Which way a branch goes needs both.
    friend bool operator==(counted const& x, counted const& y) {
        x.need(), y.need();
        return x.value_ == y.value_;
    }
    friend std::partial_ordering operator<=>(counted const& x, counted const& y) {
        x.need(), y.need();
        return x.value_ <=> y.value_;
    }
    friend std::ostream& operator<<(std::ostream& out, counted const& x) { return out << x.value_; }

    friend counted abs(counted const& x) noexcept { return made(kind::sign, std::abs(x.value_), x, counted(), 1); }
    friend bool isfinite(counted const& x) { return x.need(), std::isfinite(x.value_); }
    friend bool isnan(counted const& x) { return x.need(), std::isnan(x.value_); }
    friend bool isinf(counted const& x) { return x.need(), std::isinf(x.value_); }
    friend counted sqrt(counted const& x) noexcept { return function(2, std::sqrt(x.value_), x); }
    friend counted exp(counted const& x) noexcept { return function(3, std::exp(x.value_), x); }
    friend counted log(counted const& x) noexcept { return function(4, std::log(x.value_), x); }
    friend counted sin(counted const& x) noexcept { return function(sine_name, std::sin(x.value_), x); }
    friend counted cos(counted const& x) noexcept { return function(cosine_name, std::cos(x.value_), x); }
    friend counted tan(counted const& x) noexcept { return function(5, std::tan(x.value_), x); }
    friend counted sinh(counted const& x) noexcept { return function(6, std::sinh(x.value_), x); }
    friend counted cosh(counted const& x) noexcept { return function(7, std::cosh(x.value_), x); }
    friend counted tanh(counted const& x) noexcept { return function(8, std::tanh(x.value_), x); }
    friend counted asin(counted const& x) noexcept { return function(9, std::asin(x.value_), x); }
    friend counted acos(counted const& x) noexcept { return function(10, std::acos(x.value_), x); }
    friend counted atan(counted const& x) noexcept { return function(11, std::atan(x.value_), x); }
    friend counted floor(counted const& x) noexcept { return function(12, std::floor(x.value_), x); }
    friend counted atan2(counted const& y, counted const& x) noexcept { return function(13, std::atan2(y.value_, x.value_), y, x); }
    friend counted hypot(counted const& x, counted const& y) noexcept { return function(14, std::hypot(x.value_, y.value_), x, y); }
    friend counted erf(counted const& x) noexcept { return function(16, std::erf(x.value_), x); }
    friend counted log1p(counted const& x) noexcept { return function(17, std::log1p(x.value_), x); }
    friend counted expm1(counted const& x) noexcept { return function(18, std::expm1(x.value_), x); }
    friend counted cbrt(counted const& x) noexcept { return function(19, std::cbrt(x.value_), x); }
    friend counted asinh(counted const& x) noexcept { return function(20, std::asinh(x.value_), x); }
    friend counted acosh(counted const& x) noexcept { return function(21, std::acosh(x.value_), x); }
    friend counted atanh(counted const& x) noexcept { return function(22, std::atanh(x.value_), x); }
    friend counted copysign(counted const& x, counted const& y) noexcept {
        return made(kind::sign, std::copysign(x.value_, y.value_), x, y, 2);
    }
    friend counted max(counted const& x, counted const& y) { return x < y ? y : x; }
    friend counted min(counted const& x, counted const& y) { return y < x ? y : x; }
    friend counted fmax(counted const& x, counted const& y) { return max(x, y); }
    friend counted fmin(counted const& x, counted const& y) { return min(x, y); }
    friend counted pow(counted const& x, counted const& y) noexcept { return function(15, std::pow(x.value_, y.value_), x, y); }

private:
    [[nodiscard]] bool is_constant(double x) const { return made_ == 0 and value_ == x; }
    static record_of_operations& record() { return record_of_operations::of_this_thread(); }
    counted(double x, std::int64_t by) noexcept : value_(x), made_(by) { begins(); }
    // Out of the way of a compiler that inlines all arithmetic.
    [[gnu::noinline]] static void begins() noexcept { ++record().numbers; }
    [[gnu::noinline]] static void ends() noexcept { --record().numbers; }
    [[gnu::noinline]] static counted made(kind what, double result, counted const& x, counted const& y, std::uint32_t name = 0) noexcept {
        return {result, record().made(what, name, x.made_, x.value_, y.made_, y.value_)};
    }
    static counted function(std::uint32_t name, double result, counted const& x, counted const& y = {}) noexcept {
        return made(kind::function, result, x, y, name);
    }
    double value_;
    std::int64_t made_;
};

} // namespace hilger::testing

namespace hilger::detail::memory {
/// A history of counted numbers has the terms that one of doubles has.
template <>
struct modes_in<testing::counted> {
    using type = double;
};
template <>
inline constexpr std::size_t padding<testing::counted> = padding<double>;
} // namespace hilger::detail::memory

template <>
struct std::numeric_limits<hilger::testing::counted> : std::numeric_limits<double> {};
template <class Operation>
struct Eigen::ScalarBinaryOpTraits<hilger::testing::counted, double, Operation> {
    using ReturnType = hilger::testing::counted;
};
template <class Operation>
struct Eigen::ScalarBinaryOpTraits<double, hilger::testing::counted, Operation> {
    using ReturnType = hilger::testing::counted;
};
