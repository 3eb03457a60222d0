// SPDX-License-Identifier: BSL-1.0
// A double that counts: what a step made of such numbers computes and keeps is known exactly, whatever method makes it. Every operation is
// written down; counted are those on which the numbers that are asked for, or a branch that was taken, depend, and those that are made twice
// from the same operands once. That is what is left of a formula once an optimiser has seen it, so that a derivative which nobody reads
// costs nothing here either. Constants are folded, as far as IEEE rules allow; signs and absolute values are free.
#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <ostream>
#include <unordered_map>
#include <vector>

#include <Eigen/Core>

#include "hilger/history/modes.hpp"
#include "hilger/scalar.hpp"

namespace hilger {

/// What happened while a record was kept.
struct counts {
    long long arithmetic = 0; ///< + - * /
    long long functions = 0;  ///< sqrt, sin, ...
    long long second_derivatives = 0;
    std::array<long long, 4> of_work{};
    long long& of(detail::work what) { return of_work[static_cast<std::size_t>(what)]; }
};

namespace detail {

enum class operation_kind : std::uint8_t { plus, minus, times, over, sign, function };

/// The operations of one thread. A number is known by what made it: 0 is a constant, others count up, and those from before the record
/// began are its variables.
class record_of_operations {
    struct operation {
        std::int64_t a, b;
        std::uint32_t name; // which function
        operation_kind kind;
        friend bool operator==(operation const&, operation const&) = default;
    };
    struct hash {
        std::size_t operator()(operation const& o) const {
            auto const mixed = static_cast<std::uint64_t>(o.a) * 0x9e3779b97f4a7c15U ^ static_cast<std::uint64_t>(o.b);
            return static_cast<std::size_t>((mixed ^ o.name << 3U ^ static_cast<std::uint64_t>(o.kind)) * 0xbf58476d1ce4e5b9U >> 16U);
        }
    };

public:
    static record_of_operations& of_this_thread() {
        static thread_local record_of_operations record;
        return record;
    }
    long long numbers = 0; ///< how many there are at this moment

    std::int64_t variable() { return ++last_; }
    /// The result of an operation; operands that are constants stand for their values.
    std::int64_t made(operation_kind kind, std::uint32_t name, std::int64_t a, double x, std::int64_t b, double y) {
        if (a == 0 and b == 0) return 0;
        if (not recording_) return ++last_;
        operation o{operand(a, x), operand(b, y), name, kind};
        if ((kind == operation_kind::plus or kind == operation_kind::times) and o.b < o.a) std::swap(o.a, o.b);
        auto const [known, is_new] = this_step_.try_emplace(o, last_ + 1);
        if (not is_new) return known->second;
        operations_.push_back(o);
        return ++last_;
    }
    void add(work what) {
        if (counting_) ++counts_.of(what);
    }
    void use_second(std::int64_t a) {
        if (counting_ and a > first_) seconds_.push_back(a);
    }
    void need(std::int64_t a) {
        if (recording_ and a > first_) needed_.push_back(a);
    }
    void begin() {
        *this = record_of_operations(numbers, last_);
        recording_ = counting_ = true;
    }
    /// Operations are found again within a step only.
    void next_step() { this_step_.clear(); }
    /// From here on only what becomes of the numbers is of interest.
    void stop_counting() {
        counting_ = false;
        counted_until_ = last_;
    }
    /// What was counted and is needed.
    counts end();

private:
    record_of_operations() = default;
    record_of_operations(long long alive, std::int64_t last) : numbers(alive), first_(last), last_(last) {}
    std::int64_t operand(std::int64_t a, double x) {
        return a != 0 ? a : constants_.try_emplace(x == 0 ? 0.0 : x, -1 - static_cast<std::int64_t>(constants_.size())).first->second;
    }
    bool recording_ = false, counting_ = false;
    std::int64_t first_ = 0, last_ = 0, counted_until_ = 0;
    std::vector<operation> operations_; // number first_ + 1, ...
    std::unordered_map<operation, std::int64_t, hash> this_step_;
    std::unordered_map<double, std::int64_t> constants_;
    std::vector<std::int64_t> needed_, seconds_;
    counts counts_;
};

inline counts record_of_operations::end() {
    std::vector<bool> alive(operations_.size());
    auto const at = [&](std::int64_t a) { return static_cast<std::size_t>(a - first_ - 1); };
    for (std::int64_t const a : needed_) alive[at(a)] = true;
    for (std::size_t i = operations_.size(); i-- > 0;) {
        if (not alive[i]) continue;
        operation const& o = operations_[i];
        if (o.a > first_) alive[at(o.a)] = true;
        if (o.b > first_) alive[at(o.b)] = true;
        if (first_ + 1 + static_cast<std::int64_t>(i) > counted_until_ or o.kind == operation_kind::sign) continue;
        ++(o.kind == operation_kind::function ? counts_.functions : counts_.arithmetic);
    }
    std::vector<bool> seen(operations_.size());
    for (std::int64_t a : seconds_) {
        while (a > first_ and operations_[at(a)].kind == operation_kind::sign) a = operations_[at(a)].a;
        if (a <= first_ or not alive[at(a)] or seen[at(a)]) continue;
        seen[at(a)] = true;
        ++counts_.second_derivatives;
    }
    counts const result = counts_;
    *this = record_of_operations(numbers, last_);
    return result;
}

} // namespace detail

/// A double whose operations are counted, on the thread that makes them.
class counted {
    using kind = detail::operation_kind;

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
    void use_second() const { record().use_second(made_); }
    template <class C>
        requires std::is_arithmetic_v<C>
    explicit operator C() const {
        return static_cast<C>(value_);
    }

    friend counted operator+(counted const& x, counted const& y) noexcept { return made(kind::plus, x.value_ + y.value_, x, y); }
    friend counted operator-(counted const& x, counted const& y) noexcept {
        return y.is_constant(0) ? x : made(kind::minus, x.value_ - y.value_, x, y);
    }
    friend counted operator*(counted const& x, counted const& y) noexcept {
        return y.is_constant(1) ? x : x.is_constant(1) ? y : made(kind::times, x.value_ * y.value_, x, y);
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
    friend counted sqrt(counted const& x) noexcept { return function(0, std::sqrt(x.value_), x); }
    friend counted exp(counted const& x) noexcept { return function(1, std::exp(x.value_), x); }
    friend counted log(counted const& x) noexcept { return function(2, std::log(x.value_), x); }
    friend counted sin(counted const& x) noexcept { return function(3, std::sin(x.value_), x); }
    friend counted cos(counted const& x) noexcept { return function(4, std::cos(x.value_), x); }
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
    friend counted pow(counted const& x, counted const& y) noexcept { return function(15, std::pow(x.value_, y.value_), x, y); }

private:
    [[nodiscard]] bool is_constant(double x) const { return made_ == 0 and value_ == x; }
    static detail::record_of_operations& record() { return detail::record_of_operations::of_this_thread(); }
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

namespace detail {

template <>
struct tally<counted> {
    static void add(work what) { record_of_operations::of_this_thread().add(what); }
    static counted const& second(counted const& x) {
        x.use_second();
        return x;
    }
    /// A matrix of constants is none: what is left of the system is a product with numbers that are known.
    template <class Matrix>
    static void small_solve(Matrix const& K) {
        for (counted const& x : K)
            if (not x.is_constant()) {
                add(work::factorization);
                add(work::solve);
                return;
            }
    }
};

namespace memory {
/// A history of counted numbers has the terms that one of doubles has.
template <>
struct modes_in<counted> {
    using type = double;
};
template <>
inline constexpr std::size_t padding<counted> = padding<double>;
} // namespace memory
} // namespace detail
} // namespace hilger

template <>
struct std::numeric_limits<hilger::counted> : std::numeric_limits<double> {};
template <class Operation>
struct Eigen::ScalarBinaryOpTraits<hilger::counted, double, Operation> {
    using ReturnType = hilger::counted;
};
template <class Operation>
struct Eigen::ScalarBinaryOpTraits<double, hilger::counted, Operation> {
    using ReturnType = hilger::counted;
};
