// SPDX-License-Identifier: BSL-1.0
// The operators that have names in the papers. Whatever equals one of them up to a rational factor, on as many points, is written as that
// one, however it was composed.
#pragma once

#include "hilger/printing/words.hpp"

namespace hilger {

namespace detail {

/// How a known operator is written around its argument, and what it makes of a generic function.
struct known_operator {
    fingerprint print;
    expression (*write)(expression const&);
};

/// The operators with names, from From to To.
template <bool Uniform, class From, class To>
std::vector<known_operator> list_of_known_operators() {
    auto const known = [](auto const& op, expression (*write)(expression const&)) {
        return known_operator{fingerprint_of<Uniform>(op), write};
    };
    using half = fraction<1, 2>;
    if constexpr (std::same_as<From, nodes> and std::same_as<To, nodes>)
        return {known(identity_T, [](expression const& f) { return f; }),
                known(sigma, [](expression const& f) { return with_symbol(f, shift_sign(nodes{}, side::plus)); }),
                known(rho, [](expression const& f) { return with_symbol(f, shift_sign(nodes{}, side::minus)); }),
                known(Delta_plus, [](expression const& f) { return with_symbol(f, delta_sign(nodes{}, side::plus)); }),
                known(Delta_minus, [](expression const& f) { return with_symbol(f, delta_sign(nodes{}, side::minus)); })};
    else if constexpr (std::same_as<From, To> and is_between<From> and std::is_empty_v<From>) {
        using L = std::remove_cvref_t<decltype(From{}.lambda)>;
        constexpr identity_on<From, delta_weight> here{};
        constexpr shift<From, side::plus> next{};
        constexpr shift<From, side::minus> last{};
        constexpr fraction<L::denominator - L::numerator, L::denominator> rest{};
        constexpr projection<L, true> there{};
        return {
            known(here, [](expression const& f) { return f; }),
            known(next, [](expression const& f) { return with_symbol(f, shift_sign(From{}, side::plus)); }),
            known(last, [](expression const& f) { return with_symbol(f, shift_sign(From{}, side::minus)); }),
            known(derivative<From, side::plus>{}, [](expression const& f) { return with_symbol(f, delta_sign(From{}, side::plus)); }),
            known(derivative<From, side::minus>{}, [](expression const& f) { return with_symbol(f, delta_sign(From{}, side::minus)); }),
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
    } else if constexpr (std::same_as<From, nodes> and is_between<To> and std::is_empty_v<To>) {
        using L = std::remove_cvref_t<decltype(To{}.lambda)>;
        if constexpr (L::numerator > 0)
            return {known(restriction_to<L, false>{} * extension<L>{},
                          [](expression const& f) { return restricted_to_points(extended(f, foot(joined<L>{})), To{}); }),
                    known(projection<L, true>{} * Delta_plus, [](expression const& f) {
                        return restricted_to_points(with_symbol(extended(f, foot(joined<L>{})), delta_sign(joined<L>{}, side::plus)), To{});
                    })};
    } else if constexpr (std::same_as<From, joined<half>> and std::same_as<To, nodes>)
        return {known(mean_o, [](expression const& f) { return in_mean(f, {"∘", "\\circ"}); })};
    else if constexpr (std::same_as<From, nodes> and std::same_as<To, joined<half>>)
        return {known(extend, [](expression const& f) { return extended(f, {"∘", "\\circ"}); })};
    else if constexpr (std::same_as<To, nodes> and is_between<From> and std::is_empty_v<From>) {
        using L = std::remove_cvref_t<decltype(From{}.lambda)>;
        constexpr projection<L, false> on_T_of{};
        static constexpr auto written_on_T = [](expression const& f) { return written_alone(projection<L, false>{}, f); };
        constexpr fraction<L::denominator - L::numerator, L::denominator> rest{};
        return {known(on_T_of, written_on_T),
                known(on_T_of * derivative<From, side::minus>{},
                      [](expression const& f) { return written_on_T(with_symbol(f, delta_sign(From{}, side::minus))); }),
                known(on_T_of * (rest * identity_on<From, delta_weight>{} + L{} * shift<From, side::minus>{}),
                      [](expression const& f) { return written_on_T(mean_of_neighbours<L>(f, side::minus)); }),
                known(step_mean_at<L>{}, [](expression const& f) { return written_on_T(step_weighted_mean(f, L{})); })};
    }
    return {};
}

template <bool Uniform, class From, class To>
std::vector<known_operator> const& known_operators() {
    static std::vector<known_operator> const all = list_of_known_operators<Uniform, From, To>();
    return all;
}

/// f under the operator of this print, as one of those that are known, up to a rational factor; none where it is no such.
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
