// SPDX-License-Identifier: BSL-1.0
// The restricted variational principle for fractional damping (Jimenez, Ober-Bloebaum, section 2): two curves x and y with the same
// variation, an action of both and the coupling - rho int Delta_-^alpha[x] Delta_+^alpha[y]. The equation of x is damped by
// -rho Delta_-^{2 alpha}[x] ((20)), and that of y by the mirror image: y is x in reversed time.
//   constexpr unknown q; constexpr unknown<"y"> y;
//   auto const S = integral(L(q_o, Delta_o_plus[q_o]), half(T)) - rho * integral(Delta_minus_alpha<1, 4>[q] * Delta_plus_alpha<1, 4>[y],
//   T); static_assert(variation(S).damping() == Delta_minus_alpha<1, 2>);
// At the nodes of galerkin<s, radau>, on any T, the damping is -rho A*[D_s^{2 alpha}[A[x]]] with the position A
// (fractional/of_variation.hpp).
#pragma once

#include "hilger/variational/variation.hpp"

namespace hilger {

/// A[x] B[y] for two unknowns.
template <linear_map A, linear_map B>
struct coupling_density {
    [[no_unique_address]] A first;
    [[no_unique_address]] B second;
};
/// The coupling density f g of expressions of two unknowns.
template <symbolic_function F, symbolic_function G>
constexpr auto operator*(F const& f, G const& g) {
    constexpr bool of_two = not std::same_as<decltype(unknown_of(f)), decltype(unknown_of(g))>;
    static_assert(
        of_two,
        "expressions of one unknown are multiplied in a Lagrangian, lagrangian{[](auto q, auto v) { return v * v / 2 - q * q / 2; }}, "
        "which is called with them, L(q, Delta_plus[q]); a coupling is a product of two unknowns, unknown<\"q\"> and "
        "unknown<\"y\">");
    if constexpr (of_two)
        return coupling_density<decltype(operator_of(f)), decltype(operator_of(g))>{operator_of(f), operator_of(g)};
    else
        return f; // no further error
}

/// factor int A[x] B[y] over T: the sum over all points. Without the last, as (19) is printed, the equation of y has a term that (20)
/// lacks. Or the integral over the nodes of a quadrature, on any T.
template <linear_map A, linear_map B, class Root>
struct coupling {
    [[no_unique_address]] A first;
    [[no_unique_address]] B second;
    using S = typename Root::scalar_type;
    S factor;
    Root T;

    /// factor h sum_{k=0..N} A[x] . B[y]
    template <discrete_function X, discrete_function Y>
    constexpr auto operator()(X const& x, Y const& y) const {
        auto const products = dot(first[x], second[y]);
        if constexpr (not std::same_as<typename A::to, nodes>)
            return evaluated(weighted_sum<step_weight>(products) * factor);
        else {
            auto sum = zero_of(products);
            for (index_type k = products.first(); k <= products.last(); ++k) sum = evaluated(sum + products.get(k));
            return evaluated(sum * S(T.h() * factor));
        }
    }
};
/// The coupling int A[x] B[y] over a uniform T, or over at_nodes<Q, n>(T).
template <linear_map A, linear_map B, time_scale_like Scale>
constexpr auto integral(coupling_density<A, B> const& density, Scale const& scale) {
    using Root = typename Scale::root_type;
    constexpr bool at_nodes = detail::has_own_weights<typename Scale::domain_type::base_type, Root>;
    static_assert(std::same_as<typename Scale::domain_type, domain<nodes>> or at_nodes,
                  "a coupling is integrated over T, or over the nodes of a quadrature");
    static_assert(std::same_as<typename A::to, typename Scale::domain_type::base_type> and std::same_as<typename A::to, typename B::to>,
                  "both factors of a coupling are functions on the scale of its integral");
    if constexpr (not Root::is_uniform and not at_nodes)
        return does_not_compile<A::name() + " has the weights of one step h, and this integral is over " + Root::kind()>{};
    else
        return coupling<A, B, Root>{density.first, density.second, typename Root::scalar_type(1), scale.root()};
}
/// Multiples of a coupling.
template <linear_map A, linear_map B, class Root>
constexpr auto operator*(std::type_identity_t<typename Root::scalar_type> const& c, coupling<A, B, Root> k) {
    k.factor = c * k.factor;
    return k;
}
template <linear_map A, linear_map B, class Root>
constexpr auto operator*(coupling<A, B, Root> const& k, std::type_identity_t<typename Root::scalar_type> const& c) {
    return c * k;
}
template <linear_map A, linear_map B, class Root>
constexpr auto operator-(coupling<A, B, Root> const& k) {
    return typename Root::scalar_type(-1) * k;
}

/// S[x] + S[y] - coupling, for curves with equal variations.
template <class Action, class Coupling>
struct restricted_action {
    Action conservative;
    Coupling damping;

    template <discrete_function X, discrete_function Y>
    constexpr auto operator()(X const& x, Y const& y) const {
        return conservative(x) + conservative(y) - damping(x, y);
    }
};
/// The restricted action of S and a coupling. @throws error::mismatch for two scales
template <class F, linear_map A, linear_map B, class W, linear_map C, linear_map D, class Root>
constexpr auto operator-(action<F, A, B, W, Root> const& S, coupling<C, D, Root> const& k) {
    if (not S.T.same_points(k.T)) error::raise<error::mismatch>("an action and its coupling are over one scale, and these are not");
    return restricted_action<action<F, A, B, W, Root>, coupling<C, D, Root>>{S, k};
}
template <class F, linear_map A, linear_map B, class W, linear_map C, linear_map D, class Root>
constexpr auto operator+(action<F, A, B, W, Root> const& S, coupling<C, D, Root> const& k) {
    return S - -k;
}
template <class Action, class Coupling, linear_map C, linear_map D, class Root>
constexpr auto operator-(restricted_action<Action, Coupling> const&, coupling<C, D, Root> const&) {
    return does_not_compile<
        "an action has one coupling; several terms of damping are with_fractional_damping(L, {{rho_1, beta_1}, {rho_2, beta_2}})",
        Action>{};
}
template <class Action, class Coupling, linear_map C, linear_map D, class Root>
constexpr auto operator+(restricted_action<Action, Coupling> const& S, coupling<C, D, Root> const& k) {
    return S - k;
}

/// The equations of both curves: EL[x] - rho D[x] = 0 and EL[y] - rho D*[y] = 0.
template <class Action, linear_map A, linear_map B, class Root>
class restricted_euler_lagrange {
public:
    constexpr explicit restricted_euler_lagrange(restricted_action<Action, coupling<A, B, Root>> s) : S_(std::move(s)) {}

    /// The equation without damping.
    [[nodiscard]] constexpr auto conservative() const { return variation(S_.conservative); }
    /// D = B* A, and its mirror image A* B.
    [[nodiscard]] static constexpr auto damping() requires(std::is_empty_v<A>and std::is_empty_v<B>) { return B{}.adjoint() * A{}; }
    [[nodiscard]] constexpr auto damping() const requires(not(std::is_empty_v<A> and std::is_empty_v<B>)) {
        return S_.damping.second.adjoint() * S_.damping.first;
    }
    [[nodiscard]] constexpr auto reversed_damping() const { return S_.damping.first.adjoint() * S_.damping.second; }
    [[nodiscard]] constexpr auto const& factor() const { return S_.damping.factor; }
    [[nodiscard]] constexpr auto const& action() const { return S_; }

    /// The left-hand side of the equation of x on T^+-, and of y.
    template <discrete_function X>
    constexpr auto residual(X const& x) const {
        return conservative().residual(x) - factor() * detail::restrict_to(damping()[x], domain<typename A::from, 1, 1>{});
    }
    template <discrete_function Y>
    constexpr auto reversed_residual(Y const& y) const {
        return conservative().residual(y) - factor() * detail::restrict_to(reversed_damping()[y], domain<typename A::from, 1, 1>{});
    }

private:
    restricted_action<Action, coupling<A, B, Root>> S_;
};
/// The equations of both curves.
template <class Action, linear_map A, linear_map B, class Root>
constexpr auto variation(restricted_action<Action, coupling<A, B, Root>> const& S) {
    return restricted_euler_lagrange<Action, A, B, Root>(S);
}

} // namespace hilger
