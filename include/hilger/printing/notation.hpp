// SPDX-License-Identifier: BSL-1.0
// Operators as mathematics writes them: std::cout << Delta_plus * sigma, latex(adjoint(extend)). An operator is run on the name of a
// function: sums, multiples and compositions are taken apart as their types say, and what equals a known operator, up to a rational factor,
// is written as that one (recognition.hpp). So what is written is what runs.
//   sigma[f], rho[f]      f at the next, the previous point         Delta_+[f], Delta_-[f]     the differences
//   f_o                   the extension to T_o                      f|T, f|T_half              a function on T_o at those points
//   [f]_{1/2,-}           (f + rho f)/2 on T_half                   [f]_mu                     the mean with the steps as weights
//   pi[f]                 f at t_{i+1/2} as a value at t_i          iota[f]                    zero at the points f does not live on
// A foot says on which family: none on T, 1/2 on T_half, o on T_o, the number lambda on T_lambda.
#pragma once

#include <ostream>

#include "hilger/printing/known_operators.hpp"

namespace hilger {

namespace detail {

template <class A>
struct on_uniform_of {
    static constexpr bool uniform = A::needs_uniform;
    static A const& get(A const& a) { return a; }
};
template <class A>
struct on_uniform_of<on_uniform<A>> {
    static constexpr bool uniform = true;
    static A const& get(on_uniform<A> const& a) { return a.op; }
};

template <bool Uniform, class A>
expression write_operator(A const& a, expression const& f);

/// The numbers of compositions and multiples that are known at run time only.
template <class A>
expression with_numbers(A const&, expression const& f) {
    return f;
}
template <class C, class A>
expression with_numbers(multiple<C, A> const& a, expression const& f);
template <class A, class B>
expression with_numbers(composition<A, B> const& ab, expression const& f) {
    return with_numbers(ab.a, with_numbers(ab.b, f));
}
template <class C, class A>
expression with_numbers(multiple<C, A> const& a, expression const& f) {
    auto const inner = with_numbers(a.a, f);
    if constexpr (is_exact_factor<C>)
        return inner;
    else {
        std::string c;
        if constexpr (requires { a.c.c; }) // one over a number
            c = written_number(decltype(a.c.c)(1 / a.c.c));
        else
            c = written_number(a.c);
        return inner.times_constant({without_sign(c), without_sign(c)}).times(c.starts_with('-') ? -1 : 1, 1);
    }
}

/// n f, or f/n `over` n.
template <std::integral N>
expression times_whole(expression const& f, N n, bool over) {
    if (not std::in_range<long long>(n) or n == std::numeric_limits<N>::min()) { // has no opposite in long long
        std::string const text = (over ? "1/" : "") + std::to_string(n);
        return n == 0 ? f.times(0, 1) : f.times_constant({text, text});
    }
    auto const whole = static_cast<long long>(n);
    return over ? f.times(whole < 0 ? -1 : 1, whole < 0 ? -whole : whole) : f.times(whole, 1);
}

template <bool Uniform, class C, class A>
expression written_parts(multiple<C, A> const& a, expression const& f) {
    auto const inner = write_operator<Uniform>(a.a, f);
    if constexpr (requires { C::denominator; })
        return inner.times(C::numerator, C::denominator);
    else if constexpr (std::integral<C>)
        return times_whole(inner, a.c, false);
    else if constexpr (is_exact_factor<C>)
        return times_whole(inner, a.c.c, true);
    else
        return with_numbers(multiple<C, identity_on<typename A::to, typename A::to_weight>>(a.c, {}), inner);
}
template <bool Uniform, class A, class B>
expression written_parts(operator_sum<A, B> const& a, expression const& f) {
    return write_operator<Uniform>(a.a, f) + write_operator<Uniform>(a.b, f);
}
template <bool Uniform, class A, class B>
expression written_parts(composition<A, B> const& a, expression const& f) {
    return write_operator<Uniform>(a.a, write_operator<Uniform>(a.b, f));
}
template <bool Uniform, class A>
expression written_parts(A const& a, expression const& f) {
    return written_alone(a, f);
}
template <class A>
inline constexpr bool is_made_of_others = false;
template <class C, class A>
inline constexpr bool is_made_of_others<multiple<C, A>> = true;
template <class A, class B>
inline constexpr bool is_made_of_others<composition<A, B>> = true;
template <class A, class B>
inline constexpr bool is_made_of_others<operator_sum<A, B>> = true;

/// A sum of shifts of f.
template <class A>
std::optional<expression> written_shifts(A const& a, expression const& f) {
    if constexpr (has_residues<A>)
        if (auto const terms = as_shifts(a)) {
            auto const base = base_of_argument(a);
            static char const* const powers[] = {"⁻⁴", "⁻³", "⁻²", "⁻¹", "", "", "²", "³", "⁴"};
            expression sum;
            for (auto const& t : *terms) {
                expression e = f;
                for (int k = 0; k < t.offset; ++k) e = with_symbol(e, shift_sign(base, side::plus));
                for (int k = 0; k < -t.offset; ++k) e = with_symbol(e, shift_sign(base, side::minus));
                if (t.power != 0)
                    e = e.times_constant(
                        {std::string("h") + powers[t.power + 4], t.power == 1 ? "h" : "h^{" + std::to_string(t.power) + "}"});
                sum = sum + e.times(t.factor.numerator, t.factor.denominator);
            }
            return sum;
        }
    return std::nullopt;
}

/// The operator on f; Uniform says that T has equal steps.
template <bool Uniform, class A>
expression write_operator(A const& a, expression const& f) {
    if constexpr (is_made_of_others<A> and not known_by_type<A> and known_by_type<decltype(without_numbers(a))>) {
        return with_numbers(a, write_operator<Uniform>(without_numbers(a), f));
    } else if constexpr (is_made_of_others<A>) {
        if (auto const known = as_known<Uniform>(a, f)) return *known;
        auto const parts = written_parts<Uniform>(a, f);
        if constexpr (Uniform)
            if (parts.is_awkward())
                if (auto const shifts = written_shifts(a, f)) return *shifts;
        return parts;
    } else {
        if (auto const known = as_known<Uniform>(a, f)) return *known;
        if constexpr (requires { written_alone(a, f, Uniform); })
            return written_alone(a, f, Uniform);
        else
            return written_alone(a, f);
    }
}
template <class Op>
expression written_on(Op const& op, expression const& f) {
    using on = on_uniform_of<Op>;
    return write_operator<on::uniform>(on::get(op), f);
}
/// An expression and its notes in one line.
inline std::string with_notes(expression const& e, print_style s) {
    std::vector<std::string> notes;
    e.collect_notes(s, notes);
    std::string text = e.in(s);
    for (auto const& note : notes) text += (s == print_style::latex ? ", \\quad " : ",   ") + note;
    return text;
}

template <class Op>
concept writable_operator = linear_map<Op> or requires(Op const& a) {
    [](on_uniform<std::remove_cvref_t<decltype(a.op)>> const&) {}(a);
};

} // namespace detail

/// What the operator makes of a function f, written for a terminal: Delta_plus * sigma is Δ₊[σ[f]].
template <detail::writable_operator Op>
std::ostream& operator<<(std::ostream& out, Op const& op) {
    return out << detail::with_notes(detail::written_on(op, detail::expression::name({"f", "f"})), print_style::terminal);
}
/// The same in LaTeX: \Delta_{+}\left[\sigma\left[f\right]\right].
template <detail::writable_operator Op>
std::string latex(Op const& op) {
    return detail::with_notes(detail::written_on(op, detail::expression::name({"f", "f"})), print_style::latex);
}

} // namespace hilger
