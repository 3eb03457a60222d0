// SPDX-License-Identifier: BSL-1.0
// The commuting diagrams between discrete functions and piecewise polynomial functions on [a, b] (Cresson-Safi (30), (34)), the extension
// as interpolation (after definition 4), and the mid-point rule as the trapezoid rule (36).
#pragma once

#include "hilger/operator/integral.hpp"
#include "identities/interpolation.hpp"
#include "identities/trial.hpp"

namespace hilger::identities {

/// Delta_plus = pi o d^+/dt o iota_1.
template <class Base>
struct derivative_diagram : stated<"diagram of the derivative", "S (30)"> {
    void operator()(auto& trial) const {
        auto const scale = derived_scale(trial.T.root(), domain<Base>{});
        auto const f = trial.function_on(scale);
        auto const D = derivative<Base, side::plus>{}[f];
        auto const curve = interpolate(f);
        for (index_type i = D.first(); i <= D.last(); ++i) {
            auto const t = scale.element(i);
            trial.equal(D(t), curve.right_derivative(t), trial.size_of(f) * trial.steepness() * 4);
        }
    }
};

/// int_a^t . Delta_lambda = pi o int_a^t ds o iota_0.
template <class Lambda>
struct integral_diagram : stated<"diagram of the antiderivative", "S (34)"> {
    void operator()(auto& trial) const {
        auto const f = trial.function_on(derived_scale(trial.T.root(), domain<between<Lambda>>{}));
        auto const F = antiderivative_at<Lambda>{}[f];
        auto const staircase = steps_of(f);
        auto const size = trial.size_of(f) * trial.length() * trial.count();
        for (index_type i = 0; i <= F.last(); ++i) {
            auto const t = F.scale().element(i);
            trial.equal(F(t), staircase.integral_to(t), size);
            trial.equal(F(t), integral(f, trial.T.element(0), t), size);
        }
    }
};

/// f_{o,lambda} is iota_1[f] at the points of T_{o,lambda}.
template <class Lambda>
struct extension_is_interpolation : stated<"extension as interpolation", "S definition 4 (24)"> {
    template <class Trial>
    void operator()(Trial& trial) const {
        auto const f = trial.function_on(trial.T);
        auto const f_o = extension<Lambda>{}[f];
        auto const curve = interpolate(f);
        auto const scale = f_o.scale();
        // The slope magnifies the rounding of the points.
        auto const size = trial.size_of(f) * (trial.steepness() * trial.length() + typename Trial::scalar(1)) * 4;
        for (index_type j = 0; j <= f_o.last(); ++j) trial.equal(f_o[j], curve(scale.element(j)), size);
    }
};

/// int f_o Delta_half = sum (f(t_i) + f(t_{i+1}))/2 (t_{i+1} - t_i), the trapezoid rule.
struct midpoint_quadrature : stated<"mid-point quadrature", "S (36)"> {
    template <class Trial>
    void operator()(Trial& trial) const {
        using S = typename Trial::scalar;
        auto const f = trial.function_on(trial.T);
        auto total = trial.zero();
        for (index_type i = 0; i < f.last(); ++i)
            total = total + evaluated((f[i] + f[i + 1]) / S(2)) * S(trial.T.element(i + 1) - trial.T.element(i));
        trial.equal(integral(extend[f], half(trial.T)), total, trial.size_of(f) * trial.length() * trial.count());
        trial.equal(weighted_sum<mean_weight<fraction<1, 2>>>(f), total, trial.size_of(f) * trial.length() * trial.count());
    }
};

} // namespace hilger::identities
