// SPDX-License-Identifier: BSL-1.0
// Building blocks for the text of a step in lanes: largest elements, elimination.
#pragma once

#include "text/c_statements.hpp"

namespace engine {

using hilger::detail::element, hilger::detail::filled, hilger::detail::c_number;

inline std::string largest_of(std::string const& array, int n) { return hilger::detail::largest_in(array, n, "larger", "size_of"); }

/// Replaces d by K^-1 d, with pivoting by rows; `regular` is a mask of lanes. Elements that are not `there` are 0. For one member rows are
/// exchanged in a rarely taken branch, so that the following operations need not wait for it.
inline std::string elimination(int n, std::string const& in, bool one, std::vector<bool> there) {
    std::string text;
    auto const K = [](int j, int k) { return element("K", j, k); };
    auto const is_there = [&](int j, int k) { return there[static_cast<std::size_t>(j * n + k)]; };
    auto const line = [&](std::string const& what) { text += in + what + ";\n"; };
    for (int k = 0; k < n; ++k) {
        for (int j = k + 1; j < n; ++j) {
            if (not is_there(j, k)) continue;
            std::string const inner = one ? in + "    " : in;
            std::string exchanged;
            auto const exchange = [&](std::string const& a, std::string const& b) {
                std::string const first = one ? b : "either(swap, " + b + ", above)",
                                  second = one ? "above" : "either(swap, above, " + b + ")";
                exchanged += inner + "    above = " + a + ", " + a + " = " + first + ", " + b + " = " + second + ";\n";
            };
            for (int m = k; m < n; ++m) {
                if (not is_there(k, m) and not is_there(j, m)) continue;
                for (int const row : {k, j})
                    if (not is_there(row, m)) line(K(row, m) + " = all(0.0)"), there[static_cast<std::size_t>(row * n + m)] = true;
                exchange(K(k, m), K(j, m));
            }
            exchange(element("d", k), element("d", j));
            text += in + "{\n" + in + "    const mask swap = size_of(" + K(j, k) + ") > size_of(" + K(k, k) + ");\n" + in +
                    "    lanes above;\n" + (one ? in + "    if (swap) {\n" + exchanged + in + "    }\n" : exchanged) + in + "}\n";
        }
        std::string const size = "size_of(" + K(k, k) + ")";
        line(k == 0 ? "lanes least = " + size + ", most = least"
                    : "least = smaller(least, " + size + "), most = larger(most, " + size + ")");
        line("const lanes over" + std::to_string(k) + " = 1.0 / " + K(k, k)); // divisions dominate the time
        for (int j = k + 1; j < n; ++j) {
            if (not is_there(j, k)) continue;
            line(K(j, k) + " *= over" + std::to_string(k));
            for (int m = k + 1; m < n; ++m)
                if (is_there(k, m)) {
                    line(K(j, m) + (is_there(j, m) ? " -= " : " = -") + K(j, k) + " * " + K(k, m));
                    there[static_cast<std::size_t>(j * n + m)] = true;
                }
            line(element("d", j) + " -= " + K(j, k) + " * " + element("d", k));
        }
    }
    for (int k = n - 1; k >= 0; --k) {
        for (int j = k + 1; j < n; ++j)
            if (is_there(k, j)) line(element("d", k) + " -= " + K(k, j) + " * " + element("d", j));
        line(element("d", k) + " *= over" + std::to_string(k));
    }
    line("const mask regular = least > " + c_number(n * hilger::epsilon<double>()) + " * most");
    return text;
}

} // namespace engine
