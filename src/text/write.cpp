// SPDX-License-Identifier: BSL-1.0
#include "hilger/text/expression.hpp"

namespace hilger::text {

namespace {

/// Says where the grammar of read.cpp needs brackets.
class writer {
public:
    explicit writer(std::size_t longest) : longest_(longest) {}

    /// Nothing when it is longer than wanted.
    std::optional<std::string> text_of(node const& n) {
        write(n, anything);
        if (text_.size() > longest_) return {};
        return std::move(text_);
    }

private:
    // What binds more tightly is larger.
    enum level { anything, conjunction, negation, comparison, terms, factors, sign, power, atom };

    static level level_of(node const& n) {
        switch (n.what) {
        case kind::either:
            return anything;
        case kind::both:
            return conjunction;
        case kind::not_so:
            return n.parts[0]->what == kind::equal ? comparison : negation; // a != b
        case kind::less:
        case kind::less_or_equal:
        case kind::equal:
            return comparison;
        case kind::plus:
        case kind::minus:
            return terms;
        case kind::times:
        case kind::over:
            return factors;
        case kind::negative:
            return sign;
        case kind::power:
            return power;
        default:
            return atom;
        }
    }
    static char const* spelling(kind k) {
        switch (k) {
        case kind::either:
            return " or ";
        case kind::both:
            return " and ";
        case kind::less:
            return " < ";
        case kind::less_or_equal:
            return " <= ";
        case kind::equal:
            return " == ";
        case kind::plus:
            return " + ";
        case kind::minus:
            return " - ";
        case kind::times:
            return "*";
        case kind::over:
            return "/";
        default:
            return "^";
        }
    }
    /// `wanted`: in brackets unless it binds as tightly as that.
    void write(node const& n, level wanted) {
        if (text_.size() > longest_) return; // parts may be shared, and written out be without end
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
            text_ += spelling(n.what);
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
    /// a + b*c - ... down its left side and up again: chains may be longer than a stack is deep.
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
            text_ += spelling(here.what);
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
