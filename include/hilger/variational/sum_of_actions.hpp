// SPDX-License-Identifier: BSL-1.0
// Sums, differences and multiples of actions. Actions with one position, velocity and integral are one action of a sum of Lagrangians;
// others evaluate each Lagrangian in its own way, and the equation of their sum is the sum of their equations:
//   auto const fast = integral(L(q_o, Delta_o_plus[q_o]), half(T));
//   auto const slow = integral(U(q, Delta_plus[q]), T) + nabla_integral(U(q, Delta_minus[q]), T);
//   auto const EL = variation(fast - 0.5 * slow);
// Its steps are implicit in the forces of L, and explicit in those of U, integrated by the trapezoid rule (Stern, Grinspun 2009,
// "Implicit-explicit variational integration of highly oscillatory problems").
#pragma once

#include "hilger/variational/restricted.hpp"
#include "hilger/variational/variation.hpp"

namespace hilger {

namespace detail {

/// c L, of (q, v) or of (t, q, v).
template <class C, class F>
struct multiple_of_lagrangian {
    C factor;
    [[no_unique_address]] F function;
    template <class... X>
        requires std::invocable<F const&, X const&...>
    constexpr auto operator()(X const&... x) const { return plain_t<decltype(factor * function(x...))>(factor * function(x...)); }
};
/// L + M, each evaluated at nodes of its own in a step (step/sum_of_embeddings.hpp); as a function their sum, for momenta and energies.
template <class F, class G>
struct lagrangian_by_node : sum_of_callables<F, G> {};
/// Number of Lagrangians in F.
template <class F>
inline constexpr int parts_of = 1;
template <class F, class G>
inline constexpr int parts_of<lagrangian_by_node<F, G>> = parts_of<F> + parts_of<G>;

} // namespace detail

/// In a sum by nodes the force is added to the first Lagrangian, at its nodes.
template <class F, class G, class Force>
struct problem<detail::lagrangian_by_node<F, G>, Force> {
    detail::lagrangian_by_node<F, G> lagrangian;
    [[no_unique_address]] Force force;
    problem<F, Force> first;
    problem<G, no_force> second;
    constexpr problem(detail::lagrangian_by_node<F, G> L, Force f)
        : lagrangian(std::move(L)), force(std::move(f)), first{lagrangian.first, force}, second{lagrangian.second, {}} {}
};

/// S + R of actions that differ in position, velocity or integral; S may be such a sum.
template <class First, class Second>
struct action_sum {
    using root_type = typename First::root_type;
    using position_type = typename First::position_type;
    static_assert(std::same_as<typename position_type::from, typename Second::position_type::from>,
                  "actions add up of functions that live on the same points: on T, or with the same points inside its steps");
    static constexpr bool is_sum = true;
    First first;
    Second second;
    [[nodiscard]] constexpr root_type const& scale() const { return first.scale(); }

    template <discrete_function X>
    constexpr auto operator()(X const& x) const {
        return first(x) + second(x);
    }
};

namespace detail {

template <class S>
concept some_action = requires {
    S::is_sum;
};
template <some_action S>
inline constexpr bool is_action_sum = S::is_sum;
/// The Lagrangian of a Hamiltonian is no function that could be added or multiplied.
template <class S>
concept has_derivatives_alone = requires {
    requires S::function_type::has_derivatives_alone;
};

/// The sum of the Lagrangians, for momenta and energies.
template <class S>
constexpr auto function_of(S const& s) {
    if constexpr (is_action_sum<S>) {
        auto f = function_of(s.first);
        auto g = function_of(s.second);
        return lagrangian_by_node<decltype(f), decltype(g)>{{std::move(f), std::move(g)}};
    } else
        return s.function;
}
template <class S>
using function_of_t = decltype(function_of(std::declval<S const&>()));

/// The sum of two actions of one kind, whose operators are their types.
template <class F, class G, linear_map A, linear_map B, class W, class Root>
    requires(std::is_empty_v<A>and std::is_empty_v<B>)
constexpr auto sum_of(action<F, A, B, W, Root> const& S, action<G, A, B, W, Root> const& R) {
    return action<sum_of_callables<F, G>, A, B, W, Root>{{S.function, R.function}, S.position, S.velocity, S.T};
}
template <class S, class R>
constexpr auto sum_of(S const& s, R const& r) {
    if constexpr (is_action_sum<R>)
        return sum_of(sum_of(s, r.first), r.second);
    else
        return action_sum<S, R>{s, r};
}

} // namespace detail

/// S + R, over one scale. @throws error::mismatch for two scales
template <detail::some_action S, detail::some_action R>
constexpr auto operator+(S const& s, R const& r) {
    if constexpr (detail::has_derivatives_alone<S> or detail::has_derivatives_alone<R>)
        return does_not_compile<"actions of Lagrangians add up, and one here is that of a Hamiltonian, lagrangian_of(H)", S>{};
    else if constexpr (not std::same_as<typename S::root_type, typename R::root_type>)
        return does_not_compile<"actions add up on one scale, and these are on two kinds of scales", S>{};
    else {
        if (not(s.scale() == r.scale()))
            error::raise<error::mismatch>("actions add up on one scale, and these are on ", s.scale(), " and on ", r.scale());
        return detail::sum_of(s, r);
    }
}
/// c S, with c in the scalar of T.
template <detail::some_action S>
constexpr auto operator*(std::type_identity_t<typename S::root_type::scalar_type> const& c, S const& s) {
    using C = typename S::root_type::scalar_type;
    if constexpr (detail::has_derivatives_alone<S>)
        return does_not_compile<"actions of Lagrangians have multiples, and this is that of a Hamiltonian, lagrangian_of(H)", S>{};
    else if constexpr (detail::is_action_sum<S>) {
        auto first = c * s.first;
        auto second = c * s.second;
        return action_sum<decltype(first), decltype(second)>{std::move(first), std::move(second)};
    } else {
        using A = typename S::position_type;
        using B = typename S::velocity_type;
        using F = detail::multiple_of_lagrangian<C, typename S::function_type>;
        return action<F, A, B, typename S::weight, typename S::root_type>{{c, s.function}, s.position, s.velocity, s.T};
    }
}
/// -S and S - R. @throws as S + R
template <detail::some_action S>
constexpr auto operator-(S const& s) {
    return typename S::root_type::scalar_type(-1) * s;
}
template <detail::some_action S, detail::some_action R>
constexpr auto operator-(S const& s, R const& r) {
    return s + -r;
}
template <class First, class Second, linear_map A, linear_map B, class Root>
constexpr auto operator-(action_sum<First, Second> const&, coupling<A, B, Root> const&) {
    return does_not_compile<"a coupling damps one action, and this is a sum of several that read T in different ways", First>{};
}

namespace detail {
/// The derivatives of each Lagrangian at its nodes; the force is added to the first.
template <class Problem>
class derivatives_by_node;
template <class F, class Force>
auto derivatives_at_nodes(problem<F, Force> const& what) {
    return kept_derivatives(what);
}
template <class F, class G, class Force>
auto derivatives_at_nodes(problem<lagrangian_by_node<F, G>, Force> const& what) {
    return derivatives_by_node<problem<lagrangian_by_node<F, G>, Force>>(what);
}
template <class F, class G, class Force>
class derivatives_by_node<problem<lagrangian_by_node<F, G>, Force>> {
    using first_type = decltype(derivatives_at_nodes(std::declval<problem<F, Force> const&>()));

public:
    explicit derivatives_by_node(problem<lagrangian_by_node<F, G>, Force> const& what)
        : first(derivatives_at_nodes(what.first)), second(what.second) {}
    /// Those of the Lagrangian with this number.
    template <class S, class V>
    std::pair<V, V> gradients(int part, S const& t, V const& q, V const& v) const {
        return part < parts_of<F> ? first.gradients(part, t, q, v) : second.gradients(part - parts_of<F>, t, q, v);
    }
    template <class S, class V>
    node_table<V> expand(int part, S const& t, V const& q, V const& v) const {
        return part < parts_of<F> ? first.expand(part, t, q, v) : second.expand(part - parts_of<F>, t, q, v);
    }
    first_type first;
    kept_derivatives<problem<G, no_force>> second;
};
} // namespace detail

/// The sum of both equations, in the sum over T with the weights P. A force is added to the first Lagrangian, at its nodes.
template <class First, class Second, class P>
class euler_lagrange<action_sum<First, Second>, P> {
    using sum = action_sum<First, Second>;
    euler_lagrange<First, P> first_;
    euler_lagrange<Second, P> second_;
    sum action_;

public:
    constexpr explicit euler_lagrange(sum s) : first_(s.first), second_(s.second), action_(std::move(s)) {}
    [[nodiscard]] constexpr sum const& action() const { return action_; }
    [[nodiscard]] constexpr auto const& first() const { return first_; }
    [[nodiscard]] constexpr auto const& second() const { return second_; }
    static constexpr reach reads = decltype(first_)::reads | decltype(second_)::reads;

    /// The left-hand side at x in C(T), a function on T^+-, and below its derivatives and sizes as for one action.
    template <discrete_function X, class Force = no_force>
    constexpr auto residual(X const& x, Force const& force = {}) const {
        return first_.residual(x, force) + second_.residual(x);
    }
    template <class Force = no_force>
    [[nodiscard]] auto derivatives(Force const& force = {}) const {
        return detail::derivatives_at_nodes(problem<detail::function_of_t<sum>, Force>{detail::function_of(action_), force});
    }
    template <discrete_function X, class Kept>
    constexpr auto residual_slope(X const& x, index_type k, Kept const& kept) const {
        return first_.residual_slope(x, k, kept.first) + second_.residual_slope(x, k, kept.second);
    }
    template <discrete_function X, class Kept>
    constexpr auto residual_size(X const& x, index_type k, Kept const& kept) const {
        return value_of<X>(first_.residual_size(x, k, kept.first) + second_.residual_size(x, k, kept.second));
    }
};
/// The discrete Euler-Lagrange equation of a sum of actions.
template <class First, class Second>
constexpr auto variation(action_sum<First, Second> const& S) {
    return euler_lagrange<action_sum<First, Second>>(S);
}

} // namespace hilger
