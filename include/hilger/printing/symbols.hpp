// SPDX-License-Identifier: BSL-1.0
// The notation of numbers, families of points, weights and domains, for a terminal and in LaTeX.
#pragma once

#include <iomanip>
#include <sstream>

#include "hilger/error.hpp"
#include "hilger/printing/expression.hpp"
#include "hilger/scale/weight.hpp"

namespace hilger::detail {

/// Digits that are read back as the number.
template <class C>
std::string written_number(C const& c) {
    if constexpr (std::integral<C>)
        return std::to_string(c);
    else if constexpr (std::floating_point<C>)
        return round_trip(c);
    else if constexpr (requires(std::ostream & out) { out << c; }) {
        std::ostringstream out;
        if constexpr (std::numeric_limits<C>::is_specialized and not std::numeric_limits<C>::is_exact)
            out << std::setprecision(std::numeric_limits<C>::max_digits10);
        out << c;
        return out.str();
    } else
        return "c";
}
/// 2.5 for -2.5: the sign of a term is written separately.
inline std::string without_sign(std::string const& number) { return number.substr(number.starts_with('-') ? 1 : 0); }

/// lambda as a fraction, or as a number where it is known at run time.
template <class Lambda>
notation written_lambda(Lambda const& lambda) {
    if constexpr (requires { Lambda::denominator; }) {
        static constexpr struct {
            int p, q;
            char const* sign;
        } signs[] = {{1, 2, "½"}, {1, 3, "⅓"}, {2, 3, "⅔"}, {1, 4, "¼"}, {3, 4, "¾"}, {1, 5, "⅕"}, {2, 5, "⅖"}, {3, 5, "⅗"},
                     {4, 5, "⅘"}, {1, 6, "⅙"}, {5, 6, "⅚"}, {1, 8, "⅛"}, {3, 8, "⅜"}, {5, 8, "⅝"}, {7, 8, "⅞"}};
        std::string const p = std::to_string(Lambda::numerator), q = std::to_string(Lambda::denominator);
        std::string plain = Lambda::denominator == 1 ? p : p + "/" + q;
        for (auto const& s : signs)
            if (s.p == Lambda::numerator and s.q == Lambda::denominator) plain = s.sign;
        return {plain, Lambda::denominator == 1 ? p : "\\frac{" + p + "}{" + q + "}"};
    } else {
        std::string const value = written_number(lambda.value);
        return {value, value};
    }
}

/// The subscript of sigma, Delta, ... on Base: none on T.
inline notation foot(nodes) { return {"", ""}; }
template <class Lambda>
notation foot(between<Lambda> const& base) {
    return written_lambda(base.lambda);
}
template <class Lambda>
notation foot(joined<Lambda> const& base) {
    if constexpr (std::same_as<Lambda, fraction<1, 2>>)
        return {"∘", "\\circ"};
    else {
        auto const l = written_lambda(base.lambda);
        return {"∘," + l.terminal, "\\circ," + l.latex};
    }
}
template <class Base>
    requires requires { Base::foot(); }
notation foot(Base const&) {
    std::string const at(Base::foot().text().view());
    return {at, at.substr(at.starts_with('_') ? 1 : 0)};
}
/// A letter with a foot, and +, - after it.
inline notation letter(char const* terminal, char const* latex, notation const& at, char const* sign_terminal = "",
                       char const* sign_latex = "") {
    std::string const feet = at.latex + (at.latex.empty() or *sign_latex == '\0' ? "" : ",") + sign_latex;
    return {std::string(terminal) + at.terminal + (at.terminal.empty() or *sign_terminal == '\0' ? "" : ",") + sign_terminal,
            std::string(latex) + (feet.empty() ? "" : "_{" + feet + "}")};
}
inline notation with_bracket(notation s) {
    s.terminal += "[";
    s.latex += "\\left[";
    return s;
}
inline notation closing(notation const& foot_of = {"", ""}) {
    return {"]" + foot_of.terminal, "\\right]" + (foot_of.latex.empty() ? "" : "_{" + foot_of.latex + "}")};
}

/// The weight p mu + r nu over s, with whole numbers p, r, s; mu and nu are the graininesses of the family Base.
struct linear_weight {
    int mu = 0, nu = 0, over = 1;
    char const* other = nullptr; ///< a weight with a name of its own
};
template <class W>
struct written_weight {
    static constexpr linear_weight value{0, 0, 1, "w"};
};
template <int P, int Q>
struct written_weight<mean_weight<fraction<P, Q>>> {
    static constexpr linear_weight value{Q - P, P, Q};
};
template <class W>
struct written_weight<continued_weight<W>> : written_weight<W> {};
template <>
struct written_weight<step_weight> {
    static constexpr linear_weight value{0, 0, 1, "h"};
};
template <>
struct written_weight<split_weight<mean_weight<fraction<1, 2>>>> { // the trapezoid rule of T_o
    static constexpr linear_weight value{1, 1, 2};
};
inline std::string in_letters(linear_weight const& w, std::string const& mu, std::string const& nu) {
    if (w.other != nullptr) return w.other;
    auto const part = [](int n, std::string const& x) { return n == 1 ? x : std::to_string(n) + x; };
    if (w.nu == 0) return part(w.mu, mu);
    if (w.mu == 0) return part(w.nu, nu);
    return part(w.mu, mu) + " + " + part(w.nu, nu);
}
/// w_From / w_To as a factor: (nu/mu).
inline notation ratio_of(linear_weight from, linear_weight to, notation const& at) {
    auto const in = [&](std::string const& mu, std::string const& nu, print_style s) {
        linear_weight a = from, b = to; // a.over divides the other one
        std::string const by = std::to_string(b.over), of = std::to_string(a.over);
        std::string above = in_letters(a, mu, nu), below = in_letters(b, mu, nu);
        auto const sum = [](std::string const& x) { return x.find('+') != std::string::npos; };
        auto const times = [&](std::string const& n, std::string const& x, bool alone) {
            if (n == "1") return sum(x) and not alone ? "(" + x + ")" : x;
            return n + (sum(x) ? "(" + x + ")" : s == print_style::latex ? " " + x : x);
        };
        if (s == print_style::latex) return "\\tfrac{" + times(by, above, true) + "}{" + times(of, below, true) + "}";
        std::string const denominator = times(of, below, false);
        return "(" + times(by, above, false) + "/" + (of == "1" or denominator.empty() ? denominator : "(" + denominator + ")") + ")";
    };
    auto const mu = letter("μ", "\\mu", at), nu = letter("ν", "\\nu", at);
    notation s{in(mu.terminal, nu.terminal, print_style::terminal), in(mu.latex, nu.latex, print_style::latex)};
    if ((from.other != nullptr and *from.other == 'w') or (to.other != nullptr and *to.other == 'w')) {
        s.terminal_note = "w = half the weight of T at its points, half the step between them";
        s.latex_note = "w \\text{ half the weight of } \\mathbb{T} \\text{ at its points, half the step between them}";
    }
    return s;
}

/// The name of a domain: T½⁻, T^{\pm}, ...
template <class Domain>
std::string written_domain(Domain const& d, print_style s) {
    notation const at = foot(d.base);
    std::string base = s == print_style::latex ? "\\mathbb{T}" + (at.latex.empty() ? "" : "_{" + at.latex + "}") : "T" + at.terminal;
    std::string marks;
    if (Domain::front == 1 and Domain::back == 1)
        marks = s == print_style::latex ? "\\pm" : "±";
    else {
        for (int k = 0; k < Domain::back; ++k) marks += s == print_style::latex ? "+" : "⁺";
        for (int k = 0; k < Domain::front; ++k) marks += s == print_style::latex ? "-" : "⁻";
    }
    return marks.empty() ? base : s == print_style::latex ? base + "^{" + marks + "}" : base + marks;
}

} // namespace hilger::detail
