// SPDX-License-Identifier: BSL-1.0
// Operators in mathematical notation: std::cout << Delta_plus * sigma, latex(adjoint(extend)). An operator is applied to the name of a
// function: sums, multiples and compositions are taken apart by their types, and an operator that equals a known one, up to a rational
// factor, is written as that one (recognition.hpp). So the printed operator is the one that runs.
//   sigma[f], rho[f]      f at the next, the previous point         Delta_+[f], Delta_-[f]     the differences
//   f_o                   the extension to T_o                      f|T, f|T_half              a function on T_o at those points
//   [f]_{1/2,-}           (f + rho f)/2 on T_half                   [f]_mu                     the mean with the steps as weights
//   pi[f]                 f at t_{i+1/2} as a value at t_i          iota[f]                    zero at the points f does not live on
// A subscript names the family: none on T, 1/2 on T_half, o on T_o, the number lambda on T_lambda.
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

/// A factor known at run time only, or its reciprocal.
template <class C>
std::string written_factor(C const& c) {
    if constexpr (requires { c.c; })
        return written_number(decltype(c.c)(1 / c.c));
    else
        return written_number(c);
}
/// A without such factors, so that it may be a known operator; `factors` takes them, from the outermost on.
template <class A>
auto without_factors(A const& a, std::vector<std::string>&) {
    return a;
}
template <class C, class A>
auto without_factors(multiple<C, A> const& a, std::vector<std::string>& factors);
template <class A, class B>
auto without_factors(composition<A, B> const& ab, std::vector<std::string>& factors) {
    auto const a = without_factors(ab.a, factors);
    return a * without_factors(ab.b, factors);
}
template <class C, class A>
auto without_factors(multiple<C, A> const& a, std::vector<std::string>& factors) {
    if constexpr (is_exact_factor<C>)
        return a.c * without_factors(a.a, factors);
    else {
        factors.push_back(written_factor(a.c));
        return without_factors(a.a, factors);
    }
}
inline expression times_factor(expression const& f, std::string const& c) {
    return f.times_constant({without_sign(c), without_sign(c)}).times(c.starts_with('-') ? -1 : 1, 1);
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
        return times_factor(inner, written_factor(a.c));
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

/// The operator on f; Uniform for a T with equal steps.
template <bool Uniform, class A>
expression write_operator(A const& a, expression const& f) {
    using bare = decltype(without_factors(a, std::declval<std::vector<std::string>&>()));
    if constexpr (known_by_type<bare> and not known_by_type<A>) {
        std::vector<std::string> factors;
        auto e = write_operator<Uniform>(without_factors(a, factors), f);
        for (auto c = factors.rbegin(); c != factors.rend(); ++c) e = times_factor(e, *c);
        return e;
    } else {
        if (auto const known = as_known<Uniform>(a, f)) return *known;
        if constexpr (is_made_of_others<A>)
            return written_parts<Uniform>(a, f);
        else if constexpr (requires { written_alone(a, f, Uniform); })
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

/// The operator applied to a function f, in Unicode for a terminal: Delta_plus * sigma is Δ₊[σ[f]].
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
