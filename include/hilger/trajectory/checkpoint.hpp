// SPDX-License-Identifier: BSL-1.0
// A checkpoint as text that reads back exactly: built-in floating numbers in hexadecimal, wide ones with all their digits, rationals as
// they are. One labelled number a line, the version of the format in the first line and `end` in the last one.
//   auto at = path.begin(); ...                       write_checkpoint(out, path, at.checkpoint());
//   for (auto [t, q, p] : path.resume(read_checkpoint(in, path))) ...
#pragma once

#include <charconv>
#include <iomanip>
#include <istream>
#include <locale>
#include <ostream>

#include "hilger/scale/read.hpp"
#include "hilger/trajectory/trajectory.hpp"

namespace hilger {

namespace detail {

inline constexpr char const* checkpoint_version = "hilger checkpoint 1";

/// Text that number_from reads back as the same number.
template <class X>
std::string exact_text(X const& x) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    if constexpr (std::is_floating_point_v<X>)
        out << std::hexfloat << x;
    else if constexpr (std::numeric_limits<X>::is_exact)
        out << x;
    else
        out << std::scientific << std::setprecision(std::numeric_limits<X>::max_digits10) << x;
    return out.str();
}

struct checkpoint_writer {
    std::ostream& out;
    template <class X>
    void operator()(char const* label, X const& x) {
        out << label << ' ' << exact_text(x) << '\n';
    }
};

struct checkpoint_reader {
    std::istream& in;
    std::string const& source;
    int number = 0;
    std::string line{};

    /// @throws error::unreadable where the text ends
    void next(std::string const& expected) {
        ++number;
        if (not std::getline(in, line))
            error::raise<error::unreadable>("line ", number, " of ", source, " should be ", expected, ", and the text ends before it");
        if (not line.empty() and line.back() == '\r') line.pop_back();
    }
    void require(std::string const& text) {
        next("'" + text + "'");
        if (line != text) refuse("'" + text + "'");
    }
    template <class X>
    void operator()(char const* label, X& x) {
        // Appended: g++ 12 warns of what it makes of text + std::string.
        std::string const expected = std::string("'").append(label) + "' and a number";
        next(expected);
        std::istringstream words(line);
        std::string found, word, rest;
        if (not(words >> found >> word) or found != label or words >> rest) refuse(expected);
        try {
            if constexpr (std::is_integral_v<X>) {
                auto const [end, error] = std::from_chars(word.data(), word.data() + word.size(), x);
                if (error != std::errc{} or end != word.data() + word.size()) throw std::invalid_argument(word);
            } else {
                x = number_from<X>(word);
                if (not is_finite(x)) throw std::invalid_argument(word);
            }
        } catch (std::exception const&) {
            refuse(expected);
        }
    }
    [[noreturn]] void refuse(std::string const& expected) const {
        error::raise<error::unreadable>("line ", number, " of ", source, " should be ", expected, ", and is '", line, "'");
    }
};

/// What a checkpoint is read into must have the same numbers in it; the scalar is told by its binary digits.
template <class S, class V, class Memory, class Method, class Visit>
void visit_checkpoint(checkpoint<S, V, Memory>& point, Method const& method, Visit& each) {
    static_assert(
        requires { point.memory.visit(method, each); }, "a method whose checkpoints are written has memory::visit(method, each)");
    using s = shape<V>;
    each("point", point.number);
    each("time", point.at.t);
    for (int k = 0; k < s::dimension(point.at.q); ++k) each("position", s::component(point.at.q, k));
    for (int k = 0; k < s::dimension(point.at.p); ++k) each("momentum", s::component(point.at.p, k));
    point.memory.visit(method, each);
}
template <class S>
std::string scalar_line() {
    return std::numeric_limits<S>::is_exact ? std::string("scalar exact")
                                            : "scalar with " + std::to_string(std::numeric_limits<S>::digits) + " digits";
}

} // namespace detail

/// Writes a checkpoint of `path`.
template <class Path>
void write_checkpoint(std::ostream& out, Path const& path, typename Path::checkpoint_type point) {
    detail::checkpoint_writer writer{out};
    out << detail::checkpoint_version << '\n' << detail::scalar_line<decltype(point.at.t)>() << '\n';
    detail::visit_checkpoint(point, path.method(), writer);
    out << "end\n";
}

/// Reads what write_checkpoint has written for a trajectory of the same method, scalar and dimension.
/// @throws error::unreadable, naming the line and what it should be
template <class Path>
typename Path::checkpoint_type read_checkpoint(std::istream& in, Path const& path, std::string const& source = "the input") {
    auto point = path.begin().checkpoint();
    detail::checkpoint_reader reader{in, source};
    reader.require(detail::checkpoint_version);
    reader.require(detail::scalar_line<decltype(point.at.t)>());
    detail::visit_checkpoint(point, path.method(), reader);
    reader.require("end");
    return point;
}

} // namespace hilger
