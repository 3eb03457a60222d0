// SPDX-License-Identifier: BSL-1.0
// Definite integrals and the end-point bracket.
//   integral(f, T)         int_a^b f Delta t,   over T^+           (Cresson-Safi (7))
//   integral(f, half(T))   int_a^b f Delta_half t, over T_half     (Cresson-Safi (32), (35)); f may live on T_half or T_o
//   integral(f, circ(T))   the Delta integral of T_o, and of T/d
//   integral(f, at_nodes<Q, n>(T))     the quadrature Q of n nodes on each step (embedding/quadrature.hpp)
//   integral(f, s, t)      between two points of T, in either order: reversed bounds change the sign
//   nabla_integral         the same from the left, over T^-
#pragma once

#include "hilger/operator/antiderivative.hpp"

namespace hilger {

/// The sum of W(t) f(t) over all points of f's domain, in a floating scalar within 2 epsilon times the sum of |W(t) f(t)|.
template <class W, discrete_function F>
constexpr auto weighted_sum(F const& f) {
    using S = typename F::root_type::scalar_type;
    detail::running_sum<value_of<F>, S> total(zero_of(f));
    for (index_type i = f.first(); i <= f.last(); ++i) total.add(evaluated(f.get(i) * S(weight_at<W>(f, i))));
    return total.value();
}

namespace detail {

/// Families with weights of their own: nodes of a quadrature.
template <class Base, class Root>
inline constexpr bool has_own_weights = requires(Base const& base, Root const& T) {
    base.weight(T, index_type(0));
};

/// f at the points numbered first to last of Base, as a function: no copy.
template <discrete_function F, class Domain>
struct part : function_interface<part<F, Domain>> {
    using domain_type = Domain;
    using root_type = typename F::root_type;
    F f;
    Domain d;
    constexpr part(F g, Domain e) : f(std::move(g)), d(std::move(e)) {}
    constexpr decltype(auto) root() const { return f.root(); }
    constexpr Domain const& domain() const { return d; }
    constexpr auto get(index_type i) const { return f.get(i); }
};

template <class Wanted, class Domain>
constexpr auto lives_elsewhere() {
    return does_not_compile<"this needs a function on " + Wanted::name() + ", and the one given lives on " + Domain::name()>{};
}
template <class Wanted, discrete_function F>
constexpr auto restrict_to(F f, Wanted wanted) {
    using D = typename F::domain_type;
    if constexpr (not std::same_as<typename D::base_type, typename Wanted::base_type> or D::front > Wanted::front or D::back > Wanted::back)
        return lives_elsewhere<Wanted, D>();
    else {
        if (not(f.domain().base == wanted.base))
            error::raise<error::mismatch>("a function is used on its own scale: it lives on ", derived_scale(f.root(), f.domain()),
                                          ", and is needed on ", derived_scale(f.root(), wanted));
        return part<F, Wanted>(std::move(f), std::move(wanted));
    }
}

/// The integrand of int . Delta_lambda may be given on T_{o,lambda}; only its values on T_lambda count.
template <class Lambda, discrete_function F>
constexpr auto on_lambda_points(F f, between<Lambda> const& base) {
    if constexpr (std::same_as<base_of<F>, joined<Lambda>>)
        return restrict_to(restriction_to<Lambda, false>{{}, base.lambda}[std::move(f)], hilger::domain<between<Lambda>>{base});
    else
        return restrict_to(std::move(f), hilger::domain<between<Lambda>>{base});
}

template <class W, discrete_function F>
constexpr auto sum_between(F const& f, index_type from, index_type to) {
    using S = typename F::root_type::scalar_type;
    running_sum<value_of<F>, S> total(zero_of(f));
    for (index_type i = std::min(from, to); i < std::max(from, to); ++i) {
        index_type const k = std::same_as<W, nabla_weight> ? i + 1 : i;
        total.add(evaluated(f.get(k) * S(weight_at<W>(f, k))));
    }
    return from <= to ? total.value() : value_of<F>(-total.value());
}

template <class Root, class Wanted>
constexpr void used_elsewhere() {
    does_not_compile<"a function is used on its own scale, and this one lives on " + Root::kind() + " and is needed on " + Wanted::kind() +
                     " of another type">{};
}
template <class F, class Scale>
constexpr void require_root(F const& f, Scale const& scale) {
    if constexpr (not std::same_as<typename F::root_type, typename Scale::root_type>)
        used_elsewhere<typename F::root_type, typename Scale::root_type>();
    else if (not f.root().same_points(scale.root()))
        error::raise<error::mismatch>("a function is used on its own scale: it lives on ", f.scale(), ", and is needed on ", scale);
}

} // namespace detail

/// f on a smaller domain of the same family: restrict_to(f, interior(T)).
template <discrete_function F, time_scale_like Scale>
constexpr auto restrict_to(F f, Scale const& scale) {
    detail::require_root(f, scale);
    return detail::restrict_to(std::move(f), scale.domain());
}

/// int over the whole of T, T_lambda or T_o. @throws error::mismatch when f lives on another scale.
template <discrete_function F, time_scale_like Scale>
constexpr auto integral(F f, Scale const& scale) {
    using D = typename Scale::domain_type;
    using Base = typename D::base_type;
    static_assert(D::front == 0 and D::back == 0, "integrate over a whole scale: T, half(T), circ(T), or between two points");
    detail::require_root(f, scale);
    if constexpr (is_between<Base>)
        return weighted_sum<step_weight>(detail::on_lambda_points(std::move(f), scale.domain().base));
    else if constexpr (detail::has_own_weights<Base, typename Scale::root_type>)
        return weighted_sum<step_weight>(detail::restrict_to(std::move(f), scale.domain()));
    else
        return weighted_sum<delta_weight>(detail::restrict_to(std::move(f), domain<Base, 0, 1>{scale.domain().base}));
}

/// The nabla integral over T or T_o: f is needed on T^-. @throws error::mismatch when f lives on another scale
template <discrete_function F, time_scale_like Scale>
constexpr auto nabla_integral(F f, Scale const& scale) {
    static_assert(not detail::has_own_weights<typename Scale::domain_type::base_type, typename Scale::root_type>,
                  "over the nodes of a quadrature there is one integral: integral(f, scale)");
    detail::require_root(f, scale);
    return weighted_sum<nabla_weight>(
        detail::restrict_to(std::move(f), domain<typename Scale::domain_type::base_type, 1, 0>{scale.domain().base}));
}

/// int_s^t between two points, which are points of T also when f lives on T_lambda or at the nodes of a quadrature.
/// @throws error::outside_domain when s or t is not one of them.
template <discrete_function F>
constexpr auto integral(F f, typename F::root_type::scalar_type const& s, typename F::root_type::scalar_type const& t) {
    using Base = base_of<F>;
    if constexpr (is_between<Base> or detail::has_own_weights<Base, typename F::root_type>) {
        auto const T = derived_scale(f.root(), domain<nodes>{});
        constexpr index_type in_a_step = Base::last(2) - Base::last(1);
        return detail::sum_between<step_weight>(detail::restrict_to(f, domain<Base>{f.domain().base}), in_a_step * T.number_of(s),
                                                in_a_step * T.number_of(t));
    } else {
        auto const scale = derived_scale(f.root(), domain<Base>{f.domain().base});
        return detail::sum_between<delta_weight>(detail::restrict_to(f, domain<Base, 0, 1>{f.domain().base}), scale.number_of(s),
                                                 scale.number_of(t));
    }
}

template <discrete_function F>
constexpr auto nabla_integral(F f, typename F::root_type::scalar_type const& s, typename F::root_type::scalar_type const& t) {
    auto const scale = derived_scale(f.root(), domain<base_of<F>>{f.domain().base});
    return detail::sum_between<nabla_weight>(detail::restrict_to(f, domain<base_of<F>, 1, 0>{f.domain().base}), scale.number_of(s),
                                             scale.number_of(t));
}

/// [f]_a^b = f(b) - f(a), at the ends of f's own domain.
template <discrete_function F>
constexpr auto boundary(F const& f) {
    return value_of<F>(f[f.last()] - f[f.first()]);
}

} // namespace hilger
