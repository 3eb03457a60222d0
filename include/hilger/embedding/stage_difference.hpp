// SPDX-License-Identifier: BSL-1.0
// Powers of the difference quotient of Radau IIA, for functions at its nodes on any T that are 0 at t_0:
//   Delta_minus_radau<s, P, Q>     D_s^{P/Q}, D_s the inverse of the integral with s stages; causal; for s = 1 it is Delta_-^{P/Q}
//   Delta_plus_radau<s, P, Q>      its adjoint in the sums with the weights of the quadrature, anticausal
//   Delta_minus_at_radau<s>(alpha) the order known at run time
// D_s^alpha D_s^beta = D_s^{alpha + beta}, in the type where orders are; order 1 is a difference of two steps, order -1 the integral. Sums
// reach from the first node, or to the last one, and both ends belong to them: integration by parts has no boundary term. A value costs
// O(N) for each of some hundred nodes of an integral (embedding/stage_weights.hpp); a step's history (history/stages.hpp) does not.
#pragma once

#include "hilger/adjoint/adjoint.hpp"
#include "hilger/embedding/stage_weights.hpp"

namespace hilger {

namespace detail {
/// Operators are compared with the powers P/Q of one triangle with 1 beside the diagonal and generic eigenvalues z that have roots: what
/// holds for the powers of all triangles holds for these. Entries are divided differences [z_j, ..., z_k] z^{P/Q} (Opitz).
template <index_type Size, int Stages, int P, int Q>
inline constexpr auto generic_stage_power = [] {
    constexpr auto size = static_cast<std::size_t>(Size);
    std::array<std::array<prime_field, size>, size> entries{};
    std::array<prime_field, size> z{}, difference{}; // difference[j]: [z_j, ..., z_k]
    for (std::size_t k = 0; k < size; ++k) {
        prime_field const root = random_element(1'000'003 * (Stages + 1) + k);
        z[k] = field_power(root, root_exponent);
        entries[k][k] = difference[k] = field_power(root, exponent_of_root<Q>() * P);
        for (std::size_t j = k; j-- > 0;) entries[k][j] = difference[j] = (difference[j + 1] - difference[j]) / (z[k] - z[j]);
    }
    return entries;
}();
} // namespace detail

/// D_s^alpha, or its adjoint, at the s nodes of Radau's quadrature in each step.
template <int Stages, class Order, side Side>
struct stage_difference : linear_operator<stage_difference<Stages, Order, Side>> {
    using from = quadrature_nodes<radau, Stages>;
    using to = from;
    using from_weight = step_weight;
    using to_weight = step_weight;
    static constexpr int stages = Stages;
    static constexpr reach reads = (Side == side::minus ? reach::causal() : reach::anticausal()).template at<from>();
    [[no_unique_address]] Order order{};

    static constexpr auto name() {
        auto const arguments = "radau<" + digits<Stages>() + "," + detail::order_name<Order>::name() + ">";
        if constexpr (Side == side::minus)
            return "Delta_minus_" + arguments;
        else
            return "Delta_plus_" + arguments;
    }
    /// Sums over whole steps from the first one (to the last one), so f must be known there.
    template <int F, int B>
    constexpr auto image(domain<from, F, B> const&) const {
        using A = stage_difference;
        if constexpr (Side == side::minus) {
            if constexpr (F > 0) detail::sums_from_the_first<A, domain<from, F, B>>();
            return domain<to, 0, whole_steps(B)>{};
        } else {
            if constexpr (B > 0) detail::sums_to_the_last<A, domain<from, F, B>>();
            return domain<to, whole_steps(F), 0>{};
        }
    }
    template <class F>
    constexpr auto evaluate(F const& f, index_type i) const {
        using S = typename F::root_type::scalar_type;
        if constexpr (ordered_scalar<S>)
            return by_weights(f, i);
        else
            return on_generic_scale(f, i);
    }
    constexpr auto adjoint() const { return stage_difference<Stages, Order, opposite<Side>>{{}, order}; }

private:
    static constexpr int whole_steps(int points) { return Stages * ((points + Stages - 1) / Stages); }
    static constexpr index_type sign = Side == side::minus ? -1 : 1;
    template <class F>
    auto by_weights(F const& f, index_type i) const {
        using S = typename F::root_type::scalar_type;
        auto const& T = f.root();
        index_type const own = i / Stages, end = Side == side::minus ? f.domain().first(T) : f.domain().last(T);
        auto const w = detail::stage_weights<S, Stages, Side>::of(order, i % Stages, 1 + sign * (end / Stages - own),
                                                                  [&](index_type d) { return S(T.step(own + sign * d)); });
        auto sum = zero_of(f);
        for (std::size_t d = 0; d < w.size(); ++d)
            for (std::size_t k = 0; k < Stages; ++k) {
                index_type const j = Stages * (own + sign * static_cast<index_type>(d)) + static_cast<index_type>(k);
                S weight = w[d][k];
                if constexpr (Side == side::plus) weight = weight * weight_at<step_weight>(f, j) / weight_at<step_weight>(f, i);
                sum = evaluated(sum + f.get(j) * weight);
            }
        return sum;
    }
    template <class F>
    static constexpr value_of<F> on_generic_scale(F const& f, index_type i) {
        constexpr index_type last = from::last(F::root_type::steps());
        constexpr auto const& power = detail::generic_stage_power<last + 1, Stages, Order::numerator, Order::denominator>;
        auto const at = [](index_type j) { return static_cast<std::size_t>(j); };
        auto sum = zero_of(f);
        if constexpr (Side == side::minus)
            for (index_type j = 0; j <= i; ++j) sum = sum + f.get(j) * power[at(i)][at(j)];
        else
            for (index_type j = i; j <= last; ++j)
                sum = sum + f.get(j) * (power[at(j)][at(i)] * weight_at<step_weight>(f, j) / weight_at<step_weight>(f, i));
        return sum;
    }
};

/// D^alpha D^beta = D^{alpha + beta}; order zero is the identity.
template <int Stages, class O, class R, side Side>
constexpr auto operator*(stage_difference<Stages, O, Side> const& a, stage_difference<Stages, R, Side> const& b) {
    auto const order = detail::sum_of_orders(a.order, b.order);
    return stage_difference<Stages, std::remove_const_t<decltype(order)>, Side>{{}, order};
}
template <linear_map A, int Stages, class O, class R, side Side>
constexpr auto operator*(composition<A, stage_difference<Stages, O, Side>> const& a, stage_difference<Stages, R, Side> const& b) {
    return a.a * (a.b * b);
}
template <int Stages, class O, class R, side Side, linear_map B>
constexpr auto operator*(stage_difference<Stages, O, Side> const& a, composition<stage_difference<Stages, R, Side>, B> const& b) {
    return (a * b.a) * b.b;
}
template <linear_map A, int Stages, class O, class R, side Side, linear_map B>
constexpr auto operator*(composition<A, stage_difference<Stages, O, Side>> const& a,
                         composition<stage_difference<Stages, R, Side>, B> const& b) {
    return a.a * ((a.b * b.a) * b.b);
}

namespace detail {
/// D_s^alpha by its order.
template <int Stages, side Side, class Order>
constexpr auto stage_difference_of(Order order) {
    return stage_difference<Stages, Order, Side>{{}, std::move(order)};
}
template <int Stages, side Side, int P, int Q>
inline constexpr auto stage_difference_in_type = stage_difference_of<Stages, Side>(order_in_type<P, Q>{});
} // namespace detail

/// D_s^{P/Q} and its adjoint.
template <int Stages, int P, int Q>
inline constexpr auto Delta_minus_radau = detail::stage_difference_in_type<Stages, side::minus, P, Q>;
template <int Stages, int P, int Q>
inline constexpr auto Delta_plus_radau = detail::stage_difference_in_type<Stages, side::plus, P, Q>;
/// D_s^alpha, the order known at run time. @throws error::invalid_parameter when it is outside [-100, 100]
template <int Stages, scalar S>
constexpr auto Delta_minus_at_radau(S alpha) {
    detail::require_order_of_difference(alpha);
    return detail::stage_difference_of<Stages, side::minus>(run_time<S>{std::move(alpha)});
}

} // namespace hilger
