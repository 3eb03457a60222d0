// SPDX-License-Identifier: BSL-1.0
// The order of a flow of u'' + c D^beta u + u = 0 against the series, from u_0 != 0 and v_0 != 0.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "hilger/fractional/flow.hpp"
#include "series.hpp"

namespace hilger::testing {

inline constexpr lagrangian spring{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
inline constexpr double c = 0.7, u0 = 1.0, v0 = -0.5;

template <class Order>
fractional_oscillator<double>::value reference(Order beta, initial_history history) {
    fractional_oscillator<float50> const wide{float50(c), beta.template as<float50>(),       1, float50(u0), float50(v0),
                                              0,          history == initial_history::caputo};
    auto const [u, v] = wide.at(1);
    return {static_cast<double>(u), static_cast<double>(v)};
}
/// The orders in position and momentum at t = 1: p = v.
template <class Flow, class Order>
std::array<double, 2> orders_of(Flow const& flow, Order beta, initial_history history) {
    auto const exact = reference(beta, history);
    std::vector<double> eq, ep;
    for (int const N : {512, 1024, 2048}) {
        state<double, double> last;
        for (auto const& x : flow.along(uniform(interval{0.0, 1.0}, N), u0, v0)) last = x;
        eq.push_back(std::abs(last.q - exact.u));
        ep.push_back(std::abs(last.p - exact.v));
    }
    return {fitted_slope(eq), fitted_slope(ep)};
}

/// All positions of a run.
template <class Flow, class Scale, class V>
std::vector<V> positions(Flow const& flow, Scale const& T, V const& q0, V const& p0) {
    std::vector<V> q;
    for (auto const& x : flow.along(T, q0, p0)) q.push_back(x.q);
    return q;
}

} // namespace hilger::testing
