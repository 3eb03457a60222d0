// SPDX-License-Identifier: BSL-1.0
// A trajectory resumes with the numbers of a memory, not with its problem: masses, dampings and methods of one type may have other values
// in another trajectory. A difference in the problem itself, as the force at the last point, shows in the next step. A memory visits its
// numbers in one function, visit(method, each): a resumed trajectory reads them as the lines of text that a checkpoint has in a file
// (checkpoint.hpp).
#pragma once

#include <charconv>
#include <iomanip>
#include <locale>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "hilger/error.hpp"
#include "hilger/newton/stop.hpp"
#include "hilger/step/state.hpp"

namespace hilger::detail {

/// Whether a and b are the same result of a step from `start`, up to the differences between compilers.
template <class V>
bool is_the_same(V const& start, V const& a, V const& b) {
    using S = scalar_of<V>;
    S const change = magnitude(V(a - start)), size = std::max(S(magnitude(a)), S(magnitude(start)));
    return not(S(square_root_of_epsilon<S>() * change + S(64) * epsilon<S>() * size) < S(magnitude(V(a - b))));
}

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

/// The number that the whole word reads as. @throws std::exception when it is none.
template <class S>
S number_from(std::string const& word) {
    if constexpr (std::is_floating_point_v<S>) {
        std::size_t used = 0;
        auto const number = static_cast<S>(std::stold(word, &used));
        if (used != word.size()) throw std::invalid_argument(word);
        return number;
    } else
        return S(word);
}

/// Writes the visited numbers as lines of text, `label number`.
struct line_writer {
    std::vector<std::string> lines{};
    template <class X>
    void operator()(char const* label, X const& x) {
        lines.push_back(std::string(label).append(" ") + exact_text(x));
    }
};
/// Reads the lines of a line_writer into the visited numbers.
struct line_reader {
    std::vector<std::string> const& lines;
    std::string const& source;
    std::size_t read = 0;

    /// Reads the line `text`. @throws error::unreadable where the next line is another one
    void require(std::string const& text) {
        if (next("'" + text + "'", text) != text) refuse("'" + text + "'");
    }
    template <class X>
    void operator()(char const* label, X& x) {
        std::string const begin = std::string(label).append(" "), expected = std::string("'").append(label) + "' and a number";
        std::string const word = next(expected, begin).substr(begin.size());
        try {
            if constexpr (std::same_as<X, bool>)
                x = number_from<double>(word) != 0;
            else if constexpr (std::is_integral_v<X>) {
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

private:
    std::string const& next(std::string const& expected, std::string const& begin) {
        if (read++ == lines.size())
            error::raise<error::unreadable>("line ", read, " of ", source, " should be ", expected, ", and the text ends before it");
        if (not lines[read - 1].starts_with(begin)) refuse(expected);
        return lines[read - 1];
    }
    [[noreturn]] void refuse(std::string const& expected) const {
        error::raise<error::unreadable>("line ", read, " of ", source, " should be ", expected, ", and is '", lines[read - 1], "'");
    }
};

/// A memory of `method` with the numbers of another memory, as far as it visits them. @throws error::mismatch where their number differs
template <class S, class V, class Memory, class Method>
Memory transfer_memory(Memory from, Method const& method, S const& h, V const& like) {
    if constexpr (requires(line_writer each) { from.visit(method, each); }) {
        line_writer write;
        from.visit(method, write);
        Memory own(method, h, like);
        line_reader read{write.lines, "a memory"};
        bool fits = true;
        try {
            own.visit(method, read);
        } catch (error::unreadable const&) {
            fits = false;
        }
        if (not fits or read.read != write.lines.size())
            error::raise<error::mismatch>("a trajectory resumes from a checkpoint of its own method, and the one of this checkpoint "
                                          "remembers another number of values: it had another history or order, or was made for other "
                                          "numbers of steps");
        return own;
    } else
        return from;
}
/// Checks that a step of length h leads to the same state with the memory `other(at, x)`. @throws error::mismatch
template <class S, class V, class Method, class Memory, class Other>
void require_same_step(Memory remembered, Other const& other, Method const& method, state<S, V> const& at, S const& h) {
    std::optional<state<S, V>> with, without;
    try {
        state<S, V> x = at;
        remembered.advance(method, x, h);
        with = x;
        Memory another = other(at, x);
        x = at;
        another.advance(method, x, h);
        without = x;
    } catch (std::exception const&) { // no comparison then
    }
    if (without and not(is_the_same(at.q, with->q, without->q) and is_the_same(at.p, with->p, without->p)))
        error::raise<error::mismatch>(
            "a trajectory resumes from a checkpoint of its own problem and method, and a step from this one, at t = ", at.t,
            ", leads elsewhere. With another Lagrangian, force or damping a new trajectory begins at that "
            "state");
}
/// Checks that a step of length h leads to the same state with and without the memory. @throws error::mismatch
template <class S, class V, class Memory, class Method>
void require_its_own(Memory const& remembered, Method const& method, state<S, V> const& at, S const& h) {
    require_same_step(
        remembered,
        [&](state<S, V> const& from, state<S, V> const& to) {
            Memory nothing(method, h, from.q);
            if constexpr (requires(V const& v) { nothing.start_with(method, from, v); })
                nothing.start_with(method, from, mean_velocity(from, to));
            return nothing;
        },
        method, at, h);
}

} // namespace hilger::detail
