// SPDX-License-Identifier: BSL-1.0
// The notation of each elementary operator around the name of a function, and of the means.
#pragma once

#include "hilger/operator/fractional.hpp"
#include "hilger/printing/recognition.hpp"
#include "hilger/printing/symbols.hpp"

namespace hilger {

namespace detail {

inline expression in_mean(expression const& f, notation const& foot_of, notation const& note = {}) {
    notation end = closing(foot_of);
    end.terminal_note = note.terminal;
    end.latex_note = note.latex;
    return f.in_brackets({"[", "\\left["}, end);
}
inline expression with_symbol(expression const& f, notation const& symbol) { return f.in_brackets(with_bracket(symbol), closing()); }
template <class Base>
notation delta_sign(Base const& base, side which) {
    return which == side::plus ? letter("Δ", "\\Delta", foot(base), "₊", "+") : letter("Δ", "\\Delta", foot(base), "₋", "-");
}
template <class Base>
notation shift_sign(Base const& base, side which) {
    return which == side::plus ? letter("σ", "\\sigma", foot(base)) : letter("ρ", "\\rho", foot(base));
}
inline expression extended(expression const& f, notation const& circle) { return f.marked({circle.terminal, "_{" + circle.latex + "}"}); }
/// f restricted to the points of Base. A function that was extended by zero from them is itself there; one from other points is zero.
template <class Base>
expression restricted_to_points(expression const& f, Base const& base) {
    if (std::string const bracket = f.bracket(); bracket.starts_with("ι"))
        return bracket == "ι" + foot(base).terminal + "[" ? f.without_brackets() : expression{};
    domain<Base> const here{base};
    return f.marked({"|" + written_domain(here, print_style::terminal), "|_{" + written_domain(here, print_style::latex) + "}"});
}
/// Halves are Cresson and Safi's (25); any other mean is explained.
template <class L>
notation mean_note(side which) {
    if constexpr (std::same_as<L, fraction<1, 2>>)
        return {};
    else {
        notation const l = written_lambda(L{}), rest = written_lambda(fraction<L::denominator - L::numerator, L::denominator>{});
        notation const shift_of = shift_sign(between<L>{}, which);
        bool const minus = which == side::minus;
        return {"[f]" + l.terminal + (minus ? ",₋ = " : ",₊ = ") + rest.terminal + " f + " + l.terminal + " " + shift_of.terminal + "[f]",
                "\\left[f\\right]_{" + l.latex + (minus ? ",-} = " : ",+} = ") + rest.latex + "f + " + l.latex + shift_of.latex +
                    "\\left[f\\right]"};
    }
}
/// (1 - lambda) f + lambda rho[f] on T_lambda, or with sigma.
template <class L>
expression mean_of_neighbours(expression const& f, side which) {
    notation const l = foot(between<L>{});
    bool const minus = which == side::minus;
    return in_mean(f, {l.terminal + (minus ? ",₋" : ",₊"), l.latex + (minus ? ",-" : ",+")}, mean_note<L>(which));
}
/// ((1 - lambda) mu f + lambda nu rho[f]) over their sum, on T_lambda.
template <class Lambda>
expression step_weighted_mean(expression const& f, Lambda const& lambda) {
    auto const l = written_lambda(lambda), at = foot(between<Lambda>{lambda});
    notation mean = closing({"μ", "\\mu"});
    if constexpr (std::same_as<Lambda, fraction<1, 2>>) {
        mean.terminal_note = "[f]μ = (μ f + ν ρ½[f])/(μ + ν)";
        mean.latex_note = "\\left[f\\right]_{\\mu} = \\tfrac{\\mu f + \\nu \\rho_{\\frac{1}{2}}[f]}{\\mu + \\nu}";
    } else {
        mean.terminal_note = "[f]μ = ((1 − " + l.terminal + ")μ f + " + l.terminal + "ν ρ" + at.terminal + "[f])/((1 − " + l.terminal +
                             ")μ + " + l.terminal + "ν)";
        mean.latex_note = "\\left[f\\right]_{\\mu} = \\tfrac{(1-" + l.latex + ")\\mu f + " + l.latex + "\\nu\\rho_{" + at.latex +
                          "}[f]}{(1-" + l.latex + ")\\mu + " + l.latex + "\\nu}";
    }
    return f.in_brackets({"[", "\\left["}, mean);
}

/// The notation of an elementary operator.
template <class Base, class From, class To>
expression written_alone(identity_on<Base, From, To> const&, expression const& f) {
    return f;
}
template <class Base, class From, class To>
expression written_alone(reweight<Base, From, To> const& a, expression const& f) {
    return f.times_weight(ratio_of(written_weight<From>::value, written_weight<To>::value, foot(base_of_argument(a))));
}
template <class Base, side Side>
expression written_alone(shift<Base, Side> const& a, expression const& f) {
    return with_symbol(f, shift_sign(base_of_argument(a), Side));
}
template <class Base, side Side>
expression written_alone(derivative<Base, Side> const& a, expression const& f) {
    return with_symbol(f, delta_sign(base_of_argument(a), Side));
}
template <class Lambda>
expression written_alone(extension<Lambda> const& a, expression const& f) {
    return extended(f, foot(joined<Lambda>{a.lambda}));
}
template <class Lambda, bool ToNodes>
expression written_alone(restriction_to<Lambda, ToNodes> const& a, expression const& f) {
    if constexpr (ToNodes)
        return restricted_to_points(f, nodes{});
    else
        return restricted_to_points(f, between<Lambda>{a.lambda});
}
template <class Lambda, bool ToNodes>
expression written_alone(insertion<Lambda, ToNodes> const& a, expression const& f) {
    notation const at = ToNodes ? notation{"", ""} : foot(between<Lambda>{a.lambda});
    notation iota = letter("ι", "\\iota", at);
    std::string const name = iota.terminal;
    iota = with_bracket(iota);
    iota.terminal_note = name + "[f] = f on T" + at.terminal + " and 0 between";
    iota.latex_note = "\\iota[f] = f \\text{ where it lives and } 0 \\text{ between}";
    return f.in_brackets(iota, closing());
}
template <class Lambda, bool Inverse>
expression written_alone(projection<Lambda, Inverse> const& a, expression const& f) {
    notation const at = std::same_as<Lambda, fraction<1, 2>> ? notation{"", ""} : foot(between<Lambda>{a.lambda});
    notation name = letter("π", "\\pi", at);
    if (Inverse) name = {name.terminal + "⁻¹", name.latex + "^{-1}"};
    return with_symbol(f, name);
}
template <class Lambda>
expression written_alone(step_mean_at<Lambda> const& a, expression const& f, bool equal_steps) {
    projection<Lambda, false> const on_nodes{{}, a.lambda};
    if constexpr (requires { Lambda::denominator; })
        return written_alone(on_nodes, step_weighted_mean(f, a.lambda));
    else { // in the sum with weights mu
        auto const l = written_lambda(a.lambda);
        auto const here = written_alone(on_nodes, f);
        auto const before = with_symbol(here, {"ρ", "\\rho"});
        return here.times_constant({"(1 − " + l.terminal + ")", "(1 - " + l.latex + ")"}) +
               (equal_steps ? before : before.times_weight({"(ν/μ)", "\\tfrac{\\nu}{\\mu}"})).times_constant(l);
    }
}
template <class Lambda>
expression written_alone(antiderivative_at<Lambda> const& a, expression const& f) {
    auto const at = foot(between<Lambda>{a.lambda});
    return f.in_brackets({"∫ₐᵗ(", "\\int_a^t\\left("}, {")Δ" + at.terminal, "\\right)\\Delta_{" + at.latex + "}"});
}
template <class Lambda>
expression written_alone(tail_integral_at<Lambda> const&, expression const& f) {
    return f.in_brackets({"∫ₜᵇ(", "\\int_t^b\\left("}, {")∇", "\\right)\\nabla"});
}
template <class Base, class W>
expression written_alone(from_start_on<Base, W> const&, expression const& f) {
    return f + f.marked({"(a)", "(a)"}).times(-1, 1);
}
/// The order of a fractional difference.
template <class Order>
std::string written_order(Order const& order) {
    if constexpr (requires { Order::denominator; })
        return std::to_string(Order::numerator) + (Order::denominator == 1 ? "" : "/" + std::to_string(Order::denominator));
    else
        return written_number(order.value);
}
template <class G, class Order, side Side, class W>
expression written_alone(fractional_difference<G, Order, Side, W> const& a, expression const& f) {
    std::string name(G::name().text().view());
    if (name.starts_with("bdf<")) name = "BDF" + name.substr(4, 1);
    bool const plain = name == "Delta", up = Side == side::plus;
    std::string const shown = written_order(a.order), order = shown.size() > 1 ? "(" + shown + ")" : shown;
    if (std::same_as<W, delta_weight>) { // (-Delta_+)^alpha, or its adjoint
        notation const power{"(−Δ₊)^" + order, "(-\\Delta_{+})^{" + shown + "}"};
        return with_symbol(f, up ? power : notation{"(" + power.terminal + ")*", "\\left(" + power.latex + "\\right)^{*}"});
    }
    return with_symbol(f, {(plain ? "Δ" : name) + (up ? "₊" : "₋") + "^" + order,
                           (plain ? std::string("\\Delta") : "\\mathrm{" + name + "}") + "_{" + (up ? "+" : "-") + "}^{" + shown + "}"});
}
/// A user's operator, by its name.
template <class A>
expression written_alone(A const&, expression const& f) {
    std::string const name(A::name().text().view());
    return with_symbol(f, {name, "\\mathrm{" + name + "}"});
}

} // namespace detail

} // namespace hilger
