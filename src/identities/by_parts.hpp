// SPDX-License-Identifier: BSL-1.0
// Integration by parts: the formulae of Cresson-Safi in their correct form, and the general law for any operator. If an integrand is
// undefined at an end point, the sum runs over the inner points only.
#pragma once

#include "hilger/adjoint/adjoint.hpp"
#include "identities/trial.hpp"

namespace hilger::identities {

/// int f Delta_plus[g] Delta = [f g]_a^b - int Delta_minus[f] g nabla. Printed with the Delta integral on the right, which is false.
template <class Base>
struct by_parts_order_one : stated<"integration by parts, order one", "S (9), corrected"> {
    void operator()(auto& trial) const {
        auto const scale = derived_scale(trial.T.root(), domain<Base>{});
        auto const f = trial.function_on(scale);
        auto const g = trial.function_on(scale);
        if (scale.size() < 2) return;
        auto const left = weighted_sum<delta_weight>(dot(f, derivative<Base, side::plus>{}[g]));
        auto const right = boundary(dot(f, g)) - weighted_sum<nabla_weight>(dot(derivative<Base, side::minus>{}[f], g));
        trial.equal(left, right, trial.size_of(f) * trial.size_of(g) * trial.count() * 16);
    }
};

/// Delta_o_plus[f_o](t_{i+1/2}) = Delta_plus[f](t_i), for any lambda.
template <class Lambda>
struct lemma_1 : stated<"derivative of the extension", "S lemma 1 (37)"> {
    void operator()(auto& trial) const {
        auto const f = trial.function_on(trial.T);
        constexpr auto left = restriction_to<Lambda, false>{} * derivative<joined<Lambda>, side::plus>{} * extension<Lambda>{};
        trial.equal_everywhere(left[f], (projection<Lambda, true>{} * Delta_plus)[f], trial.size_of(f) * trial.steepness() * 8);
    }
};

/// int f Delta_o_plus[v_o] Delta_half = - int Delta_{half,-}[f](sigma_o t) v(t) + f(t_{N-1/2}) v(t_N) - f(t_{1/2}) v(t_0), the sum on the
/// right over T^+- with the trapezoid weights, which are h on a uniform scale.
struct lemma_2 : stated<"integration by parts, mid-point", "S lemma 2 (38)"> {
    void operator()(auto& trial) const {
        auto const f = trial.function_on(circ(trial.T));
        auto const v = trial.function_on(trial.T);
        auto const f_half = on_half[f];
        auto const left = integral(dot(f, Delta_o_plus[extend[v]]), half(trial.T));
        auto const right = dot_product(f_half[f_half.last()], v[v.last()]) - dot_product(f_half[f_half.first()], v[v.first()]) -
                           inner_sum(dot(pi_half[Delta_h_minus[f_half]], v));
        trial.equal(left, evaluated(right), trial.size_of(f) * trial.size_of(v) * trial.count() * 8 * 3);
    }
    /// Sum over T^+- with weights (mu + nu)/2.
    template <class F>
    static auto inner_sum(F const& f) {
        return weighted_sum<mean_weight<fraction<1, 2>>>(f);
    }
};

/// int f v_o Delta_half = int [f]_o v + (h/2)(f(t_{N-1/2}) v(t_N) + f(t_{1/2}) v(t_0)), and the same with [f]_{half,-} o sigma_o. Printed
/// with the factor h, which is false. The sum on the right runs over T^+-.
struct lemma_3 : stated<"adjoint of the extension, uniform", "S lemma 3 (40), (41), corrected", /*uniform_only=*/true> {
    template <class Trial>
    void operator()(Trial& trial) const {
        using S = typename Trial::scalar;
        auto const f = trial.function_on(half(trial.T));
        auto const v = trial.function_on(trial.T);
        S const h = trial.T.root().step(0);
        auto const left = integral(dot(f, (on_half * extend)[v]), half(trial.T));
        S const ends = dot_product(f[f.last()], v[v.last()]) + dot_product(f[0], v[0]);
        S const size = trial.size_of(f) * trial.size_of(v) * trial.length() * 8 * 3;
        // (40) takes a function on T_o; its values on T do not matter.
        auto const f_circ = insertion<fraction<1, 2>, false>{}[f] + insertion<fraction<1, 2>, true>{}[v];
        trial.equal(left, S(weighted_sum<delta_weight>(dot(mean_o[f_circ], v)) + h / S(2) * ends), size);
        trial.equal(left, S(weighted_sum<delta_weight>(dot(pi_half[mean_h_minus[f]], v)) + h / S(2) * ends), size);
    }
};

/// The same on any scale: the adjoint of v -> v_lambda is the mean weighted by the steps, and the end terms carry the first and
/// the last step.
template <class Lambda>
struct step_mean_is_adjoint : stated<"adjoint of the extension, any scale", "S lemma 3, generalised"> {
    template <class Trial>
    void operator()(Trial& trial) const {
        using S = typename Trial::scalar;
        constexpr S (*as)() = &Lambda::template as<S>;
        auto const scale = derived_scale(trial.T.root(), domain<between<Lambda>>{});
        auto const f = trial.function_on(scale);
        auto const v = trial.function_on(trial.T);
        index_type const N = trial.T.root().steps();
        auto const left = weighted_sum<step_weight>(dot(f, (restriction_to<Lambda, false>{} * extension<Lambda>{})[v]));
        S const first = trial.T.root().step(0) * (S(1) - as()) * dot_product(f[0], v[0]);
        S const last = trial.T.root().step(N - 1) * as() * dot_product(f[N - 1], v[N]);
        auto const inner = weighted_sum<natural_weight_t<Lambda>>(dot(step_mean_at<Lambda>{}[f], v));
        trial.equal(left, S(inner + first + last), trial.size_of(f) * trial.size_of(v) * trial.length() * 8 * 3);
    }
};

/// <A f, g> = <f, adjoint(A) g> + boundary_form(A, f, g), with the operator's own weights.
template <class A>
struct by_parts_of : stated<"integration by parts of an operator", "S lemmas 2, 3; B lemma 2"> {
    [[no_unique_address]] A a;
    constexpr explicit by_parts_of(A op) : a(std::move(op)) {}
    template <class Trial>
    void operator()(Trial& trial) const {
        auto const f = trial.function_on(derived_scale(trial.T.root(), domain<typename A::from>{}));
        auto const image = derived_scale(trial.T.root(), a.image(domain<typename A::from>{}));
        if (image.empty()) return;
        auto const g = trial.function_on(image);
        auto const parts = by_parts(a, f, g);
        using std::max;
        auto const steep = max(trial.steepness(), typename Trial::scalar(1));
        auto const reach = max(trial.length(), typename Trial::scalar(1));
        trial.equal(parts.left, evaluated(parts.interior + parts.boundary),
                    trial.size_of(f) * trial.size_of(g) * trial.count() * trial.count() * steep * steep * reach * reach * 8);
    }
};

/// adjoint(adjoint(A)) = A at every point where the left-hand side is defined.
template <class A>
struct adjoint_is_involution : stated<"adjoint of the adjoint", "definition of the adjoint"> {
    [[no_unique_address]] A a;
    constexpr explicit adjoint_is_involution(A op) : a(std::move(op)) {}
    template <class Trial>
    void operator()(Trial& trial) const {
        auto const f = trial.function_on(derived_scale(trial.T.root(), domain<typename A::from>{}));
        auto const twice = adjoint(adjoint(a))[f];
        auto const once = a[f];
        auto const steep = trial.steepness() + typename Trial::scalar(1);
        for (index_type i = std::max(twice.first(), once.first()); i <= std::min(twice.last(), once.last()); ++i)
            trial.equal(twice[i], once[i], trial.size_of(f) * trial.count() * steep * steep * (trial.length() + typename Trial::scalar(1)));
    }
};

/// Discrete Dubois-Reymond: if int f v Delta = 0 for all v with v(a) = v(b) = 0 then f = 0 on T^+-. As a statement about rank: the
/// pairings with the basis of such v have rank N - 1, and vanish exactly on functions supported at the ends.
struct lemma_4 : stated<"discrete Dubois-Reymond", "S lemma 4 (42)"> {
    template <class Trial>
    void operator()(Trial& trial) const {
        using S = typename Trial::scalar;
        index_type const N = trial.T.root().steps();
        // The matrix <e_j, v> for random v_1..v_{N-1} that vanish at the ends, by elimination with full pivoting.
        std::vector<std::vector<S>> rows;
        for (index_type r = 0; r < N - 1; ++r) {
            auto const raw = trial.scalar_function_on(trial.T);
            std::vector<S> row;
            for (index_type j = 0; j <= N; ++j) {
                bool const end = j == 0 or j == N;
                S const v = end ? S(0) : j == r + 1 ? S(raw[j] + S(200)) : raw[j] / S(200); // dominant diagonal: a basis
                row.push_back(S(v * weight_at<delta_weight>(raw, j)));
            }
            rows.push_back(std::move(row));
        }
        trial.require(rank(rows) == N - 1, "the variations that vanish at the ends separate the inner values");
        for (auto const& row : rows) trial.require(row.front() == S(0) and row.back() == S(0), "the end values of f do not enter");
    }

private:
    template <class S>
    static index_type rank(std::vector<std::vector<S>> m) {
        index_type found = 0;
        std::size_t const columns = m.empty() ? 0 : m.front().size();
        for (std::size_t c = 0; c < columns and found < static_cast<index_type>(m.size()); ++c) {
            std::size_t best = static_cast<std::size_t>(found);
            for (std::size_t r = best; r < m.size(); ++r)
                if (magnitude(m[best][c]) < magnitude(m[r][c])) best = r;
            if (m[best][c] == S(0)) continue;
            std::swap(m[static_cast<std::size_t>(found)], m[best]);
            auto const& pivot = m[static_cast<std::size_t>(found)];
            for (std::size_t r = static_cast<std::size_t>(found) + 1; r < m.size(); ++r) {
                S const factor = m[r][c] / pivot[c];
                for (std::size_t k = c; k < columns; ++k) m[r][k] = m[r][k] - factor * pivot[k];
            }
            ++found;
        }
        return found;
    }
};

} // namespace hilger::identities
