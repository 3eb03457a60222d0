// SPDX-License-Identifier: BSL-1.0
// A linear expression in notation: a sum of terms, each with a rational factor, constants, weights that depend on t, and an argument. An
// expression carries both notations, for a terminal and for LaTeX, so that they name the same operators.
#pragma once

#include <memory>
#include <numeric>
#include <string>
#include <vector>

namespace hilger {

/// Unicode for a terminal, or LaTeX.
enum class print_style { terminal, latex };

/// A symbol for a terminal and in LaTeX, each with a note that explains it ("" when none).
struct notation {
    std::string terminal, latex;
    std::string terminal_note{}, latex_note{};

    [[nodiscard]] std::string const& in(print_style s) const { return s == print_style::latex ? latex : terminal; }
    [[nodiscard]] std::string const& note(print_style s) const { return s == print_style::latex ? latex_note : terminal_note; }
};

namespace detail {

/// The digits of n >= 0 as ₀ to ₉.
inline std::string subscript(int n) {
    std::string text;
    for (char const c : std::to_string(n)) text += std::string("\xE2\x82") + static_cast<char>(0x80 + (c - '0'));
    return text;
}

class expression;

/// A part of a term: its argument, or a factor before that. Expressions share parts, which never change.
struct written_part {
    enum class kind {
        name,        ///< q
        signed_name, ///< -dH/dq(p, q), in brackets when something stands before it
        bracketed,   ///< before inner after, where before and after enclose: Delta_+[ inner ]
        marked       ///< inner after: q_o, and (inner) after where inner is longer than a name
    };
    kind is = kind::name;
    notation before{}, after{};
    std::shared_ptr<expression const> inner{};  ///< none in a name
    std::shared_ptr<written_part const> next{}; ///< the next factor
};

struct written_term {
    using part = std::shared_ptr<written_part const>;
    long long numerator = 1, denominator = 1;
    part constants{}; ///< numbers known at run time only, and symbols of constants
    part weights{};   ///< functions of t
    part what{};

    [[nodiscard]] bool is_plain() const { return numerator == 1 and denominator == 1 and not constants and not weights; }
};

class expression {
    using kind = written_part::kind;
    using part = written_term::part;

public:
    static expression name(notation as, bool has_sign = false) {
        expression e;
        e.terms_.emplace_back().what = made({has_sign ? kind::signed_name : kind::name, std::move(as)});
        return e;
    }
    [[nodiscard]] bool is_name() const { return terms_.size() == 1 and terms_[0].is_plain() and terms_[0].what->is == kind::name; }
    /// The opening bracket of a single term that no weight multiplies; else "".
    [[nodiscard]] std::string bracket() const {
        return terms_.size() == 1 and not terms_[0].weights and terms_[0].what->is == kind::bracketed ? terms_[0].what->before.terminal
                                                                                                      : "";
    }

    [[nodiscard]] expression times(long long numerator, long long denominator) const {
        expression e = *this;
        for (auto& t : e.terms_) {
            long long above = 0, below = 0;
            if (__builtin_mul_overflow(t.numerator, numerator, &above) or __builtin_mul_overflow(t.denominator, denominator, &below)) {
                std::string text = std::to_string(numerator);
                if (denominator != 1) text += '/' + std::to_string(denominator);
                t.constants = before(t.constants, {text, text});
                continue;
            }
            long long const g = std::max(std::gcd(above, below), 1LL);
            t.numerator = above / g;
            t.denominator = below / g;
        }
        return e;
    }
    [[nodiscard]] expression times_constant(notation const& c) const {
        expression e = *this;
        for (auto& t : e.terms_) t.constants = before(t.constants, c);
        return e;
    }
    [[nodiscard]] expression times_weight(notation const& w) const {
        expression e = *this;
        for (auto& t : e.terms_) t.weights = before(t.weights, w);
        return e;
    }
    friend expression operator+(expression a, expression const& b) {
        for (auto const& t : b.terms_) a.terms_.push_back(t);
        return a;
    }
    /// before[this]after; the constants of a single term stand before it all.
    [[nodiscard]] expression in_brackets(notation before, notation after) const {
        return enclosed({kind::bracketed, std::move(before), std::move(after)});
    }
    [[nodiscard]] expression marked(notation mark) const { return enclosed({kind::marked, {}, std::move(mark)}); }
    /// A single term without its brackets.
    [[nodiscard]] expression without_brackets() const { return opened(terms_[0]); }
    /// Without the mark `mark` on whole terms, where the context names the points.
    [[nodiscard]] expression without(std::string const& mark) const {
        expression e;
        for (auto const& t : terms_)
            if (t.what->is == kind::marked and t.what->after.terminal == mark and not t.weights)
                e = std::move(e) + opened(t);
            else
                e.terms_.push_back(t);
        return e;
    }

    [[nodiscard]] std::string in(print_style s) const {
        std::string text;
        for (auto const& t : terms_) {
            bool const first = text.empty(), negative = t.numerator < 0;
            char const* const minus = s == print_style::latex ? "-" : "−";
            if (not first) text += ' ';
            if (not first or negative) text += negative ? minus : "+";
            if (not first) text += ' ';
            write(text, t, s, first and not negative);
        }
        return text.empty() ? "0" : text;
    }
    /// The notes, each once.
    void collect_notes(print_style s, std::vector<std::string>& notes) const {
        for (auto const& t : terms_)
            for (auto const& first : {t.constants, t.weights, t.what})
                for (auto p = first.get(); p != nullptr; p = p->next.get()) {
                    add_note(p->before.note(s), notes);
                    add_note(p->after.note(s), notes);
                    if (p->inner) p->inner->collect_notes(s, notes);
                }
    }

private:
    static part made(written_part p) { return std::make_shared<written_part const>(std::move(p)); }
    static part before(part const& others, notation const& factor) { return made({kind::name, factor, {}, {}, others}); }
    static void add_note(std::string const& note, std::vector<std::string>& notes) {
        bool is_known = note.empty();
        for (auto const& known : notes) is_known = is_known or known == note;
        if (not is_known) notes.push_back(note);
    }
    static expression opened(written_term const& t) {
        expression e = t.what->inner->times(t.numerator, t.denominator);
        std::vector<written_part const*> constants;
        for (auto c = t.constants.get(); c != nullptr; c = c->next.get()) constants.push_back(c);
        for (; not constants.empty(); constants.pop_back()) e = e.times_constant(constants.back()->before);
        return e;
    }
    [[nodiscard]] expression enclosed(written_part around) const {
        expression e;
        if (terms_.empty()) return e; // operators map zero to zero
        auto inner = *this;
        auto& t = e.terms_.emplace_back();
        if (terms_.size() == 1) {
            t = {terms_[0].numerator, terms_[0].denominator, terms_[0].constants};
            inner.terms_[0] = {1, 1, {}, terms_[0].weights, terms_[0].what};
        }
        around.inner = std::make_shared<expression const>(std::move(inner));
        t.what = made(std::move(around));
        return e;
    }
    static void write(std::string& text, written_term const& t, print_style s, bool nothing_before) {
        bool const latex = s == print_style::latex;
        auto const length = text.size();
        std::string const n = std::to_string(t.numerator < 0 ? -t.numerator : t.numerator), d = std::to_string(t.denominator);
        if (t.denominator != 1)
            (((text += latex ? "\\tfrac{" : "") += n) += latex ? "}{" : "/") += d;
        else if (t.numerator != 1 and t.numerator != -1)
            text += n;
        if (text.size() != length) text += latex ? (t.denominator != 1 ? "}\\," : "\\,") : " ";
        for (auto const& first : {t.constants, t.weights})
            for (auto c = first.get(); c != nullptr; c = c->next.get()) (text += c->before.in(s)) += latex ? "\\," : " ";
        auto const& what = *t.what;
        bool const brackets = what.is == kind::signed_name ? not nothing_before or text.size() != length
                                                           : what.is == kind::marked and not may_be_marked(*what.inner, what.after);
        if (brackets) text += latex ? "\\left(" : "(";
        text += what.before.in(s);
        if (what.inner) text += what.inner->in(s);
        if (brackets) text += latex ? "\\right)" : ")";
        text += what.after.in(s);
    }
    /// Whether a mark on it needs no brackets.
    static bool may_be_marked(expression const& e, notation const& mark) {
        if (e.terms_.size() != 1 or not e.terms_[0].is_plain()) return false;
        auto const is = e.terms_[0].what->is;
        return is == kind::name or is == kind::marked or (mark.terminal[0] == '|' and is == kind::bracketed);
    }

    std::vector<written_term> terms_{};
};

} // namespace detail

} // namespace hilger
