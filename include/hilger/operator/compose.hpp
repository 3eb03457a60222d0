// SPDX-License-Identifier: BSL-1.0
// Identity, multiples, sums and compositions of operators. The adjoint of a composition is the composition of the adjoints in
// reverse order, and of a sum the sum: integration by parts for anything a user composes follows from this file.
#pragma once

#include "hilger/error.hpp"
#include "hilger/function/pointwise.hpp"
#include "hilger/operator/concept.hpp"
#include "hilger/scale/weight.hpp"

namespace hilger {

template <class Base, class To, class From>
struct reweight;

/// f as itself. With two different weights it is the identity between two sums, whose adjoint multiplies by their ratio.
template <class Base, class From, class To = From>
struct identity_on : linear_operator<identity_on<Base, From, To>> {
    using from = Base;
    using to = Base;
    using from_weight = From;
    using to_weight = To;
    static constexpr reach reads = reach::local(0, 0).at<Base>();
    static constexpr auto name() { return fixed_text("identity_T"); }
    template <class D>
    constexpr D image(D const& d) const {
        return d;
    }
    template <class F>
    constexpr decltype(auto) evaluate(F const& f, index_type i) const {
        return f.get(i);
    }
    constexpr auto adjoint() const {
        if constexpr (std::same_as<From, To>)
            return *this;
        else
            return reweight<Base, To, From>{};
    }
};

/// f times the ratio of two weights, w_From / w_To: it carries an equation from the sum with weights w_From to the one with w_To. On a
/// uniform scale it is the identity at every inner point.
template <class Base, class From, class To>
struct reweight : linear_operator<reweight<Base, From, To>> {
    using from = Base;
    using to = Base;
    using from_weight = From;
    using to_weight = To;
    static constexpr reach reads = reach::local(1, 1).at<Base>(); ///< of the steps at both sides, whose lengths are in the weights
    static constexpr auto name() { return fixed_text("reweight<") + From::name() + "," + To::name() + ">"; }
    template <int F, int B>
    constexpr auto image(domain<Base, F, B> const& d) const { // where w_To vanishes there is no ratio
        return domain<Base, std::max(F, To::vanishes_first ? 1 : 0), std::max(B, To::vanishes_last ? 1 : 0)>{d.base};
    }
    template <class F>
    constexpr auto evaluate(F const& f, index_type i) const {
        return evaluated(f.get(i) * (weight_at<From>(f, i) / weight_at<To>(f, i)));
    }
    constexpr auto adjoint() const { return identity_on<Base, To, From>{}; }
};

namespace detail {
/// 1/c, in the scalar of the function that it multiplies. @throws error::invalid_parameter for c = 0
template <class C>
struct one_over {
    C c;

    constexpr explicit one_over(C divisor) : c(std::move(divisor)) {
        if (c == C(0)) error::raise<error::invalid_parameter>("an operator is divided by 0");
    }
    template <class S>
    constexpr S as() const {
        return S(S(1) / as_factor<C, S>(c));
    }
    friend constexpr bool operator==(one_over const&, one_over const&) = default;
};
/// True when c, or its reciprocal, is a whole number or a fraction.
template <class C>
inline constexpr bool is_exact_factor = std::is_empty_v<C> or std::is_integral_v<C>;
template <class C>
inline constexpr bool is_exact_factor<one_over<C>> = is_exact_factor<C>;
} // namespace detail

/// c A, with c a number or a fraction.
template <class C, linear_map A>
struct multiple : linear_operator<multiple<C, A>> {
    using from = typename A::from;
    using to = typename A::to;
    using from_weight = typename A::from_weight;
    using to_weight = typename A::to_weight;
    static constexpr bool needs_uniform = A::needs_uniform;
    static constexpr reach reads = A::reads;
    [[no_unique_address]] C c;
    [[no_unique_address]] A a;
    constexpr multiple() = default;
    constexpr multiple(C constant, A op) : c(std::move(constant)), a(std::move(op)) {}

    static constexpr auto name() { return factor_name() + A::name(); }
    template <class D>
    constexpr auto image(D const& d) const {
        return a.image(d);
    }
    template <class F>
    constexpr auto evaluate(F const& f, index_type i) const {
        if constexpr (std::same_as<C, fraction<-1>>)
            return evaluated(-a.evaluate(f, i));
        else
            return evaluated(a.evaluate(f, i) * as_factor<C, typename F::root_type::scalar_type>(c));
    }
    template <class P, class Q>
    constexpr auto adjoint_of_terms() const {
        return c * adjoint_between<P, Q>(a);
    }
    constexpr auto adjoint() const { return multiple<C, decltype(a.adjoint())>(c, a.adjoint()); }

private:
    static constexpr auto factor_name() {
        if constexpr (not requires { C::denominator; })
            return fixed_text("c ");
        else if constexpr (C::numerator < 0)
            return "-" + multiple<fraction<-C::numerator, C::denominator>, A>::factor_name();
        else if constexpr (C::denominator > 1)
            return digits<C::numerator>() + "/" + digits<C::denominator>() + " ";
        else if constexpr (C::numerator != 1)
            return digits<C::numerator>() + " ";
        else
            return fixed_text("");
    }
    template <class D, linear_map B>
    friend struct multiple;
};

/// A B: first B, then A.
template <class A, class B>
struct composition : linear_operator<composition<A, B>> {
    using from = typename B::from;
    using to = typename A::to;
    using from_weight = typename B::from_weight;
    using to_weight = typename A::to_weight;
    static constexpr bool needs_uniform = A::needs_uniform or B::needs_uniform;
    [[no_unique_address]] A a;
    [[no_unique_address]] B b;
    static constexpr reach reads = reach::composed<typename A::from>(A::reads, B::reads);
    constexpr composition() = default;
    constexpr composition(A outer, B inner) : a(std::move(outer)), b(std::move(inner)) {}

    static constexpr auto name() { return A::name() + "[" + B::name() + "]"; }
    template <class D>
    constexpr auto image(D const& d) const {
        return a.image(b.image(d));
    }
    template <class F>
    constexpr auto evaluate(F const& f, index_type i) const {
        applied<B, detail::borrowed<F>> const inner(b, detail::borrowed<F>(f));
        return a.evaluate(inner, i);
    }
    template <class F, class Use>
    constexpr void evaluate_all(F const& f, Use const& use) const requires detail::in_order<A, applied<B, detail::borrowed<F>>, Use> {
        a.evaluate_all(applied<B, detail::borrowed<F>>(b, detail::borrowed<F>(f)), use);
    }
    constexpr auto adjoint() const {
        if constexpr (std::same_as<typename A::from_weight, typename B::to_weight>)
            return b.adjoint() * a.adjoint();
        else
            return b.adjoint() * reweight<typename A::from, typename A::from_weight, typename B::to_weight>{} * a.adjoint();
    }
};

/// A + B on the points where both are defined.
template <linear_map A, linear_map B>
struct operator_sum : linear_operator<operator_sum<A, B>> {
    using from = typename A::from;
    using to = typename A::to;
    using from_weight = typename A::from_weight;
    using to_weight = typename A::to_weight;
    static constexpr bool needs_uniform = A::needs_uniform or B::needs_uniform;
    [[no_unique_address]] A a;
    [[no_unique_address]] B b;
    static constexpr reach reads = A::reads | B::reads;
    constexpr operator_sum() = default;
    constexpr operator_sum(A first, B second) : a(std::move(first)), b(std::move(second)) {}

    static constexpr auto name() { return "(" + A::name() + " + " + B::name() + ")"; }
    template <class D>
    constexpr auto image(D const& d) const {
        return intersect(a.image(d), b.image(d));
    }
    template <class F>
    constexpr auto evaluate(F const& f, index_type i) const {
        return evaluated(a.evaluate(f, i) + b.evaluate(f, i));
    }
    template <class P, class Q>
    constexpr auto adjoint_of_terms() const {
        return adjoint_between<P, Q>(a) + adjoint_between<P, Q>(b);
    }
    constexpr auto adjoint() const { return adjoint_of_terms<from_weight, to_weight>(); }
};

/// The adjoint of A between the sums with weights P (on A's from) and Q (on A's to), whatever A's own weights are. For sums it is taken
/// term by term: otherwise a ratio of weights and its inverse would lose the end at which a weight vanishes.
template <class P, class Q, linear_map A>
constexpr auto adjoint_between(A const& a) {
    using Ap = typename A::from_weight;
    using Aq = typename A::to_weight;
    auto const outer = [](auto op) {
        if constexpr (std::same_as<Ap, P>)
            return op;
        else
            return reweight<typename A::from, Ap, P>{} * op;
    };
    if constexpr (requires { a.template adjoint_of_terms<P, Q>(); })
        return a.template adjoint_of_terms<P, Q>();
    else if constexpr (std::same_as<Aq, Q>)
        return outer(a.adjoint());
    else
        return outer(a.adjoint() * reweight<typename A::to, Q, Aq>{});
}

namespace detail {
template <class A, class From, class B, class To>
constexpr auto do_not_meet() {
    return does_not_compile<A::name() + " acts on functions on " + From::name() + ", and " + B::name() + " makes functions on " +
                            To::name()>{};
}
template <class A, class From, class B, class Other>
constexpr auto act_on_two() {
    return does_not_compile<"a sum of operators needs one scale to act on, and " + A::name() + " acts on " + From::name() + ", " +
                            B::name() + " on " + Other::name()>{};
}
template <class A, class To, class B, class Other>
constexpr auto map_to_two() {
    return does_not_compile<"a sum of operators needs one scale to map to, and " + A::name() + " maps to " + To::name() + ", " + B::name() +
                            " to " + Other::name()>{};
}
} // namespace detail

/// A B, A + B, A - B, -A and c A; operators whose scales do not meet do not compile.
template <linear_map A, linear_map B>
constexpr auto operator*(A a, B b) {
    if constexpr (composes_with<A, B>)
        return composition<A, B>(std::move(a), std::move(b));
    else
        return detail::do_not_meet<A, typename A::from, B, typename B::to>();
}
template <linear_map A, linear_map B>
constexpr auto operator+(A a, B b) {
    if constexpr (not std::same_as<typename A::from, typename B::from>)
        return detail::act_on_two<A, typename A::from, B, typename B::from>();
    else if constexpr (not std::same_as<typename A::to, typename B::to>)
        return detail::map_to_two<A, typename A::to, B, typename B::to>();
    else
        return operator_sum<A, B>(std::move(a), std::move(b));
}
template <linear_map A>
constexpr auto operator-(A a) {
    return multiple<fraction<-1>, A>({}, std::move(a));
}
template <linear_map A, linear_map B>
constexpr auto operator-(A a, B b) {
    return std::move(a) + -std::move(b);
}
template <factor C, linear_map A>
constexpr auto operator*(C c, A a) {
    return multiple<C, A>(std::move(c), std::move(a));
}
template <linear_map A, factor C>
constexpr auto operator*(A a, C c) {
    return multiple<C, A>(std::move(c), std::move(a));
}
/// A / c. @throws error::invalid_parameter for c = 0
template <linear_map A, factor C>
constexpr auto operator/(A a, C c) {
    if constexpr (requires { C::denominator; }) {
        static_assert(C::numerator != 0, "an operator is divided by 0");
        constexpr int sign = C::numerator < 0 ? -1 : 1;
        return fraction<sign * C::denominator, sign * C::numerator>{} * std::move(a);
    } else
        return multiple<detail::one_over<C>, A>(detail::one_over<C>(std::move(c)), std::move(a));
}

/// True when the operator is known at compile time, except for whole-number factors and divisors, so that operators compare by their
/// values.
template <class A>
inline constexpr bool known_by_type = std::is_empty_v<A>;
template <class C, class A>
inline constexpr bool known_by_type<multiple<C, A>> =
    std::conjunction_v<std::bool_constant<detail::is_exact_factor<C>>, std::bool_constant<known_by_type<A>>>;
template <class A, class B>
inline constexpr bool known_by_type<composition<A, B>> =
    std::conjunction_v<std::bool_constant<known_by_type<A>>, std::bool_constant<known_by_type<B>>>;
template <class A, class B>
inline constexpr bool known_by_type<operator_sum<A, B>> =
    std::conjunction_v<std::bool_constant<known_by_type<A>>, std::bool_constant<known_by_type<B>>>;

template <class A>
inline constexpr bool is_identity = false;
template <class Base, class From, class To>
inline constexpr bool is_identity<identity_on<Base, From, To>> = true;

/// The identity on T, T_half and T_o.
inline constexpr identity_on<nodes, delta_weight> identity_T{};
inline constexpr identity_on<between<fraction<1, 2>>, step_weight> identity_h{};
inline constexpr identity_on<joined<fraction<1, 2>>, delta_weight> identity_o{};

} // namespace hilger
