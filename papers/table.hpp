// SPDX-License-Identifier: BSL-1.0
// What the papers' tests and `hilger papers` share: tables as they were printed, how far a number is from a printed one, and slopes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <istream>
#include <sstream>
#include <string>
#include <vector>

#include "hilger/error.hpp"

namespace hilger::papers {

using row = std::vector<std::string>;

/// The rows of a comma-separated table as texts; comments, which begin with #, and the line of names are left out.
inline std::vector<row> rows_of(std::istream& in) {
    std::vector<row> rows;
    std::string line;
    for (bool names = true; std::getline(in, line);) {
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
/// The table papers/`name` of the sources that this was compiled from.
/// @throws error::unreadable
inline std::vector<row> table(std::string const& name) {
    std::ifstream file(std::filesystem::path(__FILE__).parent_path() / name);
    if (not file) error::raise<error::unreadable>("cannot open the table papers/", name);
    return rows_of(file);
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

/// (computed - printed) in units of the last digit printed: at most 1/2 in magnitude where the number was rounded, in [0, 1[ where it was
/// cut off. Printed as 1.23 or 1.23e-4.
inline double difference_in_units(double computed, std::string const& printed) {
    auto const end = std::min(printed.find('e'), printed.size()), point = printed.find('.');
    int digits = point == std::string::npos ? 0 : static_cast<int>(end - point - 1);
    if (end < printed.size()) digits -= std::stoi(printed.substr(end + 1));
    return (computed - number<double>(printed)) * std::pow(10.0, digits);
}

/// The slope of ln y against ln h by least squares, h divided by `ratio` from one to the next.
template <class Values>
double fitted_slope(Values const& errors, double ratio = 2) {
    double const n = static_cast<double>(errors.size());
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        using std::log;
        double const x = -static_cast<double>(i) * std::log(ratio), y = static_cast<double>(log(errors[i]));
        sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

} // namespace hilger::papers
