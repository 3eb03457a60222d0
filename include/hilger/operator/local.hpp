// SPDX-License-Identifier: BSL-1.0
// The shifts and the derivatives on every scale, as two primitives with a sign and a family of points.
//   sigma, rho      f -> f o sigma, f o rho                       (Cresson-Safi, definition 3 and (29))
//   Delta_+-        (f^sigma - f) / mu,  (f - f^rho) / nu         (Cresson-Safi (27), (28), (31))
// Between the nabla and the Delta sum of its scale: adjoint(sigma) = rho, adjoint(Delta_plus) = -Delta_minus, uniform or not.
#pragma once

#include "hilger/operator/compose.hpp"

namespace hilger {

/// The direction of an operator: to the next point or to the previous one.
enum class side { plus, minus };

constexpr side opposite_of(side s) { return s == side::plus ? side::minus : side::plus; }
template <side Side>
inline constexpr side opposite = opposite_of(Side);

namespace detail {
template <class Base>
inline constexpr double step_length = 1;
template <class Lambda>
inline constexpr double step_length<joined<Lambda>> = 0.5;
/// The reach over so many points of Base: on T_o each counts half a step.
template <class Base>
constexpr reach steps_of_family(int before, int after) {
    return reach::local(before * step_length<Base>, after * step_length<Base>).template at<Base>();
}

template <side Side, class Base, class PlusName, class MinusName>
constexpr auto sided_name(PlusName const& p, MinusName const& m) {
    auto const suffix = [] {
        if constexpr (std::same_as<Base, nodes>)
            return fixed_text("");
        else if constexpr (std::same_as<Base, between<fraction<1, 2>>>)
            return fixed_text("_h");
        else if constexpr (std::same_as<Base, joined<fraction<1, 2>>>)
            return fixed_text("_o");
        else
            return "_on<" + Base::name() + ">";
    }();
    if constexpr (Side == side::plus)
        return p(suffix);
    else
        return m(suffix);
}
} // namespace detail

/// f(sigma(t)), or f(rho(t)) for side::minus (Cresson-Safi, definition 3).
template <class Base, side Side>
struct shift : linear_operator<shift<Base, Side>> {
    using from = Base;
    using to = Base;
    using from_weight = std::conditional_t<Side == side::plus, nabla_weight, delta_weight>;
    using to_weight = std::conditional_t<Side == side::plus, delta_weight, nabla_weight>;
    static constexpr reach reads = Side == side::plus ? detail::steps_of_family<Base>(-1, 1) : detail::steps_of_family<Base>(1, -1);
    static constexpr auto name() {
        return detail::sided_name<Side, Base>([](auto const& s) { return "sigma" + s; }, [](auto const& s) { return "rho" + s; });
    }
    template <int F, int B>
    constexpr auto image(domain<Base, F, B> const& d) const {
        if constexpr (Side == side::plus)
            return domain<Base, std::max(F - 1, 0), B + 1>{d.base};
        else
            return domain<Base, F + 1, std::max(B - 1, 0)>{d.base};
    }
    template <class F>
    constexpr decltype(auto) evaluate(F const& f, index_type i) const {
        return f.get(Side == side::plus ? i + 1 : i - 1);
    }
    constexpr auto adjoint() const { return shift<Base, opposite<Side>>{}; }
};

/// (f(sigma(t)) - f(t)) / mu(t), or (f(t) - f(rho(t))) / nu(t) for side::minus (Cresson-Safi (27), (28)).
template <class Base, side Side>
struct derivative : linear_operator<derivative<Base, Side>> {
    using from = Base;
    using to = Base;
    using from_weight = std::conditional_t<Side == side::plus, nabla_weight, delta_weight>;
    using to_weight = std::conditional_t<Side == side::plus, delta_weight, nabla_weight>;
    static constexpr reach reads = Side == side::plus ? detail::steps_of_family<Base>(0, 1) : detail::steps_of_family<Base>(1, 0);
    static constexpr auto name() {
        return detail::sided_name<Side, Base>([](auto const& s) { return "Delta" + s + "_plus"; },
                                              [](auto const& s) { return "Delta" + s + "_minus"; });
    }
    template <int F, int B>
    constexpr auto image(domain<Base, F, B> const& d) const {
        return domain<Base, F + (Side == side::minus), B + (Side == side::plus)>{d.base};
    }
    template <class F>
    constexpr auto evaluate(F const& f, index_type i) const {
        index_type const left = Side == side::plus ? i : i - 1;
        return evaluated((f.get(left + 1) - f.get(left)) / f.domain().base.step(f.root(), left));
    }
    constexpr auto adjoint() const { return -derivative<Base, opposite<Side>>{}; }
    /// The fractional difference of order alpha (operator/fractional.hpp).
    template <scalar S>
    constexpr auto operator()(S alpha) const;
    constexpr auto operator()(int alpha) const;
};

// On any other family they are named by their types: derivative<joined<fraction<1, 3>>, side::plus>{}.
inline constexpr shift<nodes, side::plus> sigma{};
inline constexpr shift<nodes, side::minus> rho{};
inline constexpr shift<between<fraction<1, 2>>, side::plus> sigma_h{};
inline constexpr shift<between<fraction<1, 2>>, side::minus> rho_h{};
inline constexpr shift<joined<fraction<1, 2>>, side::plus> sigma_o{};
inline constexpr shift<joined<fraction<1, 2>>, side::minus> rho_o{};

inline constexpr derivative<nodes, side::plus> Delta_plus{};
inline constexpr derivative<nodes, side::minus> Delta_minus{};
inline constexpr derivative<between<fraction<1, 2>>, side::plus> Delta_h_plus{};
inline constexpr derivative<between<fraction<1, 2>>, side::minus> Delta_h_minus{};
inline constexpr derivative<joined<fraction<1, 2>>, side::plus> Delta_o_plus{};
inline constexpr derivative<joined<fraction<1, 2>>, side::minus> Delta_o_minus{};

/// [f]_{1/2,-} = (f + f o rho_half) / 2 on T_half^- (Cresson-Safi (25)), and its mirror image.
inline constexpr auto mean_h_minus = fraction<1, 2>{} * (identity_h + rho_h);
inline constexpr auto mean_h_plus = fraction<1, 2>{} * (identity_h + sigma_h);

} // namespace hilger
