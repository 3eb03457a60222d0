// SPDX-License-Identifier: BSL-1.0
// Formulas as statements of C99: one assignment a line, what several of them share computed once under a name. A variable of a formula is
// spelt in C as it is named: "h", "q[0]".
#pragma once

#include <map>
#include <set>
#include <vector>

#include "hilger/formula/print.hpp"

namespace hilger {

namespace detail {

struct c_spelling {
    static constexpr double longest_product = 8; ///< x^8 is still written x * x * ...
    std::map<formula const*, std::string> names;

    static bool is_product(symbol const& f) {
        return f.op() == operation::power and f.value() == std::floor(f.value()) and f.value() <= longest_product;
    }
    [[nodiscard]] std::optional<written> own(symbol const& f) const {
        auto const at = names.find(&f.get());
        if (at == names.end()) return {};
        return written{at->second};
    }
    static std::string minus() { return "-"; }
    static std::string number(double x) {
        std::string const digits = round_trip(x);
        return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
    }
    static std::string variable(formula const& f) { return f.name; }
    static written product(written const& a, written const& b) {
        return {a.in(written::product) + " * " + b.in(written::factor), written::product};
    }
    static written quotient(written const& a, written const& b) {
        return {a.in(written::product) + " / " + b.in(written::factor), written::product};
    }
    static written over_norm(written const& a, written const& b) { return {"over_norm(" + a.text + ", " + b.text + ")"}; }
    static written where(bool not_negative, written const& c, written const& x) {
        return {(not_negative ? "if_not_negative(" : "if_negative(") + c.text + ", " + x.text + ")"};
    }
    static written power(written const& a, double n) {
        if (n != std::floor(n) or n > longest_product) return {"pow(" + a.text + ", " + number(n) + ")"};
        std::string text = a.in(written::factor);
        for (int k = 1; k < static_cast<int>(n); ++k) text += " * " + a.in(written::factor);
        return {text, written::product};
    }
    static written call(operation op, std::string const& arguments) {
        if (op == operation::abs) return {"fabs(" + arguments + ")"};
        if (op == operation::maximum or op == operation::minimum)
            return {(op == operation::maximum ? "larger(" : "smaller(") + arguments + ")"};
        if (op == operation::sign) return {"sign_of(" + arguments + ", 1.0)"};
        return {name_of(op) + ("(" + arguments + ")")};
    }
};

} // namespace detail

class c_statements {
public:
    /// `letter` begins the names of shared parts, u1, u2, ...: another one for other statements of the same scope.
    explicit c_statements(std::string indent, std::string letter = "u") : indent_(std::move(indent)), letter_(std::move(letter)) {}

    /// `before` stands as it is before the value: "r[0] =", "const double x =", "q[0] +=", "return".
    void add(std::string before, symbol value) { results_.emplace_back(std::move(before), std::move(value)); }

    /// The statements. Call it once, after the last add.
    std::string text() {
        for (auto const& [before, value] : results_) count(value);
        for (auto const& [before, value] : results_) {
            name_parts(value, false);
            lines_ += indent_ + before + " " + write(value) + ";\n";
        }
        return lines_;
    }
    /// The variables that the statements read, without indices: "q" for "q[1]".
    [[nodiscard]] std::set<std::string> const& read() const { return read_; }

private:
    /// An expression of more operations is cut in two, to keep lines short.
    static constexpr int longest = 12;

    [[nodiscard]] std::string write(symbol const& f) const { return formula_writer<detail::c_spelling>{spelling_}(f).text; }
    void count(symbol const& f) {
        if (f.op() == operation::variable) read_.insert(f.get().name.substr(0, f.get().name.find('[')));
        if (f.get().is_leaf()) return;
        if (++uses_[&f.get()] > 1) return;
        count(f.first());
        if (detail::c_spelling::is_product(f)) count(f.first()); // read twice at least
        if (f.get().b) count(f.second());
    }
    /// Names whatever in f is worth a name, f itself for its length only where it is a `part`, and returns the number of operations left.
    int name_parts(symbol const& f, bool part = true) {
        if (f.get().is_leaf() or spelling_.names.contains(&f.get())) return 0;
        int const size = 1 + name_parts(f.first()) + (f.get().b ? name_parts(f.second()) : 0);
        bool const trivial = f.op() == operation::negative and f.first().get().is_leaf();
        if (trivial or (uses_[&f.get()] < 2 and not(part and size >= longest))) return size;
        std::string const function = name_of(f.op());
        std::string const kind = function.empty() ? letter_ : function + "_";
        std::string const name = kind + std::to_string(++numbers_[kind]);
        lines_ += indent_ + "const double " + name + " = " + write(f) + ";\n";
        spelling_.names.emplace(&f.get(), name);
        return 0;
    }
    std::string indent_, letter_, lines_;
    std::vector<std::pair<std::string, symbol>> results_;
    std::map<formula const*, int> uses_;
    std::map<std::string, int> numbers_;
    std::set<std::string> read_;
    detail::c_spelling spelling_;
};

} // namespace hilger
