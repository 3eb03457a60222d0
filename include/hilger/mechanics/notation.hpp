// SPDX-License-Identifier: BSL-1.0
// How operators are written, for a terminal and in LaTeX. An operator is recognised by what it does (==), not by how it was composed:
// whatever equals Delta_{1/2,-} is written as Delta_{1/2,-}.
#pragma once

#include <optional>
#include <string>

#include "hilger/adjoint/normal_form.hpp"
#include "hilger/operator/fractional.hpp"

namespace hilger {

enum class print_style { terminal, latex };

/// What stands before and after the argument.
struct notation {
    std::string before, after;
    bool negative = false;

    [[nodiscard]] std::string around(std::string const& argument) const { return before + argument + after; }
};

namespace detail {

inline notation brackets(print_style s, std::string const& terminal, std::string const& latex) {
    return s == print_style::latex ? notation{latex + "\\left[", "\\right]"} : notation{terminal + "[", "]"};
}
inline notation mean(print_style s, std::string const& terminal, std::string const& latex) {
    return s == print_style::latex ? notation{"\\left[", "\\right]_{" + latex + "}"} : notation{"[", "]" + terminal};
}

/// The first of the named operators that equals op or its negative. Named is a list of (operator, notation) pairs.
template <class Op>
std::optional<notation> recognise(Op const&, print_style) {
    return std::nullopt;
}
template <class Op, linear_map Named, class... Rest>
std::optional<notation> recognise(Op const& op, print_style s, Named const& named, notation const& written, Rest const&... rest) {
    if constexpr (requires { op == named; }) {
        if (op == named) return written;
        if (op == -named) return notation{written.before, written.after, true};
    }
    return recognise(op, s, rest...);
}

template <class Op>
struct from_of_ {
    using type = typename Op::from;
};
template <class A>
struct from_of_<on_uniform<A>> : from_of_<A> {};
template <class Op>
using from_of = typename from_of_<Op>::type;

template <class Op>
auto bare_name(Op const&) {
    return Op::name();
}
template <class A>
auto bare_name(on_uniform<A> const&) {
    return A::name();
}

/// An order as it is written: 1/2, or alpha where it is known at run time only.
template <class Order>
std::string written_order(Order const&, print_style s) {
    if constexpr (requires { Order::denominator; }) {
        std::string const p = std::to_string(Order::numerator);
        return Order::denominator == 1 ? p : p + "/" + std::to_string(Order::denominator);
    } else
        return s == print_style::latex ? "\\alpha" : "α";
}
template <class Op>
std::optional<notation> fractional_notation(Op const&, print_style) {
    return std::nullopt;
}
template <class G, class Order, side Side>
std::optional<notation> fractional_notation(fractional_difference<G, Order, Side> const& op, print_style s) {
    bool const latex = s == print_style::latex, plus = Side == side::plus;
    std::string const name(G::name().view()), order = written_order(op.order, s);
    std::string const letter = name == "Delta" ? (latex ? "\\Delta" : "Δ") : latex ? "\\mathrm{" + name + "}" : name;
    if (latex) return notation{letter + "_{" + (plus ? "+" : "-") + "}^{" + order + "}\\left[", "\\right]"};
    return notation{letter + (plus ? "₊" : "₋") + "^" + (order.size() > 2 ? "(" + order + ")" : order) + "[", "]"};
}

template <class A>
std::optional<notation> fractional_notation(on_uniform<A> const& op, print_style s) {
    return fractional_notation(op.op, s);
}
} // namespace detail

/// The notation of an operator, or its composition in words when it has no name of its own.
template <class Op>
notation notation_of(Op const& op, print_style s) {
    if (auto const fractional = detail::fractional_notation(op, s)) return *fractional;
    using half_ = fraction<1, 2>;
    using detail::brackets, detail::mean;
    std::optional<notation> found = detail::recognise(
        op, s, identity_T, notation{"", ""}, sigma, brackets(s, "σ", "\\sigma"), rho, brackets(s, "ρ", "\\rho"), Delta_plus,
        brackets(s, "Δ₊", "\\Delta_{+}"), Delta_minus, brackets(s, "Δ₋", "\\Delta_{-}"), Delta_h_minus,
        brackets(s, "Δ½,₋", "\\Delta_{\\frac12,-}"), Delta_h_plus, brackets(s, "Δ½,₊", "\\Delta_{\\frac12,+}"), mean_h_minus,
        mean(s, "½,₋", "\\frac12,-"), mean_h_plus, mean(s, "½,₊", "\\frac12,+"), pi_inverse * step_mean, mean(s, "μ", "\\mu"),
        pi_inverse * reweight<nodes, nabla_weight, mean_weight<half_>>{} * Delta_minus * pi_half,
        brackets(s, "Δ½,₋", "\\Delta_{\\frac12,-}"), reweight<nodes, nabla_weight, delta_weight>{} * Delta_minus,
        brackets(s, "(ν/μ) Δ₋", "\\tfrac{\\nu}{\\mu}\\Delta_{-}"), reweight<nodes, delta_weight, nabla_weight>{} * Delta_plus,
        brackets(s, "(μ/ν) Δ₊", "\\tfrac{\\mu}{\\nu}\\Delta_{+}"));
    // On T_lambda: the difference, and the mean with weights 1 - lambda and lambda.
    using from = detail::from_of<Op>;
    if constexpr (requires(from base) { base.lambda.numerator; }) {
        using L = std::remove_cvref_t<decltype(from{}.lambda)>;
        constexpr identity_on<from, delta_weight> here{};
        constexpr shift<from, side::minus> back{};
        if (not found)
            found = detail::recognise(op, s, derivative<from, side::minus>{}, brackets(s, "Δλ,₋", "\\Delta_{\\lambda,-}"),
                                      fraction<L::denominator - L::numerator, L::denominator>{} * here + L{} * back,
                                      mean(s, "λ,₋", "\\lambda,-"));
    }
    if (found) return *found;
    std::string const words(detail::bare_name(op).view());
    return s == print_style::latex ? notation{"\\mathrm{" + words + "}\\left[", "\\right]"} : notation{words + "[", "]"};
}

/// The name of a domain: T½⁻, T^{\pm}, ...
template <class Domain>
std::string written_domain(print_style s) {
    using Base = typename Domain::base_type;
    std::string base = s == print_style::latex ? "\\mathbb{T}" : "T";
    std::string const plus = s == print_style::latex ? "+" : "⁺", minus = s == print_style::latex ? "-" : "⁻";
    if constexpr (std::same_as<Base, between<fraction<1, 2>>>)
        base += s == print_style::latex ? "_{\\frac12}" : "½";
    else if constexpr (std::same_as<Base, joined<fraction<1, 2>>>)
        base += s == print_style::latex ? "_{\\circ}" : "∘";
    else if constexpr (requires(Base b) { b.lambda; })
        base += s == print_style::latex ? "_{\\lambda}" : "λ";
    std::string marks;
    if (Domain::front == 1 and Domain::back == 1)
        marks = s == print_style::latex ? "\\pm" : "±";
    else {
        for (int k = 0; k < Domain::back; ++k) marks += plus;
        for (int k = 0; k < Domain::front; ++k) marks += minus;
    }
    return marks.empty() ? base : s == print_style::latex ? base + "^{" + marks + "}" : base + marks;
}

} // namespace hilger
