// SPDX-License-Identifier: BSL-1.0
// The scales that come from T: T^+, T^-, T^+-, T_half, T_o, T_lambda and T_{o,lambda} (Cresson-Safi, definitions 1 and 7). Each is a view:
// a copy of T's handle and an empty type, never a copy of points.
#pragma once

#include "hilger/scale/interface.hpp"

namespace hilger {

/// A family of points of `root`, restricted by `domain`.
template <class Root, class Domain>
class derived_scale : public scale_interface<derived_scale<Root, Domain>> {
public:
    using scalar_type = typename Root::scalar_type;
    using root_type = Root;
    using domain_type = Domain;

    constexpr derived_scale(Root root, Domain domain) : root_(std::move(root)), domain_(std::move(domain)) {}
    [[nodiscard]] constexpr Root const& root() const { return root_; }
    [[nodiscard]] constexpr Domain const& domain() const { return domain_; }

private:
    Root root_;
    [[no_unique_address]] Domain domain_;
};

namespace detail {
template <time_scale_like Scale, class Domain>
constexpr auto derive(Scale const& scale, Domain domain) {
    return derived_scale<typename Scale::root_type, Domain>(scale.root(), std::move(domain));
}
template <int Front, int Back, class Scale>
constexpr auto cut(Scale const& scale) {
    using D = typename Scale::domain_type;
    return derive(scale, domain<typename D::base_type, D::front + Front, D::back + Back>{scale.domain().base});
}
template <class Domain>
constexpr void require_nodes() {
    if constexpr (not std::same_as<Domain, domain<nodes>>)
        does_not_compile<"half, circ and their lambda siblings are made from T, and this scale is " + Domain::name() +
                         "; for the points of a derived scale as a T of its own write time_scale(scale)">{};
}
template <class S>
constexpr void require_lambda(S const& lambda, bool zero_allowed) {
    if (not(lambda < S(1)) or lambda < S(0) or (not zero_allowed and lambda == S(0)))
        error::raise<error::invalid_parameter>("lambda lies in ", zero_allowed ? "[0, 1[" : "]0, 1[", ", and this one is ", lambda);
}
/// T_{o,lambda} has no two equal points: lambda and 1 - lambda are not lost in rounding beside the points of T.
template <class Scale, class S>
constexpr void require_between(Scale const& T, S const& lambda) {
    if constexpr (not std::numeric_limits<S>::is_exact) {
        run_time<S> const at{lambda};
        for (index_type i = 0; i < T.last(); i = Scale::root_type::is_uniform and i == 0 and T.last() > 1 ? T.last() - 1 : i + 1) {
            S const t = T.root().between(i, at);
            if (not(T.element(i) < t) or not(t < T.element(i + 1)))
                error::raise<error::invalid_scale>("lambda = ", lambda, " is lost in rounding between the points ", T.element(i), " and ",
                                                   T.element(i + 1));
        }
    }
}
template <class Lambda>
concept lambda_in_range = Lambda::numerator >= 0 and Lambda::numerator < Lambda::denominator;
template <class Lambda>
concept lambda_inside = lambda_in_range<Lambda> and Lambda::numerator >
0;
} // namespace detail

/// T^+ = T without its last point.
template <time_scale_like Scale>
constexpr auto without_last(Scale const& scale) {
    return detail::cut<0, 1>(scale);
}
/// T^- = T without its first point.
template <time_scale_like Scale>
constexpr auto without_first(Scale const& scale) {
    return detail::cut<1, 0>(scale);
}
/// T^+- = T without both end points.
template <time_scale_like Scale>
constexpr auto interior(Scale const& scale) {
    return detail::cut<1, 1>(scale);
}
/// T_half, the mid-points of T.
template <time_scale_like Scale>
constexpr auto half(Scale const& T) {
    detail::require_nodes<typename Scale::domain_type>();
    return detail::derive(T, domain<between<fraction<1, 2>>>{});
}
/// T_o = T u T_half.
template <time_scale_like Scale>
constexpr auto circ(Scale const& T) {
    detail::require_nodes<typename Scale::domain_type>();
    return detail::derive(T, domain<joined<fraction<1, 2>>>{});
}
/// T_lambda with lambda = P/Q in the type.
template <int P, int Q, time_scale_like Scale>
constexpr auto at_lambda(Scale const& T) {
    static_assert(detail::lambda_in_range<fraction<P, Q>>, "lambda lies in [0, 1[");
    detail::require_nodes<typename Scale::domain_type>();
    return detail::derive(T, domain<between<reduced<P, Q>>>{});
}
/// T_lambda with lambda known at run time. @throws error::invalid_parameter when lambda is outside [0, 1[.
template <time_scale_like Scale, class S = typename Scale::root_type::scalar_type>
constexpr auto at_lambda(Scale const& T, std::type_identity_t<S> lambda) {
    detail::require_nodes<typename Scale::domain_type>();
    detail::require_lambda(lambda, true);
    return detail::derive(T, domain<between<run_time<S>>>{{{std::move(lambda)}}});
}
/// T/d: each step of T in d equal parts.
template <int Parts, time_scale_like Scale>
constexpr auto subdivide(Scale const& T) {
    static_assert(Parts >= 1, "a step is divided into one part or more");
    detail::require_nodes<typename Scale::domain_type>();
    return detail::derive(T, domain<subdivided<Parts>>{});
}
/// T_{o,lambda} = T u T_lambda with lambda = P/Q in the type; lambda = 0 is refused, because T_0 is already in T.
template <int P, int Q, time_scale_like Scale>
constexpr auto circ(Scale const& T) {
    static_assert(detail::lambda_inside<fraction<P, Q>>, "lambda lies in ]0, 1[");
    detail::require_nodes<typename Scale::domain_type>();
    return detail::derive(T, domain<joined<reduced<P, Q>>>{});
}
/// The same with lambda known at run time. @throws error::invalid_parameter when lambda is outside ]0, 1[, error::invalid_scale when it is
/// so close to 0 or 1 that points of T and T_lambda would be the same number.
template <time_scale_like Scale, class S = typename Scale::root_type::scalar_type>
constexpr auto circ(Scale const& T, std::type_identity_t<S> lambda) {
    detail::require_nodes<typename Scale::domain_type>();
    detail::require_lambda(lambda, false);
    detail::require_between(T, lambda);
    return detail::derive(T, domain<joined<run_time<S>>>{{{std::move(lambda)}}});
}

} // namespace hilger
