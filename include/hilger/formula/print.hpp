// SPDX-License-Identifier: BSL-1.0
// Formulas written out, for a terminal and in LaTeX; other languages give a formula_writer their own spelling.
//   std::cout << f << latex(f);
#pragma once

#include <algorithm>
#include <ostream>
#include <string>
#include <string_view>

#include "hilger/error.hpp"
#include "hilger/formula/symbol.hpp"
#include "hilger/printing/expression.hpp"

namespace hilger {

/// The name of an elementary function as C, C++ and most languages have it.
inline char const* name_of(operation op) {
    switch (op) {
    case operation::atan2:
        return "atan2";
    case operation::sin:
        return "sin";
    case operation::cos:
        return "cos";
    case operation::tan:
        return "tan";
    case operation::exp:
        return "exp";
    case operation::log:
        return "log";
    case operation::sqrt:
        return "sqrt";
    case operation::sinh:
        return "sinh";
    case operation::cosh:
        return "cosh";
    case operation::tanh:
        return "tanh";
    case operation::asin:
        return "asin";
    case operation::acos:
        return "acos";
    case operation::atan:
        return "atan";
    case operation::asinh:
        return "asinh";
    case operation::acosh:
        return "acosh";
    case operation::atanh:
        return "atanh";
    case operation::maximum:
        return "max";
    case operation::minimum:
        return "min";
    case operation::cbrt:
        return "cbrt";
    case operation::expm1:
        return "expm1";
    case operation::log1p:
        return "log1p";
    case operation::erf:
        return "erf";
    case operation::abs:
        return "abs";
    case operation::sign:
        return "sign";
    default:
        return "";
    }
}

/// Text, and how firmly it holds together: what stands in a tighter place is put into parentheses.
struct written {
    enum binding { sum, product, factor, atom };
    std::string text;
    binding tie = atom;
    [[nodiscard]] std::string in(binding place) const { return tie < place ? "(" + text + ")" : text; }
};

/// Spelling says how numbers, variables, products, quotients, powers and functions are spelt, and may write a node in its own way.
template <class Spelling>
struct formula_writer {
    Spelling const& spelling;

    [[nodiscard]] written operator()(symbol const& f) const {
        if (std::optional<written> const own = spelling.own(f)) return *own;
        return spelled_out(f);
    }
    /// f itself is written by its operation whatever the spelling says.
    [[nodiscard]] written spelled_out(symbol const& f) const {
        auto const& write = *this;
        switch (f.op()) {
        case operation::number:
            return {spelling.number(f.value()), f.value() < 0 ? written::sum : written::atom};
        case operation::variable:
            return {spelling.variable(f.get()), written::atom};
        case operation::plus:
            return {write(f.first()).in(written::sum) + " + " + right_of_sum(f.second()), written::sum};
        case operation::minus:
            return {write(f.first()).in(written::sum) + " " + spelling.minus() + " " + write(f.second()).in(written::product),
                    written::sum};
        case operation::negative:
            return {spelling.minus() + write(f.first()).in(written::product), written::sum};
        case operation::times:
            return spelling.product(write(f.first()), write(f.second()));
        case operation::over:
            return spelling.quotient(write(f.first()), write(f.second()));
        case operation::over_norm:
            if constexpr (requires(written const& x) { spelling.over_norm(x, x); })
                return spelling.over_norm(write(f.first()), write(f.second()));
            else
                return spelling.quotient(write(f.first()), write(f.second()));
        case operation::power:
            return spelling.power(write(f.first()), f.value());
        case operation::where:
        case operation::elsewhere:
            return spelling.where(f.op() == operation::where, write(f.first()), write(f.second()));
        case operation::atan2:
        case operation::maximum:
        case operation::minimum:
            return spelling.call(f.op(), write(f.first()).text + ", " + write(f.second()).text);
        default:
            return spelling.call(f.op(), write(f.first()).text);
        }
    }

private:
    /// a + (b + c) and a + (b - c) are added up in another order than a + b + c.
    [[nodiscard]] std::string right_of_sum(symbol const& f) const { return (*this)(f).in(written::product); }
};

namespace detail {

struct terminal_spelling {
    static std::optional<written> own(symbol const&) { return {}; }
    static std::string minus() { return "−"; }
    static std::string number(double x) { return x < 0 ? "−" + round_trip(-x) : round_trip(x); }
    static std::string variable(formula const& f) { return f.component < 0 ? f.name : f.name + subscript(f.component); }
    static written product(written const& a, written const& b) {
        return {a.in(written::product) + "·" + b.in(written::factor), written::product};
    }
    static written quotient(written const& a, written const& b) {
        return {a.in(written::product) + "/" + b.in(written::factor), written::product};
    }
    /// In Iverson's brackets.
    static written where(bool not_negative, written const& c, written const& x) {
        return product({"[" + c.text + (not_negative ? " ≥ 0]" : " < 0]")}, x);
    }
    static written power(written const& a, double n) {
        std::string const raised = n == 2 ? "²" : n == 3 ? "³" : n == 4 ? "⁴" : "^" + round_trip(n);
        return {a.in(written::atom) + raised, written::factor};
    }
    static written call(operation op, std::string const& arguments) {
        if (op == operation::abs) return {"|" + arguments + "|"};
        return {op == operation::sqrt ? "√(" + arguments + ")" : name_of(op) + ("(" + arguments + ")")};
    }
};

/// A name, and the number of its component where that is not negative: omega_dot, q_1 and theta as they are meant, other words upright.
inline std::string latex_name(std::string const& name, int component) {
    constexpr std::string_view greek =
        " alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi "
        "chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega ";
    auto const is_word = [](char c) { return (c >= 'a' and c <= 'z') or (c >= 'A' and c <= 'Z') or (c >= '0' and c <= '9') or c == '_'; };
    std::string const number = component < 0 ? "" : std::to_string(component);
    if (name.size() < 2 or not std::all_of(name.begin(), name.end(), is_word)) // or somebody's own LaTeX
        return number.empty() ? name : name + "_{" + number + "}";
    auto const upright = [&](std::string const& word) {
        if (word.size() == 1 or word.find_first_not_of("0123456789") == std::string::npos) return word;
        if (greek.find(" " + word + " ") != std::string_view::npos) return "\\" + word;
        std::string text = "\\mathrm{";
        for (char const c : word) text += c == '_' ? std::string("\\_") : std::string(1, c);
        return text + "}";
    };
    auto const bar = name.find('_');
    bool const has_index = bar != std::string::npos and bar > 0 and bar + 1 < name.size();
    std::string const index = has_index ? upright(name.substr(bar + 1)) + (number.empty() ? "" : ",") + number : number;
    return upright(has_index ? name.substr(0, bar) : name) + (index.empty() ? "" : "_{" + index + "}");
}

struct latex_spelling {
    static std::optional<written> own(symbol const&) { return {}; }
    static std::string minus() { return "-"; }
    static std::string number(double x) {
        std::string const digits = round_trip(x);
        auto const e = digits.find('e');
        if (e == std::string::npos) return digits;
        return "{" + digits.substr(0, e) + " \\cdot 10^{" + std::to_string(std::stoi(digits.substr(e + 1))) + "}}";
    }
    static std::string variable(formula const& f) { return latex_name(f.name, f.component); }
    static written product(written const& a, written const& b) {
        return {a.in(written::product) + " \\, " + b.in(written::product), written::product};
    }
    static written quotient(written const& a, written const& b) { return {"\\frac{" + a.text + "}{" + b.text + "}", written::product}; }
    static written where(bool not_negative, written const& c, written const& x) {
        return product({"[" + c.text + (not_negative ? " \\ge 0]" : " < 0]")}, x);
    }
    static written power(written const& a, double n) { return {"{" + a.in(written::atom) + "}^{" + round_trip(n) + "}", written::factor}; }
    static written call(operation op, std::string const& arguments) {
        if (op == operation::abs) return {"\\left|" + arguments + "\\right|"};
        if (op == operation::sqrt) return {"\\sqrt{" + arguments + "}"};
        if (op == operation::cbrt) return {"\\sqrt[3]{" + arguments + "}"};
        return {name(op) + "(" + arguments + ")"};
    }

private:
    static std::string name(operation op) {
        switch (op) {
        case operation::asin:
            return "\\arcsin";
        case operation::acos:
            return "\\arccos";
        case operation::atan:
            return "\\arctan";
        case operation::asinh: // what LaTeX has no name for
        case operation::acosh:
        case operation::atanh:
        case operation::sign:
        case operation::atan2:
        case operation::expm1:
        case operation::log1p:
        case operation::erf:
            return "\\operatorname{" + std::string(name_of(op)) + "}";
        default:
            return std::string("\\") + name_of(op);
        }
    }
};

} // namespace detail

inline std::ostream& operator<<(std::ostream& out, symbol const& f) { return out << formula_writer<detail::terminal_spelling>{{}}(f).text; }
inline std::string latex(symbol const& f) { return formula_writer<detail::latex_spelling>{{}}(f).text; }

} // namespace hilger
