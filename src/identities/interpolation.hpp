// SPDX-License-Identifier: BSL-1.0
// From discrete functions to functions on [a, b] and back: the maps iota and pi of the commuting diagrams (Cresson-Safi (30), (33), (34)).
//   interpolate(f)      iota_1: the continuous piecewise linear function through f
//   steps_of(f)         iota_0: the right-continuous step function with value f(t_i) on [t_i, t_{i+1}[
#pragma once

#include "hilger/function/function.hpp"

namespace hilger {

namespace detail {
/// The number i of the cell [t_i, t_{i+1}[ of T that holds t; the last cell holds b too. @throws error::outside_domain
template <class Scale, class S>
constexpr index_type cell_of(Scale const& T, S const& t) {
    if (not(T.element(T.first()) <= t) or not(t <= T.element(T.last()))) // NaN is outside too
        error::raise<error::outside_domain>(t, " is outside the interval [", T.element(T.first()), ", ", T.element(T.last()), "]");
    index_type low = T.first(), high = T.last();
    while (high - low > 1) {
        index_type const middle = low + (high - low) / 2;
        (t < T.element(middle) ? high : low) = middle;
    }
    return low;
}
} // namespace detail

/// iota_1 f: continuous, linear between neighbouring points of f's scale.
template <discrete_function F>
class piecewise_linear {
    using S = typename F::root_type::scalar_type;

public:
    explicit constexpr piecewise_linear(F f) : f_(std::move(f)) {}
    /// @throws error::outside_domain when t is outside [a, b].
    constexpr auto operator()(S const& t) const {
        auto const T = f_.scale();
        index_type const i = detail::cell_of(T, t);
        return value_of<F>(f_.get(i) + slope(i) * S(t - T.element(i)));
    }
    /// The right derivative d^+/dt at t in [a, b[. @throws error::outside_domain
    constexpr auto right_derivative(S const& t) const {
        auto const T = f_.scale();
        if (t == T.element(T.last()))
            error::raise<error::outside_domain>("there is no right derivative at ", t, ", the end of the interval");
        return slope(detail::cell_of(T, t));
    }

private:
    constexpr auto slope(index_type i) const { return value_of<F>((f_.get(i + 1) - f_.get(i)) / f_.domain().base.step(f_.root(), i)); }
    F f_;
};

/// iota_{0,lambda} f for f on T_lambda, T or T^+: f(t_{i,lambda}) on the cell [t_i, t_{i+1}[ of T.
template <discrete_function F>
class piecewise_constant {
    using S = typename F::root_type::scalar_type;

public:
    explicit constexpr piecewise_constant(F f) : f_(std::move(f)) {}
    constexpr auto operator()(S const& t) const { return f_.element(detail::cell_of(T(), t)); }
    /// int_a^t ds, the continuous integral of the step function.
    constexpr auto integral_to(S const& t) const {
        auto const scale = T();
        index_type const i = detail::cell_of(scale, t);
        auto total = value_of<F>(f_.get(i) * S(t - scale.element(i)));
        for (index_type k = 0; k < i; ++k) total = total + f_.get(k) * S(scale.element(k + 1) - scale.element(k));
        return total;
    }

private:
    constexpr auto T() const { return derived_scale(f_.root(), hilger::domain<nodes>{}); }
    F f_;
};

template <discrete_function F>
constexpr auto interpolate(F f) {
    return piecewise_linear<F>(std::move(f));
}
template <discrete_function F>
constexpr auto steps_of(F f) {
    return piecewise_constant<F>(std::move(f));
}

} // namespace hilger
