// SPDX-License-Identifier: BSL-1.0
// Formulas, and how they are written as text.
#include "hilger/text/expression.hpp"

#include <algorithm>
#include <iterator>

#include "hilger/error.hpp"

namespace hilger::text {

node::node(kind k, std::string of_name, std::vector<pointer> of_parts, place where)
    : what(k), name(std::move(of_name)), parts(std::move(of_parts)), at(where) {
    for (std::size_t j = 0; j < parts.size(); ++j)
        depth = std::max(depth, parts[j]->depth + (j == 0 and is_arithmetic(what) and is_arithmetic(parts[j]->what) ? 0 : 1));
}
node::~node() {
    std::vector<pointer> open = std::move(parts);
    while (not open.empty()) {
        pointer const last = std::move(open.back());
        open.pop_back();
        if (last.use_count() == 1) {
            auto& below = const_cast<std::vector<pointer>&>(last->parts); // it has no other owner, and no node is created const
            std::move(below.begin(), below.end(), std::back_inserter(open));
            below.clear();
        }
    }
}

expression::expression(kind what, std::string name, std::vector<expression> const& parts, place at) {
    std::vector<node::pointer> nodes;
    for (expression const& e : parts) nodes.push_back(e.root_);
    auto made = std::make_shared<node>(what, std::move(name), std::move(nodes), at);
    if (made->depth > deepest)
        error::raise<error::invalid_parameter>("a formula has at most ", deepest, " levels of parts in parts, and this one has more");
    root_ = std::move(made);
}

namespace {

/// Decides where the grammar of read.cpp needs brackets.
class writer {
public:
    explicit writer(std::size_t longest) : longest_(longest) {}

    /// Nothing when the text is longer than the limit.
    std::optional<std::string> text_of(node const& n) {
        write(n, anything);
        if (text_.size() > longest_) return {};
        return std::move(text_);
    }

private:
    // A level that binds more tightly is larger.
    enum level { anything, conjunction, negation, comparison, terms, factors, sign, power, atom };
    struct spelling {
        level binds;
        char const* between = "";
    };
    static spelling spelling_of(node const& n) {
        switch (n.what) {
        case kind::either:
            return {anything, " or "};
        case kind::both:
            return {conjunction, " and "};
        case kind::not_so:
            return {n.parts[0]->what == kind::equal ? comparison : negation}; // a != b
        case kind::less:
            return {comparison, " < "};
        case kind::less_or_equal:
            return {comparison, " <= "};
        case kind::equal:
            return {comparison, " == "};
        case kind::plus:
            return {terms, " + "};
        case kind::minus:
            return {terms, " - "};
        case kind::times:
            return {factors, "*"};
        case kind::over:
            return {factors, "/"};
        case kind::negative:
            return {sign};
        case kind::power:
            return {power, "^"};
        default:
            return {atom};
        }
    }
    static level level_of(node const& n) { return spelling_of(n).binds; }
    /// Writes n in brackets unless it binds at least as tightly as `wanted`.
    void write(node const& n, level wanted) {
        if (text_.size() > longest_) return; // shared parts can make the text exponentially long
        bool const bracket = level_of(n) < wanted;
        if (bracket) text_ += '(';
        if (is_arithmetic(n.what))
            write_chain(n);
        else
            write_inside(n);
        if (bracket) text_ += ')';
    }
    void write_inside(node const& n) {
        auto const two = [&](level left, level right) {
            write(*n.parts[0], left);
            text_ += spelling_of(n).between;
            write(*n.parts[1], right);
        };
        switch (n.what) {
        case kind::either:
            return two(anything, conjunction);
        case kind::both:
            return two(conjunction, negation);
        case kind::less:
        case kind::less_or_equal:
        case kind::equal:
            return two(terms, terms);
        case kind::not_so:
            if (node const& same = *n.parts[0]; same.what == kind::equal) {
                write(*same.parts[0], terms);
                text_ += " != ";
                return write(*same.parts[1], terms);
            }
            text_ += "not ";
            return write(*n.parts[0], negation);
        case kind::negative:
            text_ += '-';
            return write(*n.parts[0], power);
        case kind::power:
            return two(atom, sign);
        case kind::number:
        case kind::name:
            text_ += n.name;
            return;
        case kind::element:
            return write_list(n.name + '[', n, ']');
        case kind::choice:
            return write_list("if(", n, ')');
        case kind::sum:
            return write_list("sum(" + n.name + ", ", n, ')');
        default:
            return write_list(n.name + '(', n, ')');
        }
    }
    void write_list(std::string const& begin, node const& n, char end) {
        text_ += begin;
        for (std::size_t k = 0; k < n.parts.size(); ++k) {
            if (k > 0) text_ += ", ";
            write(*n.parts[k], anything);
        }
        text_ += end;
    }
    /// Goes down the left side of a + b*c - ... and up again, without recursion: chains may be longer than the stack allows.
    void write_chain(node const& n) {
        std::vector<node const*> above{&n};
        while (is_arithmetic(above.back()->parts[0]->what)) {
            node const& left = *above.back()->parts[0];
            if (level_of(left) < level_of(*above.back())) text_ += '(';
            above.push_back(&left);
        }
        write(*above.back()->parts[0], level_of(*above.back()));
        for (std::size_t k = above.size(); k-- > 0;) {
            node const& here = *above[k];
            text_ += spelling_of(here).between;
            write(*here.parts[1], level_of(here) == terms ? factors : power);
            if (k > 0 and level_of(here) < level_of(*above[k - 1])) text_ += ')';
        }
    }
    std::size_t longest_;
    std::string text_;
};

} // namespace

std::optional<std::string> written(expression const& e, std::size_t longest) { return writer(longest).text_of(e.root()); }

} // namespace hilger::text
