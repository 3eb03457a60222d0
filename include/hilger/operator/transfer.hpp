// SPDX-License-Identifier: BSL-1.0
// Operators that carry functions from one family of points to another: extension, restriction, pi, and their adjoints.
//   extend                f -> f_o: f at t_i, the average in between                     (Cresson-Safi (24))
//   on_T, on_half         the values of a function on T_o at T, at T_half
//   pi                    f -> f o pi, functions on T_half to functions on T^+           (Cresson-Safi, definition 2)
//   mean_o                [f]_o = (f o sigma_o + f o rho_o) / 2 on T^+-                  (Cresson-Safi (26))
// On a non-uniform scale the adjoint of the extension is the mean weighted by the steps, step_mean; on a uniform one that is
// [.]_{1/2,-} o sigma_o (Cresson-Safi, lemma 3).
#pragma once

#include "hilger/operator/local.hpp"

namespace hilger {

template <class Lambda>
struct extension;
template <class Lambda>
struct step_mean_at;

/// Extension by zero: the adjoints of the restrictions, up to a factor 2 for the split weights.
template <class Lambda, bool ToNodes>
struct insertion : linear_operator<insertion<Lambda, ToNodes>> {
    using from = std::conditional_t<ToNodes, nodes, between<Lambda>>;
    using to = joined<Lambda>;
    using from_weight = std::conditional_t<ToNodes, natural_weight_t<Lambda>, step_weight>;
    using to_weight = split_weight<natural_weight_t<Lambda>>;
    [[no_unique_address]] Lambda lambda{};

    static constexpr reach reads = reach::local(0, 0).at<from>();
    static constexpr auto name() {
        if constexpr (ToNodes)
            return fixed_text("insert_T");
        else
            return fixed_text("insert_half");
    }
    template <int F, int B>
    constexpr auto image(domain<from, F, B> const&) const {
        if constexpr (ToNodes)
            return domain<to, std::max(2 * F - 1, 0), std::max(2 * B - 1, 0)>{{lambda}};
        else
            return domain<to, 2 * F, 2 * B>{{lambda}};
    }
    template <class F>
    constexpr auto evaluate(F const& f, index_type j) const {
        using value = value_of<F>;
        if ((j % 2 == 0) == ToNodes) return value(f.get(j / 2));
        return zero_of(f);
    }
    constexpr auto adjoint() const;
};

/// A function on T_{o,lambda} at the points of T, or at those of T_lambda.
template <class Lambda, bool ToNodes>
struct restriction_to : linear_operator<restriction_to<Lambda, ToNodes>> {
    using from = joined<Lambda>;
    using to = std::conditional_t<ToNodes, nodes, between<Lambda>>;
    using from_weight = split_weight<natural_weight_t<Lambda>>;
    using to_weight = std::conditional_t<ToNodes, natural_weight_t<Lambda>, step_weight>;
    [[no_unique_address]] Lambda lambda{};

    static constexpr reach reads = reach::local(0, 0).at<to>();
    static constexpr auto name() {
        if constexpr (ToNodes)
            return fixed_text("on_T");
        else
            return "on_" + detail::lambda_name<Lambda>::name();
    }
    template <int F, int B>
    constexpr auto image(domain<from, F, B> const& d) const {
        if constexpr (ToNodes)
            return domain<nodes, (F + 1) / 2, (B + 1) / 2>{};
        else
            return domain<to, F / 2, B / 2>{{d.base.lambda}};
    }
    template <class F>
    constexpr decltype(auto) evaluate(F const& f, index_type i) const {
        return f.get(ToNodes ? 2 * i : 2 * i + 1);
    }
    constexpr auto adjoint() const { return fraction<2>{} * insertion<Lambda, ToNodes>{{}, lambda}; }
};

template <class Lambda, bool ToNodes>
constexpr auto insertion<Lambda, ToNodes>::adjoint() const {
    return fraction<1, 2>{} * restriction_to<Lambda, ToNodes>{{}, lambda};
}

/// f o pi: the value at t_{i,lambda} as a value at t_i. The inverse puts the value at t_i to t_{i,lambda}.
template <class Lambda, bool Inverse>
struct projection : linear_operator<projection<Lambda, Inverse>> {
    using from = std::conditional_t<Inverse, nodes, between<Lambda>>;
    using to = std::conditional_t<Inverse, between<Lambda>, nodes>;
    using from_weight = std::conditional_t<Inverse, delta_weight, step_weight>;
    using to_weight = std::conditional_t<Inverse, step_weight, delta_weight>;
    [[no_unique_address]] Lambda lambda{};

    static constexpr reach reads = (Inverse ? reach::local(0.5, -0.5) : reach::local(-0.5, 0.5)).at<to>();
    static constexpr auto name() {
        if constexpr (Inverse)
            return fixed_text("pi_inverse");
        else
            return fixed_text("pi_half");
    }
    template <int F, int B>
    constexpr auto image(domain<from, F, B> const&) const {
        if constexpr (Inverse)
            return domain<to, F, std::max(B - 1, 0)>{{lambda}};
        else
            return domain<to, F, B + 1>{};
    }
    template <class F>
    constexpr decltype(auto) evaluate(F const& f, index_type i) const {
        return f.get(i);
    }
    constexpr auto adjoint() const { return projection<Lambda, not Inverse>{{}, lambda}; }
};

/// f -> f_{o,lambda}: f(t_i) at t_i, (1 - lambda) f(t_i) + lambda f(t_{i+1}) at t_{i,lambda}.
template <class Lambda>
struct extension : linear_operator<extension<Lambda>> {
    using from = nodes;
    using to = joined<Lambda>;
    using from_weight = natural_weight_t<Lambda>;
    using to_weight = split_weight<natural_weight_t<Lambda>>;
    [[no_unique_address]] Lambda lambda{};

    static constexpr reach reads{reach::local(0, 0).on_T, reach::local(0.5, 0.5).between};
    static constexpr auto name() { return fixed_text("extend"); }
    template <int F, int B>
    constexpr auto image(domain<nodes, F, B> const&) const {
        return domain<to, 2 * F, 2 * B>{{lambda}};
    }
    template <class F>
    constexpr auto evaluate(F const& f, index_type j) const {
        using S = typename F::root_type::scalar_type;
        using value = value_of<F>;
        if (j % 2 == 0) return value(f.get(j / 2));
        if constexpr (std::same_as<Lambda, fraction<1, 2>>) // one division instead of two products: exact halving
            return value((f.get(j / 2) + f.get(j / 2 + 1)) / S(2));
        else {
            S const l = lambda.template as<S>();
            return value(f.get(j / 2) * (S(1) - l) + f.get(j / 2 + 1) * l);
        }
    }
    constexpr auto adjoint() const {
        return fraction<1, 2>{} *
               (restriction_to<Lambda, true>{{}, lambda} + step_mean_at<Lambda>{{}, lambda} * restriction_to<Lambda, false>{{}, lambda});
    }
};

/// f on T_lambda -> ((1 - lambda) mu_i f_i + lambda nu_i f_{i-1}) / w_i on T^+-, the adjoint of f -> f_lambda. With the natural
/// weight w_i = (1 - lambda) mu_i + lambda nu_i it is a mean.
template <class Lambda>
struct step_mean_at : linear_operator<step_mean_at<Lambda>> {
    using from = between<Lambda>;
    using to = nodes;
    using from_weight = step_weight;
    using to_weight = natural_weight_t<Lambda>;
    [[no_unique_address]] Lambda lambda{};

    static constexpr reach reads = reach::local(0.5, 0.5).at<nodes>();
    static constexpr auto name() { return fixed_text("step_mean"); }
    template <int F, int B>
    constexpr auto image(domain<from, F, B> const&) const {
        return domain<nodes, F + 1, B + 1>{};
    }
    template <class F>
    constexpr auto evaluate(F const& f, index_type i) const {
        using S = typename F::root_type::scalar_type;
        auto const& T = f.root();
        S const l = f.domain().base.lambda.template as<S>();
        S const w = to_weight::at(T, nodes{}, i);
        return evaluated(f.get(i) * S((S(1) - l) * T.step(i) / w) + f.get(i - 1) * S(l * T.step(i - 1) / w));
    }
    constexpr auto adjoint() const { return restriction_to<Lambda, false>{{}, lambda} * extension<Lambda>{{}, lambda}; }
};

inline constexpr extension<fraction<1, 2>> extend{};
inline constexpr restriction_to<fraction<1, 2>, true> on_T{};
inline constexpr restriction_to<fraction<1, 2>, false> on_half{};
inline constexpr projection<fraction<1, 2>, false> pi_half{};
inline constexpr projection<fraction<1, 2>, true> pi_inverse{};
inline constexpr step_mean_at<fraction<1, 2>> step_mean{};
/// [f]_o (Cresson-Safi (26))
inline constexpr auto mean_o = on_T * (fraction<1, 2>{} * (sigma_o + rho_o));

/// The same for any lambda = P/Q in the type: in ]0, 1[ where T_{o,lambda} is needed, in [0, 1[ for T_lambda.
template <int P, int Q>
    requires detail::lambda_inside<fraction<P, Q>>
inline constexpr extension<reduced<P, Q>> extend_lambda{};
template <int P, int Q>
    requires detail::lambda_inside<fraction<P, Q>>
inline constexpr restriction_to<reduced<P, Q>, false> on_lambda{};
template <int P, int Q>
    requires detail::lambda_in_range<fraction<P, Q>>
inline constexpr projection<reduced<P, Q>, true> pi_lambda_inverse{};

/// f -> f_{o,lambda} for a lambda known at run time. @throws error::invalid_parameter when lambda is outside ]0, 1[.
template <ordered_scalar S>
constexpr auto extend_at(S lambda) {
    detail::require_lambda(lambda, false);
    return extension<run_time<S>>{{}, {std::move(lambda)}};
}

} // namespace hilger
