// SPDX-License-Identifier: BSL-1.0
// A linear expression as it is written: a sum of terms, each with a rational factor, constants, weights that depend on t, and what they
// multiply. One expression has two spellings, for a terminal and for LaTeX, so that both name the same operators.
#pragma once

#include <algorithm>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

namespace hilger {

enum class print_style { terminal, latex };

/// How something is written, and what a reader has to be told about it ("" when nothing).
struct spelled {
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

/// What a term multiplies: a name, or an expression between two texts.
struct written_node {
    enum class kind {
        name,        ///< q
        signed_name, ///< -dH/dq(p, q), in brackets when something stands before it
        bracketed,   ///< before inner after, where before and after enclose: Delta_+[ inner ]
        marked       ///< inner after: q_o, and (inner) after where inner is longer than a name
    };
    kind is = kind::name;
    spelled before{}, after{};
    std::shared_ptr<expression const> inner{}; ///< none in a name
};

struct written_term {
    long long numerator = 1, denominator = 1;
    std::vector<spelled> constants{}; ///< numbers known at run time only, and symbols of constants
    std::vector<spelled> weights{};   ///< functions of t
    written_node what{};

    [[nodiscard]] bool is_plain() const { return numerator == 1 and denominator == 1 and constants.empty() and weights.empty(); }
};

class expression {
public:
    std::vector<written_term> terms{};

    static expression name(spelled as, bool has_sign = false) {
        written_term t;
        t.what.is = has_sign ? written_node::kind::signed_name : written_node::kind::name;
        t.what.before = std::move(as);
        return {{std::move(t)}};
    }
    [[nodiscard]] bool is_name() const {
        return terms.size() == 1 and terms[0].is_plain() and terms[0].what.is == written_node::kind::name;
    }

    [[nodiscard]] expression times(long long numerator, long long denominator) const {
        expression e = *this;
        for (auto& t : e.terms) {
            long long above = 0, below = 0;
            if (__builtin_mul_overflow(t.numerator, numerator, &above) or __builtin_mul_overflow(t.denominator, denominator, &below)) {
                std::string const text = std::to_string(numerator) + (denominator == 1 ? "" : "/" + std::to_string(denominator));
                t.constants.insert(t.constants.begin(), {text, text});
                continue;
            }
            t.numerator = above;
            t.denominator = below;
            long long const g = std::max(std::gcd(t.numerator, t.denominator), 1LL);
            t.numerator /= g;
            t.denominator /= g;
        }
        return e;
    }
    [[nodiscard]] expression times_constant(spelled const& c) const {
        expression e = *this;
        for (auto& t : e.terms) t.constants.insert(t.constants.begin(), c);
        return e;
    }
    [[nodiscard]] expression times_weight(spelled const& w) const {
        expression e = *this;
        for (auto& t : e.terms) t.weights.insert(t.weights.begin(), w);
        return e;
    }
    friend expression operator+(expression a, expression const& b) {
        a.terms.insert(a.terms.end(), b.terms.begin(), b.terms.end());
        return a;
    }
    /// before[this]after; the constants of a single term stand before it all.
    [[nodiscard]] expression in_brackets(spelled before, spelled after) const {
        return enclosed({written_node::kind::bracketed, std::move(before), std::move(after), {}});
    }
    [[nodiscard]] expression marked(spelled mark) const { return enclosed({written_node::kind::marked, {}, std::move(mark), {}}); }
    /// Without what stands around a single term.
    [[nodiscard]] expression without_brackets() const {
        expression e = terms[0].what.inner->times(terms[0].numerator, terms[0].denominator);
        for (auto c = terms[0].constants.rbegin(); c != terms[0].constants.rend(); ++c) e = e.times_constant(*c);
        return e;
    }
    /// Without the mark `mark` on whole terms: where the text says by itself which points are meant.
    [[nodiscard]] expression without(std::string const& mark) const {
        expression e;
        for (auto const& t : terms) {
            bool const marked_term = t.what.is == written_node::kind::marked and t.what.after.terminal == mark and t.weights.empty();
            expression const one(std::vector<written_term>{t});
            e = e + (marked_term ? one.without_brackets() : one);
        }
        return e;
    }

    [[nodiscard]] std::string in(print_style s) const {
        std::string text;
        for (auto const& t : terms) {
            bool const first = text.empty(), negative = t.numerator < 0;
            if (s == print_style::latex)
                text += first ? (negative ? "-" : "") : (negative ? " - " : " + ");
            else
                text += first ? (negative ? "−" : "") : (negative ? " − " : " + ");
            text += written(t, s, first and not negative);
        }
        return text.empty() ? "0" : text;
    }
    /// What the reader has to be told, each once.
    void collect_notes(print_style s, std::vector<std::string>& notes) const {
        auto const add = [&](spelled const& what) {
            if (auto const& note = what.note(s); not note.empty() and std::find(notes.begin(), notes.end(), note) == notes.end())
                notes.push_back(note);
        };
        for (auto const& t : terms) {
            for (auto const& c : t.constants) add(c);
            for (auto const& w : t.weights) add(w);
            add(t.what.before);
            add(t.what.after);
            if (t.what.inner) t.what.inner->collect_notes(s, notes);
        }
    }

    expression() = default;
    expression(std::vector<written_term> all) : terms(std::move(all)) {}

private:
    [[nodiscard]] expression enclosed(written_node node) const {
        if (terms.empty()) return {}; // an operator makes zero of zero
        written_term t;
        expression inner = *this;
        if (terms.size() == 1) {
            t.numerator = terms[0].numerator;
            t.denominator = terms[0].denominator;
            t.constants = terms[0].constants;
            inner.terms[0].numerator = inner.terms[0].denominator = 1;
            inner.terms[0].constants.clear();
        }
        node.inner = std::make_shared<expression const>(std::move(inner));
        t.what = std::move(node);
        return {{std::move(t)}};
    }
    static std::string written(written_term const& t, print_style s, bool nothing_before) {
        long long const n = t.numerator < 0 ? -t.numerator : t.numerator;
        std::string text;
        std::string const space = s == print_style::latex ? "\\," : " ";
        if (t.denominator != 1)
            text += s == print_style::latex ? "\\tfrac{" + std::to_string(n) + "}{" + std::to_string(t.denominator) + "}" + space
                                            : std::to_string(n) + "/" + std::to_string(t.denominator) + " ";
        else if (n != 1)
            text += std::to_string(n) + space;
        for (auto const& c : t.constants) text += c.in(s) + space;
        for (auto const& w : t.weights) text += w.in(s) + space;
        using kind = written_node::kind;
        switch (t.what.is) {
        case kind::name:
            return text + t.what.before.in(s);
        case kind::signed_name:
            return nothing_before and text.empty() ? t.what.before.in(s)
                                                   : text + (s == print_style::latex ? "\\left(" : "(") + t.what.before.in(s) +
                                                         (s == print_style::latex ? "\\right)" : ")");
        case kind::bracketed:
            return text + t.what.before.in(s) + t.what.inner->in(s) + t.what.after.in(s);
        case kind::marked: {
            auto const& inner = *t.what.inner;
            std::string const body = inner.in(s);
            bool const bare = inner.terms.size() == 1 and inner.terms[0].is_plain() and
                              (inner.is_name() or inner.terms[0].what.is == kind::marked or
                               (t.what.after.terminal[0] == '|' and inner.terms[0].what.is == kind::bracketed));
            if (bare) return text + body + t.what.after.in(s);
            return text + (s == print_style::latex ? "\\left(" : "(") + body + (s == print_style::latex ? "\\right)" : ")") +
                   t.what.after.in(s);
        }
        }
        return text;
    }
};

} // namespace detail

} // namespace hilger
