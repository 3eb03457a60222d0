// SPDX-License-Identifier: BSL-1.0
// The value of a power of the difference C f_k = (f_k - f_{k-1}) / w_k at a point of any T, or of C f_k = (f_k - f_{k+1}) / w_k, with the
// graininess w = nu or mu: C^alpha = C^m C^beta, m whole and 0 <= beta < 1. f is 0 outside T.
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
    return {whole, order};
}
/// An order as p/q. @throws error::invalid_parameter where q is beyond 1000
template <class S, class Order>
std::pair<int, int> quotient_of(Order const& order) {
    constexpr int largest = 1000; // the cost of a row grows like q
    auto const refuse_beyond = [&](auto const& q) {
        if (q > largest)
            error::raise<error::invalid_parameter>(
                "in an exact scalar the order of a fractional difference on uneven steps has a denominator "
                "up to ",
                largest, ", and this one is ", q);
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
    template <class Root>
    static constexpr auto graininess(Root const& T, index_type k) {
        return typename Root::scalar_type(T.step(continued_weight<W>::step_number(T, k)));
    }
    /// C^beta f_k, by the sum with the weights of row k: O(k) times the nodes of their integral.
    template <class Beta, class F>
    static constexpr value_of<F> fraction_at(Beta const& beta, F const& f, index_type k) {
        using S = typename F::root_type::scalar_type;
        auto const& T = f.root();
        auto const point = [&](index_type n) { return Side == side::minus ? k - n : k + n; };
        index_type const count = 1 + (Side == side::minus ? k - f.domain().first(T) : f.domain().last(T) - k);
        if (beta.template as<S>() == S(0)) return f.get(k);
        auto const sum = [&](auto const& entry) {
            value_of<F> total = evaluated(f.get(k) * entry(0));
            for (index_type n = 1; n < count; ++n) total = evaluated(total + f.get(point(n)) * entry(n));
            return total;
        };
        if constexpr (requires { T.template power_entry<W>(beta, k, k); })
            return sum([&](index_type n) { return T.template power_entry<W>(beta, k, point(n)); });
        else {
            auto const w = [&](index_type n) { return graininess(T, point(n)); };
            auto const row = [&] {
                if constexpr (std::numeric_limits<S>::is_exact) {
                    auto const [p, q] = quotient_of<S>(beta);
                    return exact_power_row<S>(p, q, count, w);
                } else
                    return power_row(beta.template as<S>(), count, w);
            }();
            return sum([&](index_type n) -> S const& { return row[static_cast<std::size_t>(n)]; });
        }
    }
    /// C^m C^beta f_k.
    template <class Beta, class F>
    static constexpr value_of<F> value(int m, Beta const& beta, F const& f, index_type k) {
        if (m == 0) return fraction_at(beta, f, k);
        value_of<F> const here = value(m - 1, beta, f, k);
        index_type const next = Side == side::minus ? k - 1 : k + 1;
        auto const w = graininess(f.root(), k);
        if (next < f.domain().first(f.root()) or next > f.domain().last(f.root())) return evaluated(here / w);
        return evaluated((here - value(m - 1, beta, f, next)) / w);
    }
};

} // namespace hilger::detail
