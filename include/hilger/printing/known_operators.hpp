// SPDX-License-Identifier: BSL-1.0
// The operators that have names in the papers. An operator that equals one of them up to a rational factor, on as many points, is written
// as that one, however it was composed.
#pragma once

#include "hilger/printing/words.hpp"

namespace hilger {

namespace detail {

/// A known operator: the fingerprint of its values on a generic function, and its notation around an argument.
struct known_operator {
    fingerprint print;
    expression (*write)(expression const&);
};

/// The operators with names, by the families that they map from and to.
template <bool Uniform>
struct operators_with_names {
    template <class A>
    static known_operator known(A const& op, expression (*write)(expression const&)) {
        return {fingerprint_of<Uniform>(op), write};
    }
    template <class L>
    using complement = fraction<L::denominator - L::numerator, L::denominator>;

    static std::vector<known_operator> on_T() {
        return {known(identity_T, [](expression const& f) { return f; }),
                known(sigma, [](expression const& f) { return with_symbol(f, shift_sign(nodes{}, side::plus)); }),
                known(rho, [](expression const& f) { return with_symbol(f, shift_sign(nodes{}, side::minus)); }),
                known(Delta_plus, [](expression const& f) { return with_symbol(f, delta_sign(nodes{}, side::plus)); }),
                known(Delta_minus, [](expression const& f) { return with_symbol(f, delta_sign(nodes{}, side::minus)); })};
    }
    /// On T_lambda.
    template <class Base, class L>
    static std::vector<known_operator> on_points_between() {
        constexpr identity_on<Base, delta_weight> here{};
        constexpr shift<Base, side::plus> next{};
        constexpr shift<Base, side::minus> last{};
        constexpr complement<L> rest{};
        constexpr projection<L, true> there{};
        return {
            known(here, [](expression const& f) { return f; }),
            known(next, [](expression const& f) { return with_symbol(f, shift_sign(Base{}, side::plus)); }),
            known(last, [](expression const& f) { return with_symbol(f, shift_sign(Base{}, side::minus)); }),
            known(derivative<Base, side::plus>{}, [](expression const& f) { return with_symbol(f, delta_sign(Base{}, side::plus)); }),
            known(derivative<Base, side::minus>{}, [](expression const& f) { return with_symbol(f, delta_sign(Base{}, side::minus)); }),
            known(rest * here + L{} * last, [](expression const& f) { return mean_of_neighbours<L>(f, side::minus); }),
            known(rest * here + L{} * next, [](expression const& f) { return mean_of_neighbours<L>(f, side::plus); }),
            known(there * step_mean_at<L>{}, [](expression const& f) { return step_weighted_mean(f, L{}); }),
            known(there * reweight<nodes, nabla_weight, natural_weight_t<L>>{} * Delta_minus * projection<L, false>{},
                  [](expression const& f) { // for 1/2 it is the difference on T_half, above
                      auto const on_nodes = written_alone(projection<L, false>{}, f);
                      auto const over = ratio_of(written_weight<nabla_weight>::value, written_weight<natural_weight_t<L>>::value, {"", ""});
                      return written_alone(projection<L, true>{},
                                           with_symbol(on_nodes, delta_sign(nodes{}, side::minus)).times_weight(over));
                  })};
    }
    template <class To, class L>
    static std::vector<known_operator> from_T_to_points_between() {
        if constexpr (L::numerator > 0)
            return {known(restriction_to<L, false>{} * extension<L>{},
                          [](expression const& f) { return restricted_to_points(extended(f, foot(joined<L>{})), To{}); }),
                    known(projection<L, true>{} * Delta_plus, [](expression const& f) {
                        return restricted_to_points(with_symbol(extended(f, foot(joined<L>{})), delta_sign(joined<L>{}, side::plus)), To{});
                    })};
        return {};
    }
    template <class From, class L>
    static std::vector<known_operator> from_points_between_to_T() {
        constexpr projection<L, false> on_T_of{};
        static constexpr auto written_on_T = [](expression const& f) { return written_alone(projection<L, false>{}, f); };
        return {known(on_T_of, written_on_T),
                known(on_T_of * derivative<From, side::minus>{},
                      [](expression const& f) { return written_on_T(with_symbol(f, delta_sign(From{}, side::minus))); }),
                known(on_T_of * (complement<L>{} * identity_on<From, delta_weight>{} + L{} * shift<From, side::minus>{}),
                      [](expression const& f) { return written_on_T(mean_of_neighbours<L>(f, side::minus)); }),
                known(step_mean_at<L>{}, [](expression const& f) { return written_on_T(step_weighted_mean(f, L{})); })};
    }
    template <class From, class To>
    static std::vector<known_operator> all() {
        using half = fraction<1, 2>;
        if constexpr (std::same_as<From, nodes> and std::same_as<To, nodes>)
            return on_T();
        else if constexpr (std::same_as<From, joined<half>> and std::same_as<To, nodes>)
            return {known(mean_o, [](expression const& f) { return in_mean(f, {"∘", "\\circ"}); })};
        else if constexpr (std::same_as<From, nodes> and std::same_as<To, joined<half>>)
            return {known(extend, [](expression const& f) { return extended(f, {"∘", "\\circ"}); })};
        else if constexpr (std::same_as<From, To> and has_lambda_in_type<From>)
            return on_points_between<From, std::remove_cvref_t<decltype(From{}.lambda)>>();
        else if constexpr (std::same_as<From, nodes> and has_lambda_in_type<To>)
            return from_T_to_points_between<To, std::remove_cvref_t<decltype(To{}.lambda)>>();
        else if constexpr (std::same_as<To, nodes> and has_lambda_in_type<From>)
            return from_points_between_to_T<From, std::remove_cvref_t<decltype(From{}.lambda)>>();
        else
            return {};
    }

private:
    template <class Base>
    static constexpr bool has_lambda_in_type = is_between<Base>and std::is_empty_v<Base>;
};

template <bool Uniform, class From, class To>
std::vector<known_operator> const& known_operators() {
    static std::vector<known_operator> const all = operators_with_names<Uniform>::template all<From, To>();
    return all;
}

/// f under the operator with this fingerprint, written as a known operator times a rational factor; none where no known one fits.
inline std::optional<expression> as_known(fingerprint const& print, std::vector<known_operator> const& all, expression const& f) {
    for (auto const& known : all)
        if (auto const c = times(print, known.print)) return known.write(f).times(c->numerator, c->denominator);
    return std::nullopt;
}
template <bool Uniform, class A>
std::optional<expression> as_known(A const& a, expression const& f) {
    if constexpr (has_residues<A>)
        if (auto const& all = known_operators<Uniform, typename A::from, typename A::to>(); not all.empty())
            return as_known(fingerprint_of<Uniform>(a), all, f);
    return std::nullopt;
}

} // namespace detail

} // namespace hilger
