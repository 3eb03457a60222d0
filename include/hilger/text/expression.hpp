// SPDX-License-Identifier: BSL-1.0
// A formula that is known at run time only: read from text (text/read.hpp), or put together by a program in another language. It holds
// names and numbers as they were written, 0.1 is one tenth in rationals and in 100 digits, and is evaluated in any of them
// (text/evaluate.hpp). Parts may be shared, and never change.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hilger/error.hpp"

namespace hilger::text {

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

/// Where something begins in a text, from 1 on; 0 for what was in none.
struct place {
    int line = 0, column = 0;
};

struct node {
    using pointer = std::shared_ptr<node const>;
    kind what = kind::number;
    std::string name;
    std::vector<pointer> parts;
    place at;
    int depth = 1; ///< of nested parts; (a + b) + c is no deeper than a + b, and evaluated without recursion

    node(kind k, std::string of_name, std::vector<pointer> of_parts, place where = {})
        : what(k), name(std::move(of_name)), parts(std::move(of_parts)), at(where) {
        for (std::size_t j = 0; j < parts.size(); ++j)
            depth = std::max(depth, parts[j]->depth + (j == 0 and is_arithmetic(what) and is_arithmetic(parts[j]->what) ? 0 : 1));
    }
    node(node const&) = delete;
    node& operator=(node const&) = delete;
    /// Long chains are let go one by one.
    ~node() {
        std::vector<pointer> open = std::move(parts);
        while (not open.empty()) {
            pointer const last = std::move(open.back());
            open.pop_back();
            if (last.use_count() == 1) {
                auto& below = const_cast<std::vector<pointer>&>(last->parts); // nobody else has it, and no node is made as a constant
                std::move(below.begin(), below.end(), std::back_inserter(open));
                below.clear();
            }
        }
    }
};

/// More levels than a stack has room for are refused.
inline constexpr int deepest = 400;

class expression {
public:
    /// The number 0.
    expression() : expression(kind::number, "0", {}) {}
    /// A node of any kind. @throws error::invalid_parameter when it is nested too deeply
    expression(kind what, std::string name, std::vector<expression> const& parts, place at = {}) {
        std::vector<node::pointer> nodes;
        for (expression const& e : parts) nodes.push_back(e.root_);
        auto made = std::make_shared<node>(what, std::move(name), std::move(nodes), at);
        if (made->depth > deepest)
            error::raise<error::invalid_parameter>("a formula has at most ", deepest, " levels of parts in parts, and this one has more");
        root_ = std::move(made);
    }
    /// What begins at a node.
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

} // namespace hilger::text
