// SPDX-License-Identifier: BSL-1.0
// Identities of the calculus, on T and on every scale derived from it: the fundamental theorem, the Leibniz rules, shifts of derivatives,
// and the points without a derivative.
#pragma once

#include "hilger/operator/integral.hpp"
#include "identities/trial.hpp"

namespace hilger::identities {

/// int_s^t Delta_plus[f] Delta = f(t) - f(s) for all s, t in either order; the same from the left.
template <class Base>
struct fundamental_theorem : stated<"fundamental theorem", "S (8)"> {
    void operator()(auto& trial) const {
        auto const scale = derived_scale(trial.T.root(), domain<Base>{});
        auto const f = trial.function_on(scale);
        auto const forward = derivative<Base, side::plus>{}[f];
        auto const backward = derivative<Base, side::minus>{}[f];
        auto const size = trial.size_of(f) * trial.count() * 2;
        for (index_type i = 0; i <= f.last(); ++i)
            for (index_type j = 0; j <= f.last(); ++j) {
                auto const change = evaluated(f.get(j) - f.get(i));
                if (f.size() < 2) continue;
                trial.equal(detail::sum_between<delta_weight>(forward, i, j), change, size);
                trial.equal(detail::sum_between<nabla_weight>(backward, i, j), change, size);
            }
    }
};

/// Delta_plus[int_a^t f Delta] = f on T^+, Delta_minus[int_a^t f nabla] = f on T^-.
struct derivative_of_integral : stated<"derivative of the antiderivative", "S (8)"> {
    void operator()(auto& trial) const {
        auto const f = trial.function_on(without_last(trial.T));
        auto const g = trial.function_on(without_first(trial.T));
        auto const size = trial.size_of(f) * trial.length() * trial.steepness() * trial.count();
        trial.equal_everywhere(Delta_plus[antiderivative[f]], f, size);
        trial.equal_everywhere(Delta_minus[antiderivative_nabla[g]], g,
                               trial.size_of(g) * trial.length() * trial.steepness() * trial.count());
    }
};

/// Delta_plus[int_a^t f Delta_lambda](t_i) = f(t_{i,lambda}).
template <class Lambda>
struct derivative_of_lambda_integral : stated<"derivative of the lambda-antiderivative", "S (8), (32)"> {
    void operator()(auto& trial) const {
        auto const f = trial.function_on(derived_scale(trial.T.root(), domain<between<Lambda>>{}));
        auto const F = antiderivative_at<Lambda>{}[f];
        trial.equal_everywhere(projection<Lambda, true>{}[Delta_plus[F]], f,
                               trial.size_of(f) * trial.length() * trial.steepness() * trial.count());
        trial.equal(F(trial.T.element(0)), trial.zero(), trial.size_of(f));
    }
};

/// Delta_plus[f g] = Delta_plus[f] g + f^sigma Delta_plus[g], Delta_minus[f g] = Delta_minus[f] g + f^rho Delta_minus[g].
template <class Base>
struct leibniz : stated<"Leibniz rules", "B (28), any scale"> {
    void operator()(auto& trial) const {
        auto const scale = derived_scale(trial.T.root(), domain<Base>{});
        auto const f = trial.function_on(scale);
        auto const g = trial.scalar_function_on(scale);
        constexpr derivative<Base, side::plus> D{};
        constexpr derivative<Base, side::minus> N{};
        auto const size = trial.size_of(f) * trial.size_of(g) * trial.steepness() * 8;
        trial.equal_everywhere(D[f * g], D[f] * g + shift<Base, side::plus>{}[f] * D[g], size);
        trial.equal_everywhere(N[f * g], N[f] * g + shift<Base, side::minus>{}[f] * N[g], size);
    }
};

/// Delta_minus[f g^sigma] = Delta_minus[f] g + f Delta_plus[g] on T^+-. (B writes Delta_+ with the opposite sign.)
struct leibniz_shifted : stated<"Leibniz rule with a shift", "B (28)", /*uniform_only=*/true> {
    void operator()(auto& trial) const {
        auto const f = trial.function_on(trial.T);
        auto const g = trial.scalar_function_on(trial.T);
        trial.equal_everywhere(Delta_minus[f * sigma[g]], Delta_minus[f] * g + f * Delta_plus[g],
                               trial.size_of(f) * trial.size_of(g) * trial.steepness() * 4);
    }
};

/// f^sigma = f + mu Delta_plus[f], f^rho = f - nu Delta_minus[f].
template <class Base>
struct shift_and_graininess : stated<"shift and graininess", "S (27)-(29)"> {
    void operator()(auto& trial) const {
        auto const scale = derived_scale(trial.T.root(), domain<Base>{});
        auto const f = trial.function_on(scale);
        auto const up = derivative<Base, side::plus>{}[f];
        auto const down = derivative<Base, side::minus>{}[f];
        for (index_type i = f.first(); i < f.last(); ++i) {
            auto const t = scale.element(i), s = scale.element(i + 1);
            trial.equal(shift<Base, side::plus>{}[f](t), evaluated(f(t) + up(t) * scale.mu(t)), trial.size_of(f) * 2);
            trial.equal(shift<Base, side::minus>{}[f](s), evaluated(f(s) - down(s) * scale.nu(s)), trial.size_of(f) * 2);
            trial.require(scale.sigma(t) == s and scale.rho(s) == t, "sigma and rho are inverse to each other");
        }
    }
};

/// sigma: C(T^-) -> C(T^+) and rho: C(T^+) -> C(T^-) are inverse bijections, and Delta_plus = sigma Delta_minus.
template <class Base>
struct shifts_are_inverse : stated<"sigma and rho are inverse", "S definition 3"> {
    void operator()(auto& trial) const {
        auto const scale = derived_scale(trial.T.root(), domain<Base>{});
        auto const f = trial.function_on(without_first(scale));
        auto const g = trial.function_on(without_last(scale));
        constexpr shift<Base, side::plus> up{};
        constexpr shift<Base, side::minus> down{};
        trial.equal_everywhere(down[up[f]], f, trial.size_of(f));
        trial.equal_everywhere(up[down[g]], g, trial.size_of(g));
        auto const h = trial.function_on(scale);
        trial.equal_everywhere(up[derivative<Base, side::minus>{}[h]], derivative<Base, side::plus>{}[h], trial.size_of(h));
    }
};

/// T^kappa: on a scale whose last point is isolated the Delta derivative is undefined there, and has no substitute value.
template <class Base>
struct t_kappa : stated<"T^kappa", "S definition 6"> {
    void operator()(auto& trial) const {
        auto const scale = derived_scale(trial.T.root(), domain<Base>{});
        auto const f = trial.function_on(scale);
        auto const up = derivative<Base, side::plus>{}[f];
        auto const down = derivative<Base, side::minus>{}[f];
        trial.require(up.scale() == without_last(scale) and down.scale() == without_first(scale),
                      "Delta_plus lives on T^+ and Delta_minus on T^-");
        trial.require(refuses([&] { return up(scale.element(scale.last())); }), "Delta_plus has no value at the last point");
        trial.require(refuses([&] { return down(scale.element(scale.first())); }), "Delta_minus has no value at the first point");
    }

private:
    template <class Evaluation>
    static bool refuses(Evaluation const& evaluation) {
        try {
            evaluation();
        } catch (error::outside_domain const&) {
            return true;
        }
        return false;
    }
};

} // namespace hilger::identities
