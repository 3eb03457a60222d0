// SPDX-License-Identifier: BSL-1.0
// A number that records the formula it is computed by. A Lagrangian that runs on numbers and on jets runs on symbols, and is then known as
// a formula: its derivatives can be written out (formula/derivative.hpp, formula/print.hpp) and compiled elsewhere
// (formula/c_code.hpp).
//   symbol const x = symbol::variable("q");
//   std::cout << partial(cos(x), x);          −sin(q)
//
// What is written is lightly simplified: constants are folded, 0 + x, 1 x, 0 x and double signs disappear, constant factors go to the
// front, x x^2 / x is x^2. Values change by rounding at most, except where a formula is undefined: x / x is 1 at 0 too.
#pragma once

#include <compare>
#include <concepts>
#include <optional>
#include <utility>

#include "hilger/error.hpp"
#include "hilger/formula/nodes.hpp"

namespace hilger {

class symbol {
public:
    symbol() : symbol(0.0) {}
    /// A constant, as the double nearest to it. @throws error::no_formula when that, or a constant folded from it, is not finite
    template <class C>
        requires(std::constructible_from<double, C const&> and not std::same_as<C, symbol>)
    explicit(false) symbol(C const& constant) : node_(constant_node(static_cast<double>(constant))) {}

    static symbol variable(std::string name, int component = -1) {
        return symbol(node({operation::variable, 0, std::move(name), component, nullptr, nullptr}));
    }

    [[nodiscard]] formula const& get() const { return *node_; }
    [[nodiscard]] operation op() const { return node_->op; }
    [[nodiscard]] bool is_number() const { return op() == operation::number; }
    [[nodiscard]] bool is(double x) const { return is_number() and node_->value == x; }
    [[nodiscard]] double value() const { return node_->value; }
    /// The operands; `second` of the operations that have two.
    [[nodiscard]] symbol first() const { return symbol(node_->a); }
    [[nodiscard]] symbol second() const { return symbol(node_->b); }
    /// One formula: the same node. Two formulas may be equal as functions and not be the same.
    [[nodiscard]] bool same_as(symbol const& y) const { return node_ == y.node_; }

    friend symbol operator-(symbol const& x) {
        if (x.is_number()) return -x.value();
        if (x.op() == operation::negative) return x.first();
        if (x.op() == operation::minus) return x.second() - x.first();
        return make(operation::negative, x);
    }
    friend symbol operator+(symbol const& x, symbol const& y) {
        if (auto const folded = fold(x, y, [](double a, double b) { return a + b; })) return *folded;
        if (x.is(0)) return y;
        if (y.is(0)) return x;
        if (y.op() == operation::negative) return x - y.first();
        if (x.op() == operation::negative) return y - x.first();
        if (y.is_number() and y.value() < 0) return x - (-y);
        auto const [c, z] = factor(x);
        auto const [d, w] = factor(y);
        if (z.same_as(w)) return symbol(c + d) * z;
        if (x.shares_denominator(y)) return x.with_numerator(x.first() + y.first());
        if (x.has_factor() and y.has_factor() and c == d) return symbol(c) * (z + w);
        return make(operation::plus, x, y);
    }
    friend symbol operator-(symbol const& x, symbol const& y) {
        if (auto const folded = fold(x, y, [](double a, double b) { return a - b; })) return *folded;
        if (x.is(0)) return -y;
        if (y.is(0)) return x;
        if (y.op() == operation::negative) return x + y.first();
        if (x.op() == operation::negative) return -(x.first() + y);
        if (y.is_number() and y.value() < 0) return x + (-y);
        auto const [c, z] = factor(x);
        auto const [d, w] = factor(y);
        if (z.same_as(w)) return symbol(c - d) * z;
        if (x.shares_denominator(y)) return x.with_numerator(x.first() - y.first());
        if (x.has_factor() and y.has_factor() and c == d) return symbol(c) * (z - w);
        return make(operation::minus, x, y);
    }
    friend symbol operator*(symbol const& x, symbol const& y) {
        if (auto const folded = fold(x, y, [](double a, double b) { return a * b; })) return *folded;
        if (y.is_number() and not x.is_number()) return y * x;
        if (x.is(0)) return x;
        if (x.is(1)) return y;
        if (x.is_number() and x.value() < 0) return -(-x * y);
        if (x.op() == operation::negative) return -(x.first() * y);
        if (y.op() == operation::negative) return -(x * y.first());
        if (x.op() == operation::over) return x.first() * y / x.second();
        if (y.op() == operation::over) return x * y.first() / y.second();
        if (x.op() == operation::over_norm and y.op() != operation::over_norm) return y * x;
        if (y.op() == operation::over_norm and not x.is_number()) {
            if (common(x, y.second())) return x / y.second() * y.first();
            return over_norm(x * y.first(), y.second());
        }
        if (y.has_factor()) return (x.is_number() ? symbol(x.value() * y.first().value()) : y.first()) * made_product(x, y);
        if (x.has_factor()) return x.first() * (x.second() * y);
        if (auto const c = common(x, y)) return pow(symbol(c->base), c->m + c->n);
        if (y.op() == operation::times and common(x, y.first())) return x * y.first() * y.second();
        if (x.op() == operation::times and common(x.second(), y)) return x.first() * (x.second() * y);
        return make(operation::times, x, y);
    }
    friend symbol operator/(symbol const& x, symbol const& y) {
        if (auto const folded = fold(x, y, [](double a, double b) { return a / b; })) return *folded;
        if (y.is(0)) return make(operation::over, x, y);
        if (x.is(0) or y.is(1)) return x;
        if (x.same_as(y)) return 1;
        if (y.is_number() and y.value() < 0) return -(x / -y);
        if (x.is_number() and x.value() < 0) return -(-x / y);
        if (x.op() == operation::negative) return -(x.first() / y);
        if (y.op() == operation::negative) return -(x / y.first());
        if (y.op() == operation::over) return x * y.second() / y.first();
        if (x.op() == operation::over) return x.first() / (x.second() * y);
        if (auto const [c, z] = factor(x); z.op() == operation::over_norm and common(z.second(), y))
            return symbol(c) * z.first() / (z.second() * y);
        if (y.is_number() and x.has_factor()) return symbol(x.first().value() / y.value()) * x.second();
        if (y.has_factor() and (x.is_number() or x.has_factor())) {
            auto const [c, z] = factor(x);
            return symbol(c / y.first().value()) * z / y.second();
        }
        if (auto const c = common(x, y)) return c->m < c->n ? 1 / pow(symbol(c->base), c->n - c->m) : pow(symbol(c->base), c->m - c->n);
        if (x.op() == operation::times) {
            if (common(x.second(), y)) return x.first() * (x.second() / y);
            if (common(x.first(), y)) return x.first() / y * x.second();
        }
        return make(operation::over, x, y);
    }
    friend symbol pow(symbol const& x, symbol const& y) {
        if (not y.is_number()) return call(operation::exp, y * call(operation::log, x));
        if (auto const folded = fold(x, y, [](double a, double b) { return std::pow(a, b); })) return *folded;
        double const n = y.value();
        bool const whole = n == std::floor(n), even = n == 2 * std::floor(n / 2);
        if (n == 0) return 1;
        if (n == 1) return x;
        if (n == 0.5) return call(operation::sqrt, x);
        if (n < 0) return symbol(1) / pow(x, -n);
        if (even and x.op() == operation::sqrt) return pow(x.first(), n / 2);
        if (whole and x.op() == operation::negative) return even ? pow(x.first(), y) : -pow(x.first(), y);
        if (whole and x.op() == operation::power and x.value() == std::floor(x.value())) return pow(x.first(), x.value() * n);
        return symbol(node({operation::power, n, {}, 0, x.node_, nullptr}));
    }
    /// x / y, where a derivative is divided by a norm (operation::over_norm).
    static symbol over_norm(symbol const& x, symbol const& y) {
        if (x.is(0)) return x;
        if (x.op() == operation::negative) return -over_norm(x.first(), y);
        if (x.has_factor()) return x.first() * over_norm(x.second(), y);
        bool const is_multiple = x.op() == operation::times and (common(x.first(), y) or common(x.second(), y));
        return is_multiple or common(x, y) ? x / y : call(operation::over_norm, x, y);
    }
    /// x as z^n, n a whole number.
    friend std::pair<symbol, double> whole_power(symbol const& x) {
        if (x.op() == operation::power and x.value() == std::floor(x.value())) return {x.first(), x.value()};
        return {x, 1};
    }
    /// An elementary function.
    static symbol call(operation op, symbol const& x) {
        if (x.is_number())
            if (double const y = detail::call(op, x.value()); std::isfinite(y)) return y;
        return make(op, x);
    }
    static symbol call(operation op, symbol const& x, symbol const& y) {
        auto const folded = fold(x, y, [op](double a, double b) { return detail::call(op, a, b); });
        return folded ? *folded : make(op, x, y);
    }

    // Friends, found for symbols only: numbers, which become symbols by themselves, have theirs.
    friend symbol max(symbol const& x, symbol const& y) { return x.same_as(y) ? x : call(operation::maximum, x, y); }
    friend symbol min(symbol const& x, symbol const& y) { return x.same_as(y) ? x : call(operation::minimum, x, y); }
    friend symbol fmax(symbol const& x, symbol const& y) { return max(x, y); }
    friend symbol fmin(symbol const& x, symbol const& y) { return min(x, y); }
    friend symbol copysign(symbol const& x, symbol const& y) { return call(operation::abs, x) * call(operation::sign, y); }

    symbol& operator+=(symbol const& y) { return *this = *this + y; }
    symbol& operator-=(symbol const& y) { return *this = *this - y; }
    symbol& operator*=(symbol const& y) { return *this = *this * y; }
    symbol& operator/=(symbol const& y) { return *this = *this / y; }

    /// Which branch to take is known between constants only. @throws error::no_formula
    friend bool operator==(symbol const& x, symbol const& y) { return x.same_as(y) or compared(x, y) == 0; }
    friend std::partial_ordering operator<=>(symbol const& x, symbol const& y) {
        return x.same_as(y) ? std::partial_ordering::equivalent : compared(x, y);
    }

private:
    explicit symbol(formula::pointer node) : node_(std::move(node)) {}
    static formula::pointer node(formula f) { return detail::formula_table::of_this_thread().node(std::move(f)); }
    static formula::pointer constant_node(double x) {
        if (not std::isfinite(x)) error::raise<error::no_formula>("the constants of a formula are finite doubles, and this one is ", x);
        return node({operation::number, x == 0 ? 0.0 : x, {}, 0, nullptr, nullptr}); // no -0
    }
    static symbol make(operation op, symbol const& x) { return symbol(node({op, 0, {}, 0, x.node_, nullptr})); }
    static symbol make(operation op, symbol const& x, symbol const& y) { return symbol(node({op, 0, {}, 0, x.node_, y.node_})); }
    static symbol made_product(symbol const& x, symbol const& y) { return x.is_number() ? y.second() : x * y.second(); }
    template <class Operation>
    static std::optional<symbol> fold(symbol const& x, symbol const& y, Operation const& of) {
        if (not x.is_number() or not y.is_number()) return {};
        double const z = of(x.value(), y.value());
        return std::isfinite(z) ? std::optional<symbol>(z) : std::nullopt;
    }
    static std::partial_ordering compared(symbol const& x, symbol const& y) {
        if (not x.is_number() or not y.is_number())
            error::raise<error::no_formula>(
                "what compares its arguments, by if or otherwise, is not one formula, nor is what iterates, as the "
                "Legendre transform of a Hamiltonian does: constants can be compared, and min, max and abs are formulas");
        return x.value() <=> y.value();
    }
    /// c z with a number c before a z that is none.
    [[nodiscard]] bool has_factor() const { return op() == operation::times and node_->a->op == operation::number; }
    [[nodiscard]] bool shares_denominator(symbol const& y) const {
        return (op() == operation::over or op() == operation::over_norm) and y.op() == op() and second().same_as(y.second());
    }
    [[nodiscard]] symbol with_numerator(symbol const& x) const { return op() == operation::over ? x / second() : over_norm(x, second()); }
    static std::pair<double, symbol> factor(symbol const& x) {
        if (x.is_number()) return {x.value(), 1};
        if (x.has_factor()) return {x.first().value(), x.second()};
        if (x.op() == operation::over and x.second().is_number() and not x.second().is(0)) return {1 / x.second().value(), x.first()};
        return {1, x};
    }
    /// x = base^m and y = base^n with whole m and n, where there is such a base.
    struct powers {
        formula::pointer base;
        double m, n;
    };
    static std::optional<powers> common(symbol const& x, symbol const& y) {
        auto const [z, m] = whole_power(x);
        auto const [w, n] = whole_power(y);
        if (z.same_as(w)) return powers{z.node_, m, n};
        if (z.op() == operation::sqrt and z.first().same_as(w)) return powers{z.node_, m, 2 * n};
        if (w.op() == operation::sqrt and w.first().same_as(z)) return powers{w.node_, 2 * m, n};
        return {};
    }
    formula::pointer node_;
};

} // namespace hilger
