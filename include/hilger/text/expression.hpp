// SPDX-License-Identifier: BSL-1.0
// A formula known at run time only: read from text, or put together by a program in another language. It holds names and numbers as they
// were written, 0.1 is one tenth in rationals and in 100 digits, and is evaluated in any of them (text/stated.hpp). Parts may be shared,
// and never change. This folder declares the library hilger::text (src/text).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hilger::text {

/// Kinds of nodes, with the meaning of their parts.
enum class kind : unsigned char {
    number,  ///< name: its digits
    name,    ///< of a variable, a parameter, or the index of a sum
    element, ///< name[parts[0]]
    plus,    ///< of two parts, as what follows
    minus,
    times,
    over,
    power,
    less,
    less_or_equal,
    equal,
    both, ///< of two conditions
    either,
    not_so, ///< of one
    negative,
    call,   ///< name(parts...)
    choice, ///< if(parts[0], parts[1], parts[2])
    sum     ///< over name = parts[0] ... parts[1] of parts[2]
};
constexpr bool is_arithmetic(kind k) { return kind::plus <= k and k <= kind::over; }
constexpr bool is_condition(kind k) { return kind::less <= k and k <= kind::not_so; }

/// A position in a text, from 1 on; 0 outside of any text.
struct place {
    int line = 0, column = 0;
};

/// An operation, a name or a number of a formula, with its parts.
struct node {
    using pointer = std::shared_ptr<node const>;
    kind what = kind::number;
    std::string name;
    std::vector<pointer> parts;
    place at;
    int depth = 1; ///< of nested parts; (a + b) + c is no deeper than a + b, and evaluated without recursion

    node(kind k, std::string of_name, std::vector<pointer> of_parts, place where = {});
    node(node const&) = delete;
    node& operator=(node const&) = delete;
    /// Releases long chains one by one.
    ~node();
};

/// Deeper formulas are refused: the stack has no room for more levels.
inline constexpr int deepest = 400;

/// A formula: the root of a tree of nodes.
class expression {
public:
    /// The number 0.
    expression() : expression(kind::number, "0", {}) {}
    /// A node of any kind. @throws error::invalid_parameter if it is nested too deeply
    expression(kind what, std::string name, std::vector<expression> const& parts, place at = {});
    /// The formula with this root.
    explicit expression(node::pointer root) : root_(std::move(root)) {}
    static expression number(std::string digits) { return {kind::number, std::move(digits), {}}; }
    static expression variable(std::string name) { return {kind::name, std::move(name), {}}; }
    static expression element(std::string name, expression const& index) { return {kind::element, std::move(name), {index}}; }
    static expression call(std::string function, std::vector<expression> const& arguments) {
        return {kind::call, std::move(function), arguments};
    }

    [[nodiscard]] node const& root() const { return *root_; }
    [[nodiscard]] node::pointer const& shared() const { return root_; }

    friend expression operator+(expression const& x, expression const& y) { return {kind::plus, "", {x, y}}; }
    friend expression operator-(expression const& x, expression const& y) { return {kind::minus, "", {x, y}}; }
    friend expression operator*(expression const& x, expression const& y) { return {kind::times, "", {x, y}}; }
    friend expression operator/(expression const& x, expression const& y) { return {kind::over, "", {x, y}}; }
    friend expression operator-(expression const& x) { return {kind::negative, "", {x}}; }
    friend expression pow(expression const& x, expression const& y) { return {kind::power, "", {x, y}}; }

private:
    node::pointer root_;
};

/// Reads the formula in a text. `source` and `from` are the place of the text in errors.
///   m*v^2/2 - m*g*l*(1 - cos(q))
///   sum(i, 0, n - 1, v[i]^2)/2 - sum(i, 0, n - 2, (q[i + 1] - q[i])^2)/2
///   sum(i, 1, n, sum(j, 0, i - 1, ...)), dot(q, q), norm(v), if(t < 1, a, b), pi
/// With `brackets_apply` operators act on functions, too: (A + B)[q] is a call without a name, of A + B and q.
/// + - * / as everywhere, x^y and x**y from the right and before the sign: -x^2 is -(x^2). A # ends a line.
/// @throws error::unreadable with line and column, the text there, and what was expected
expression read(std::string_view formula, std::string source = "the formula", place from = {1, 1}, bool brackets_apply = false);
/// The text that read() makes the same formula of, v^2/2 - (1 - cos(q)); none if it has more than `longest` characters.
std::optional<std::string> written(expression const& e, std::size_t longest);

} // namespace hilger::text
