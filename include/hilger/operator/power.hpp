// SPDX-License-Identifier: BSL-1.0
// The value of a power of the difference C f_k = (f_k - f_{k-1}) / w_k at a point of any T, or of C f_k = (f_k - f_{k+1}) / w_k, with the
// graininess w = nu or mu: C^alpha = C^m C^beta, m whole and |beta| < 1. f is 0 outside T.
#pragma once

#include "hilger/operator/local.hpp"
#include "hilger/operator/power_weights.hpp"

namespace hilger::detail {

/// An order as m + beta.
template <int P, int Q>
constexpr std::pair<int, fraction<P % Q, Q>> whole_and_rest(fraction<P, Q>) {
    return {P / Q, {}};
}
template <class C>
constexpr std::pair<int, run_time<C>> whole_and_rest(run_time<C> order) {
    int whole = 0;
    for (; not(order.value < C(1)); order.value = order.value - C(1)) ++whole;
    for (; not(C(-1) < order.value); order.value = order.value + C(1)) --whole;
    return {whole, order};
}
/// An order as p/q. @throws error::invalid_parameter where q is beyond 1000
template <class S, class Order>
std::pair<int, int> quotient_of(Order const& order) {
    constexpr int largest = 1000; // the cost of a row grows like q
    auto const refuse_beyond = [&](auto const& q) {
        if (q > largest)
            error::raise<error::invalid_parameter>(
                "in an exact scalar the order of a fractional difference on uneven steps has a denominator up to ", largest,
                ", and this one is ", q);
    };
    if constexpr (requires { Order::denominator; }) {
        refuse_beyond(Order::denominator);
        return {Order::numerator, Order::denominator};
    } else {
        S const alpha = order.template as<S>();
        refuse_beyond(denominator(alpha));
        return {static_cast<int>(numerator(alpha)), static_cast<int>(denominator(alpha))};
    }
}

/// The powers of the difference to the side with the graininess of W, delta_weight or nabla_weight.
template <class W, side Side>
struct powers_of_difference {
    static constexpr index_type point(index_type k, index_type n) { return Side == side::minus ? k - n : k + n; }
    /// The number of points from k to the end.
    template <class F>
    static constexpr index_type count(F const& f, index_type k) {
        return 1 + (Side == side::minus ? k - f.domain().first(f.root()) : f.domain().last(f.root()) - k);
    }
    template <class F>
    static auto graininess(F const& f, index_type k) {
        return typename F::root_type::scalar_type(f.root().step(continued_weight<W>::step_number(f.root(), k)));
    }
    /// C^beta f_k, by the sum with the weights of row k: O(k) times the nodes of their integral.
    template <class Beta, class F>
    static value_of<F> fraction_at(Beta const& beta, F const& f, index_type k) {
        using S = typename F::root_type::scalar_type;
        if (beta.template as<S>() == S(0)) return f.get(k);
        auto const w = [&](index_type n) { return graininess(f, point(k, n)); };
        auto const row = [&] {
            if constexpr (std::numeric_limits<S>::is_exact) {
                auto const [p, q] = quotient_of<S>(beta);
                return exact_power_row<S>(p, q, count(f, k), w);
            } else
                return power_row(beta.template as<S>(), count(f, k), w);
        }();
        value_of<F> total = evaluated(f.get(k) * row[0]);
        for (std::size_t n = 1; n < row.size(); ++n) total = evaluated(total + f.get(point(k, static_cast<index_type>(n))) * row[n]);
        return total;
    }
    /// C^m C^beta f_k: |m| differences or sums of C^beta f.
    template <class Order, class F>
    static value_of<F> value(Order const& order, F const& f, index_type k) {
        auto const [m, beta] = whole_and_rest(order);
        index_type const all = count(f, k), size = m < 0 ? all : std::min<index_type>(all, m + 1);
        std::vector<value_of<F>> x;
        for (index_type n = 0; n < size; ++n) x.push_back(fraction_at(beta, f, point(k, n)));
        auto const at = [&](index_type n) -> value_of<F>& { return x[static_cast<std::size_t>(n)]; };
        for (int i = 0; i < m; ++i)
            for (index_type n = 0; n < size; ++n) // the last ones are not used where points are left out
                at(n) = evaluated((n + 1 < size ? value_of<F>(at(n) - at(n + 1)) : at(n)) / graininess(f, point(k, n)));
        for (int i = 0; i < -m; ++i)
            for (index_type n = size; n-- > 0;) {
                at(n) = evaluated(at(n) * graininess(f, point(k, n)));
                if (n + 1 < size) at(n) = evaluated(at(n) + at(n + 1));
            }
        return x.front();
    }
    /// On the generic scale, which has its own weights.
    template <class Order, class F>
    static constexpr value_of<F> generic_value(Order const& order, F const& f, index_type k) {
        value_of<F> total = f.get(k) * f.root().template power_entry<W>(order, k, k);
        for (index_type n = 1; n < count(f, k); ++n)
            total = total + f.get(point(k, n)) * f.root().template power_entry<W>(order, k, point(k, n));
        return total;
    }
};

} // namespace hilger::detail
