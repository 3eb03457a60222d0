// SPDX-License-Identifier: BSL-1.0
// The tables beside this file: comma-separated, a comment and a line of names on top.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace hilger::testing {

using row = std::vector<std::string>;

inline std::vector<row> table(char const* name) {
    std::ifstream file(std::filesystem::path(__FILE__).parent_path() / name);
    if (not file) throw std::runtime_error(std::string("there is no ") + name);
    std::vector<row> rows;
    std::string line;
    for (bool names = true; std::getline(file, line);) {
        if (line.empty() or line.front() == '#') continue;
        if (not names) {
            rows.emplace_back();
            std::istringstream cells(line);
            for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
        }
        names = false;
    }
    return rows;
}
/// "1/3" or "0.5" as a number.
template <class S>
S number(std::string const& text) {
    auto const slash = text.find('/');
    if (slash == std::string::npos) return S(text.c_str());
    return S(text.substr(0, slash).c_str()) / S(text.substr(slash + 1).c_str());
}
template <>
inline double number<double>(std::string const& text) {
    auto const slash = text.find('/');
    return slash == std::string::npos ? std::stod(text) : std::stod(text.substr(0, slash)) / std::stod(text.substr(slash + 1));
}

} // namespace hilger::testing
