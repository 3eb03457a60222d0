// SPDX-License-Identifier: BSL-1.0
// Operators as mathematics writes them and as text that can be read back. An operator that equals sigma, Delta_plus, ... up to a rational
// factor is written as that one (printing/notation.hpp).
#include "hilger/error.hpp"
#include "hilger/printing/words.hpp"
#include "hilger/text/embedding.hpp"
#include "text/operator_in_numbers.hpp"

namespace hilger::text {

namespace printed = hilger::detail;

namespace {

/// c with a = c b; nothing unless both are rational and lose the same points.
std::optional<Q> ratio(operator_formula const& a, operator_formula const& b, bool uniform) {
    if (not(a.lost() == b.lost())) return {};
    auto const x = detail::exact_row_of(a, uniform, a.lost()), y = detail::exact_row_of(b, uniform, a.lost());
    if (not x or not y) return {};
    std::size_t k = 0;
    while (k < y->size() and (*y)[k] == 0) ++k;
    if (k == y->size()) return {};
    Q const c = (*x)[k] / (*y)[k];
    for (std::size_t j = 0; j < x->size(); ++j)
        if ((*x)[j] != c * (*y)[j]) return {};
    return c == 0 ? std::nullopt : std::optional(c);
}
/// c f, when c is a quotient of short numbers.
std::optional<printed::expression> times(printed::expression const& f, Q const& c) {
    Q const longest = 100'000;
    if (abs(numerator(c)) > longest or denominator(c) > longest) return {};
    return f.times(static_cast<long long>(numerator(c)), static_cast<long long>(denominator(c)));
}
printed::linear_weight letter_of(sum_weight w) {
    return w == sum_weight::delta ? printed::linear_weight{1, 0, 1} : printed::linear_weight{0, 1, 1};
}

printed::expression written_parts(operator_formula const& a, printed::expression const& f, bool uniform) {
    using kind = operator_formula::kind;
    auto const& n = a.root();
    auto const part = [&](std::size_t k, printed::expression const& g) { return detail::written_on(n.parts[k], g, uniform); };
    switch (n.what) {
    case kind::identity:
        return f;
    case kind::shift:
        return printed::with_symbol(f, printed::shift_sign(nodes{}, n.which));
    case kind::derivative:
        return printed::with_symbol(f, printed::delta_sign(nodes{}, n.which));
    case kind::reweight:
        return uniform ? f : f.times_weight(printed::ratio_of(letter_of(n.from), letter_of(n.to), printed::foot(nodes{})));
    case kind::multiple: {
        auto const inner = part(0, f);
        try {
            if (auto const e = times(inner, n.factor->number<Q>())) return *e;
        } catch (error::unreadable const&) { // an irrational number
        }
        std::string const c = written(n.factor->formula(), 80).value_or("c");
        return inner.times_constant({"(" + c + ")", "\\left(\\mathtt{" + c + "}\\right)"});
    }
    case kind::sum:
        return part(0, f) + part(1, f);
    case kind::product:
        return part(0, part(1, f));
    }
    return f;
}

/// The formula that operator_in and embedding_in read: (q + sigma[q])/2.
expression formula_of(operator_formula const& a, expression const& on) {
    using kind = operator_formula::kind;
    auto const& n = a.root();
    bool const plus = n.which == side::plus, bare = on.root().what == text::kind::name and on.root().name.empty();
    auto const named = [&](char const* name) { return bare ? expression::variable(name) : expression::element(name, on); };
    switch (n.what) {
    case kind::identity:
        return bare ? expression::variable("identity") : on;
    case kind::shift:
        return named(plus ? "sigma" : "rho");
    case kind::derivative:
        return named(plus ? "Delta_plus" : "Delta_minus");
    case kind::reweight:
        return named(n.from == sum_weight::delta ? "mu_over_nu" : "nu_over_mu");
    case kind::multiple: {
        auto const& c = n.factor->formula();
        auto const part = formula_of(n.parts[0], on);
        if (c.root().what == text::kind::negative and c.root().parts[0]->name == "1") return -part;
        return c.root().what == text::kind::over and c.root().parts[0]->name == "1" ? part / expression(c.root().parts[1]) : c * part;
    }
    case kind::sum: {
        auto const first = formula_of(n.parts[0], on), second = formula_of(n.parts[1], on);
        return second.root().what == text::kind::negative ? first - expression(second.root().parts[0]) : first + second;
    }
    case kind::product: // Brackets of a sum do not act: (A + B)[f] is A[f] + B[f].
        return formula_of(n.parts[0], formula_of(n.parts[1], on));
    }
    return on;
}

} // namespace

printed::expression detail::written_on(operator_formula const& a, printed::expression const& f, bool uniform) {
    for (side const s : {side::plus, side::minus})
        for (auto const& known : {operator_formula::shift(s), operator_formula::derivative(s)})
            if (auto const c = ratio(a, known, uniform))
                if (auto const e = times(written_parts(known, f, uniform), *c)) return *e;
    if (auto const c = ratio(a, {}, uniform))
        if (auto const e = times(f, *c)) return *e;
    return written_parts(a, f, uniform);
}

std::string written(operator_formula const& a, print_style style, bool uniform) {
    auto const e = detail::written_on(a, hilger::detail::expression::name({"f", "f"}), uniform);
    std::vector<std::string> notes;
    e.collect_notes(style, notes);
    std::string text = e.in(style);
    for (auto const& note : notes) text += (style == print_style::latex ? ", \\quad " : ",   ") + note;
    return text;
}
std::optional<std::string> written(operator_formula const& a, std::string const& on, std::size_t longest) {
    return written(formula_of(a, expression::variable(on)), longest);
}
std::string text_of(operator_formula const& a, std::string const& on) {
    constexpr std::size_t longest = 10'000;
    if (auto text = written(a, on, longest)) return *std::move(text);
    error::raise<error::invalid_parameter>("an operator in text has at most ", longest, " characters, and this one has more");
}

} // namespace hilger::text
