// SPDX-License-Identifier: BSL-1.0
// The grammar of formulas (hilger/text/expression.hpp), read by recursive descent.
#include "hilger/error.hpp"
#include "hilger/text/expression.hpp"

namespace hilger::text {

namespace {

class reader {
public:
    reader(std::string_view text, std::string source, place from, bool brackets_apply)
        : text_(text), source_(std::move(source)), here_(from), brackets_apply_(brackets_apply) {
        next();
    }

    expression whole() {
        if (token_.empty()) refuse("a formula was expected, and there is none");
        expression const e = alternatives();
        if (not token_.empty()) refuse("an operator or the end was expected, and there is " + seen());
        return e;
    }

private:
    // Each level of a formula passes through all of these functions.
    expression alternatives() {
        nested const deeper(*this);
        expression x = conjunction();
        while (token_ == "or") x = made(kind::either, {x, after(&reader::conjunction)});
        return x;
    }
    expression conjunction() {
        expression x = negation();
        while (token_ == "and") x = made(kind::both, {x, after(&reader::negation)});
        return x;
    }
    expression negation() {
        if (token_ != "not") return comparison();
        nested const deeper(*this);
        return made(kind::not_so, {after(&reader::negation)});
    }
    expression comparison() {
        expression const x = terms();
        std::string const how = token_;
        if (how != "<" and how != "<=" and how != ">" and how != ">=" and how != "==" and how != "!=") return x;
        expression const y = after(&reader::terms);
        if (how == "<") return made(kind::less, {x, y});
        if (how == "<=") return made(kind::less_or_equal, {x, y});
        if (how == ">") return made(kind::less, {y, x});
        if (how == ">=") return made(kind::less_or_equal, {y, x});
        expression const same = made(kind::equal, {x, y});
        return how == "==" ? same : made(kind::not_so, {same});
    }
    expression terms() {
        expression x = factors();
        while (token_ == "+" or token_ == "-") {
            kind const how = token_ == "+" ? kind::plus : kind::minus;
            x = made(how, {x, after(&reader::factors)});
        }
        return x;
    }
    expression factors() {
        expression x = with_sign();
        while (token_ == "*" or token_ == "/") {
            kind const how = token_ == "*" ? kind::times : kind::over;
            x = made(how, {x, after(&reader::with_sign)});
        }
        return x;
    }
    expression with_sign() {
        nested const deeper(*this);
        if (token_ == "+") return after(&reader::with_sign);
        if (token_ == "-") return made(kind::negative, {after(&reader::with_sign)});
        return power();
    }
    expression power() {
        expression const base = atom();
        if (token_ != "^" and token_ != "**") return base;
        return made(kind::power, {base, after(&reader::with_sign)});
    }
    expression atom() {
        place const at = token_at_;
        std::string const token = token_;
        if (token == "(") {
            next();
            expression x = alternatives();
            expect(")");
            while (brackets_apply_ and token_ == "[") {
                expression const to = after(&reader::alternatives);
                expect("]");
                x = expression(kind::call, "", {x, to}, at);
            }
            return x;
        }
        if (is_digit(token) or (token.size() > 1 and token[0] == '.')) {
            next();
            return {kind::number, token, {}, at};
        }
        if (not is_letter(token) or token == "and" or token == "or" or token == "not")
            refuse("a number, a name or a bracket was expected, and there is " + seen());
        next();
        if (token_ == "[") {
            next();
            expression const index = alternatives();
            expect("]");
            return {kind::element, token, {index}, at};
        }
        if (token_ != "(") return {kind::name, token, {}, at};
        next();
        std::vector<expression> arguments;
        if (token_ != ")") {
            arguments.push_back(alternatives());
            while (token_ == ",") arguments.push_back(after(&reader::alternatives));
        }
        expect(")");
        return called(token, arguments, at);
    }
    expression called(std::string const& name, std::vector<expression> const& arguments, place at) {
        auto const needs = [&](std::size_t count, char const* how) {
            if (arguments.size() != count)
                refuse("it is written " + std::string(how) + ", and here are " + std::to_string(arguments.size()) +
                           (arguments.size() == 1 ? " argument" : " arguments"),
                       at);
        };
        if (name == "if" or name == "where") {
            needs(3, "if(condition, where it holds, where not)");
            return {kind::choice, "", arguments, at};
        }
        if (name != "sum") return {kind::call, name, arguments, at};
        needs(4, "sum(index, first, last, term)");
        if (arguments[0].root().what != kind::name) refuse("the index of a sum is a name, as in sum(i, 0, n - 1, q[i]^2)", at);
        return {kind::sum, arguments[0].root().name, {arguments[1], arguments[2], arguments[3]}, at};
    }

    /// A nested formula, limited in depth by the stack of this reader.
    struct nested {
        explicit nested(reader& of) : count(of.depth_) {
            if (++count > deepest) of.refuse("formulas have at most " + std::to_string(deepest) + " levels of brackets and signs");
        }
        nested(nested const&) = delete;
        nested& operator=(nested const&) = delete;
        ~nested() { --count; }
        int& count;
    };
    expression made(kind what, std::vector<expression> const& parts) { return {what, "", parts, parts[0].root().at}; }
    expression after(expression (reader::*what)()) {
        next();
        return (this->*what)();
    }
    void expect(char const* token) {
        if (token_ != token) refuse("'" + std::string(token) + "' was expected, and there is " + seen());
        next();
    }
    [[nodiscard]] std::string seen() const { return token_.empty() ? "the end" : "'" + token_ + "'"; }
    [[noreturn]] void refuse(std::string const& why) const { refuse(why, token_at_); }
    [[noreturn]] void refuse(std::string const& why, place at) const {
        error::raise<error::unreadable>(source_, ", line ", at.line, ", column ", at.column, ": ", why);
    }

    static bool digit(char c) { return c >= '0' and c <= '9'; }
    static bool letter(char c) { return (c >= 'a' and c <= 'z') or (c >= 'A' and c <= 'Z') or c == '_' or static_cast<signed char>(c) < 0; }
    static bool is_digit(std::string const& token) { return not token.empty() and digit(token[0]); }
    static bool is_letter(std::string const& token) { return not token.empty() and letter(token[0]); }
    void step() {
        if (text_[at_] == '\n') {
            ++here_.line;
            here_.column = 1;
        } else if ((static_cast<unsigned char>(text_[at_]) & 0xC0U) != 0x80U) // one column for each letter of UTF-8
            ++here_.column;
        ++at_;
    }
    /// The next token; none at the end.
    void next() {
        auto const there = [&](std::size_t further = 0) { return at_ + further < text_.size() ? text_[at_ + further] : '\0'; };
        for (;;)
            if (there() == '#')
                while (at_ < text_.size() and there() != '\n') step();
            else if (there() == ' ' or there() == '\t' or there() == '\n' or there() == '\r')
                step();
            else
                break;
        token_at_ = here_;
        token_.clear();
        auto const take = [&] {
            token_ += there();
            step();
        };
        if (at_ >= text_.size()) return;
        if (digit(there()) or (there() == '.' and digit(there(1)))) {
            while (digit(there())) take();
            if (there() == '.') take();
            while (digit(there())) take();
            bool const exponent =
                (there() == 'e' or there() == 'E') and (digit(there(1)) or ((there(1) == '+' or there(1) == '-') and digit(there(2))));
            if (exponent) {
                take();
                if (not digit(there())) take();
                while (digit(there())) take();
            }
            if (letter(there())) {
                std::size_t bytes = 1; // of a letter of UTF-8
                while ((static_cast<unsigned char>(there(bytes)) & 0xC0U) == 0x80U) ++bytes;
                refuse("a number ends before '" + std::string(text_.substr(at_, bytes)) + "': a product is written with *, as 2*q", here_);
            }
            return;
        }
        if (letter(there())) {
            while (letter(there()) or digit(there())) take();
            return;
        }
        char const first = there();
        take();
        bool const two =
            ((first == '<' or first == '>' or first == '=' or first == '!') and there() == '=') or (first == '*' and there() == '*');
        if (two) take();
        if (token_ == "=") refuse("equality is ==");
        if (not two and std::string_view("+-*/^()[],<>").find(first) == std::string_view::npos)
            refuse("'" + (first >= ' ' ? token_ : "\\" + std::to_string(static_cast<unsigned char>(first))) +
                   "' has no meaning in a formula");
    }

    std::string_view text_;
    std::string source_;
    place here_, token_at_;
    std::size_t at_ = 0;
    std::string token_;
    int depth_ = 0;
    bool brackets_apply_;
};

} // namespace

expression read(std::string_view formula, std::string source, place from, bool brackets_apply) {
    return reader(formula, std::move(source), from, brackets_apply).whole();
}

} // namespace hilger::text
