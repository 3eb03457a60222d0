// SPDX-License-Identifier: BSL-1.0
// A time scale from a text file: one point a line, blank lines and lines that start with # ignored.
#pragma once

#include <fstream>
#include <istream>
#include <sstream>
#include <string>

#include "hilger/scale/time_scale.hpp"

namespace hilger {

namespace detail {
/// The number that the whole word spells. @throws std::exception when it spells none.
template <class S>
S number_from(std::string const& word) {
    if constexpr (std::is_floating_point_v<S>) {
        std::size_t used = 0;
        auto const number = static_cast<S>(std::stold(word, &used));
        if (used != word.size()) throw std::invalid_argument(word);
        return number;
    } else {
        return S(word);
    }
}
} // namespace detail

/// @throws error::unreadable naming the line that is not a number; error::invalid_scale naming the line whose point does not come after
/// the one before it.
template <ordered_scalar S>
time_scale<S> read_time_scale(std::istream& in, std::string const& source = "the input") {
    std::vector<S> points;
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        std::istringstream words(line);
        std::string word, rest;
        if (not(words >> word) or word.front() == '#') continue;
        try {
            points.push_back(detail::number_from<S>(word));
            if (words >> rest) throw std::invalid_argument(rest);
        } catch (std::exception const&) {
            error::raise<error::unreadable>("line ", number, " of ", source, " should be one number and is '", line, "'");
        }
        if (not is_finite(points.back()))
            error::raise<error::invalid_scale>("the points of a time scale are finite, and line ", number, " of ", source, " is '", line,
                                               "'");
        if (points.size() > 1 and not(points[points.size() - 2] < points.back()))
            error::raise<error::invalid_scale>("the points of a time scale increase, and line ", number, " of ", source, " is ",
                                               points.back(), " after ", points[points.size() - 2]);
    }
    if (in.bad()) error::raise<error::unreadable>(source, " could not be read to its end");
    if (points.size() < 2) error::raise<error::invalid_scale>("a time scale needs two points, and ", source, " has ", points.size());
    return time_scale<S>(std::move(points));
}

/// @throws error::unreadable when the file cannot be opened, and as above.
template <ordered_scalar S>
time_scale<S> read_time_scale(std::string const& path) {
    std::ifstream in(path);
    if (not in) error::raise<error::unreadable>("cannot open '", path, "' to read a time scale from it");
    return read_time_scale<S>(in, "'" + path + "'");
}

} // namespace hilger
