// SPDX-License-Identifier: BSL-1.0
// What the text of a step in lanes is put together from: statements, largest elements, elimination.
#pragma once

#include "hilger/formula/c_step.hpp"

namespace engine {

using hilger::symbol;
using hilger::detail::element;

/// Statements whose values are lanes, those of no variable too.
class lane_statements {
public:
    explicit lane_statements(std::string indent, std::string letter = "u") : statements_(std::move(indent), std::move(letter)) {}
    void add(std::string before, symbol const& value) { statements_.add(before + (is_constant(value) ? " (lanes){0} +" : ""), value); }
    [[nodiscard]] std::string text() {
        std::string all = statements_.text();
        for (std::size_t at = 0; (at = all.find("const double ", at)) != std::string::npos;) all.replace(at, 13, "const lanes ");
        return all;
    }
    [[nodiscard]] std::set<std::string> const& read() const { return statements_.read(); }

private:
    static bool is_constant(symbol const& f) {
        if (f.op() == hilger::operation::number) return true;
        if (f.op() == hilger::operation::variable) return false;
        return is_constant(f.first()) and (not f.get().b or is_constant(f.second()));
    }
    hilger::c_statements statements_;
};

inline std::string largest_of(std::string const& array, int n) {
    std::string text = "size_of(" + element(array, 0) + ")";
    for (int k = 1; k < n; ++k) text = "larger(" + text + ", size_of(" + element(array, k) + "))";
    return text;
}

/// d becomes K^-1 d, with the rows of the largest pivots; `regular` says of which lanes. Of one member rows are exchanged in a branch that
/// is seldom taken, for what follows does not wait for it.
inline std::string elimination(int n, std::string const& in, bool one) {
    std::string text;
    auto const K = [](int j, int k) { return element("K", j, k); };
    auto const line = [&](std::string const& what) { text += in + what + ";\n"; };
    line("lanes least = size_of(K[0][0]), most = least");
    for (int k = 0; k < n; ++k) {
        for (int j = k + 1; j < n; ++j) {
            text += in + "{\n" + in + "    const mask swap = size_of(" + K(j, k) + ") > size_of(" + K(k, k) + ");\n" + in +
                    "    lanes above;\n" + (one ? in + "    if (swap[0]) {\n" : "");
            auto const exchange = [&](std::string const& a, std::string const& b) {
                std::string const first = one ? b : "either(swap, " + b + ", above)",
                                  second = one ? "above" : "either(swap, above, " + b + ")";
                text += in + "    above = " + a + ", " + a + " = " + first + ", " + b + " = " + second + ";\n";
            };
            for (int m = k; m < n; ++m) exchange(K(k, m), K(j, m));
            exchange(element("d", k), element("d", j));
            if (one) text += in + "    }\n";
            text += in + "}\n";
        }
        line("least = " + (k == 0 ? "size_of(" + K(0, 0) + ")" : "smaller(least, size_of(" + K(k, k) + "))"));
        line("most = " + (k == 0 ? std::string("least") : "larger(most, size_of(" + K(k, k) + "))"));
        line("const lanes over" + std::to_string(k) + " = 1.0 / " + K(k, k)); // divisions are what takes the time
        for (int j = k + 1; j < n; ++j) {
            line(K(j, k) + " *= over" + std::to_string(k));
            for (int m = k + 1; m < n; ++m) line(K(j, m) + " -= " + K(j, k) + " * " + K(k, m));
            line(element("d", j) + " -= " + K(j, k) + " * " + element("d", k));
        }
    }
    for (int k = n - 1; k >= 0; --k) {
        for (int j = k + 1; j < n; ++j) line(element("d", k) + " -= " + K(k, j) + " * " + element("d", j));
        line(element("d", k) + " *= over" + std::to_string(k));
    }
    line("const mask regular = least > " + hilger::detail::c_spelling::number(n * hilger::epsilon<double>()) + " * most");
    return text;
}

} // namespace engine
