// SPDX-License-Identifier: BSL-1.0
// Equations (15) and (20) to (22) of F. Jimenez and S. Ober-Bloebaum (2019), from their sums: what the flows make solves them, and y is x
// in reversed time. With 2 alpha = 1 everything is rational, h^-alpha twice being 1/h.
#include <algorithm>
#include <vector>

#include <doctest/doctest.h>

#include "hilger/fractional/flow.hpp"
#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace jimenez_equations_tests {

using namespace hilger;

namespace {

/// alpha_n of (15)
template <class S>
std::vector<S> weights(S const& alpha, std::size_t count) {
    std::vector<S> w{S(1)};
    for (std::size_t n = 1; n < count; ++n) {
        int const k = static_cast<int>(n);
        w.push_back(w.back() * (S(k - 1) - alpha) / S(k));
    }
    return w;
}
/// h^alpha Delta_-^alpha x on all of T; from the point `first` on, 0 before it.
template <class S>
std::vector<S> minus_difference(S const& alpha, std::vector<S> const& x, std::size_t first = 0) {
    auto const w = weights(alpha, x.size());
    std::vector<S> d(x.size(), S(0));
    for (std::size_t k = first; k < x.size(); ++k)
        for (std::size_t n = 0; n <= k; ++n) d[k] += w[n] * x[k - n];
    return d;
}
/// h^alpha Delta_+^alpha x
template <class S>
std::vector<S> plus_difference(S const& alpha, std::vector<S> const& x) {
    auto const w = weights(alpha, x.size());
    std::vector<S> d(x.size(), S(0));
    for (std::size_t k = 0; k < x.size(); ++k)
        for (std::size_t n = 0; n + k < x.size(); ++n) d[k] += w[n] * x[k + n];
    return d;
}
template <class S>
struct run {
    std::vector<S> x, p;
};
template <class S, class Order>
run<S> walk(Order beta, S const& rho, S const& h, damping_at at, initial_history history) {
    auto const L = lagrangian{[](auto const& x, auto const& v) { return v * v / 2 - x * x; }}; // U = x^2, U' = 2x
    auto const flow = embed(with_fractional_impulses(L, rho, beta, direct{}, {.at = at, .history = history}), mid_point);
    run<S> made;
    for (auto const& z : flow.along(uniform(S(0), h, 12), S(2) / S(3), S(-1) / S(4))) {
        made.x.push_back(z.q);
        made.p.push_back(z.p);
    }
    return made;
}
/// The left-hand side of (20) less its right-hand side at an inner point k, the damping given; the same for x and for y.
template <class S>
S residual(std::vector<S> const& x, std::size_t k, S const& h, S const& damping) {
    S const ahead = x[k + 1] + x[k], behind = x[k] + x[k - 1];
    return (x[k + 1] - 2 * x[k] + x[k - 1]) / (h * h) + ahead / 2 + behind / 2 + damping;
}
/// (20) for x and, reversed, for y, and (21) or remark 2 for p; `scale` is h^{-2 alpha}.
template <class S, class Order, class Zero>
void solves_20_and_21(Order beta, S const& alpha, S const& scale, S const& h, Zero const& is_zero) {
    S const rho = S(2) / S(5);
    for (auto const at : {damping_at::start, damping_at::end}) {
        auto const [x, p] = walk<S>(beta, rho, h, at, initial_history::riemann_liouville);
        auto const d = minus_difference(alpha, minus_difference(alpha, x));
        std::vector<S> y(x.rbegin(), x.rend());
        auto const e = plus_difference(alpha, plus_difference(alpha, y));
        for (std::size_t k = 1; k + 1 < x.size(); ++k) {
            CHECK(is_zero(residual(x, k, h, S(rho * scale * d[k]))));
            CHECK(is_zero(residual(y, k, h, S(rho * scale * e[k]))));
            if (2 * k + 1 != x.size()) CHECK_FALSE(is_zero(residual(y, k, h, S(rho * scale * d[k])))); // y is not damped as x is
        }
        S const early = at == damping_at::start ? S(1) : S(0), late = S(1) - early;
        for (std::size_t k = 0; k + 1 < x.size(); ++k) {
            S const v = (x[k + 1] - x[k]) / h, half_force = h / 2 * (x[k + 1] + x[k]);
            CHECK(is_zero(S(v + half_force + early * h * rho * scale * d[k] - p[k])));           // (21a)
            CHECK(is_zero(S(v - half_force - late * h * rho * scale * d[k + 1] - p[k + 1])));    // (21b)
            CHECK_FALSE(is_zero(S(v + half_force + early * h * rho * scale * d[k] - p[k + 1]))); // v_k^- is not v_{k+1}^+
        }
    }
}

} // namespace

TEST_CASE("(20), (21), remark 2: the flows solve them, and y is x in reversed time") {
    SUBCASE("2 alpha = 1, exactly") {
        solves_20_and_21<Q>(fraction<1>{}, Q(1, 2), Q(7), Q(1, 7), [](Q const& r) { return r == 0; });
    }
    SUBCASE("2 alpha = 1/2 and 3/2, in 50 digits") {
        // Values of size 1 are divided by h^2 = 1/49; a dozen of them are added.
        auto const is_zero = [](float50 const& r) { return abs(r) < 2000 * epsilon<float50>(); };
        float50 const h = float50(1) / 7;
        solves_20_and_21<float50>(fraction<1, 2>{}, float50(1) / 4, sqrt(float50(7)), h, is_zero);
        solves_20_and_21<float50>(fraction<3, 2>{}, float50(3) / 4, float50(7 * sqrt(float50(7))), h, is_zero);
    }
}

TEST_CASE("(22): the half differences compose to Delta_- where they include t_0, and do not without its row") {
    std::vector<Q> const x{Q(2, 3), Q(-1), Q(4), Q(1, 5), Q(3)};
    auto const all = minus_difference(Q(1, 2), minus_difference(Q(1, 2), x));
    auto const cut = minus_difference(Q(1, 2), minus_difference(Q(1, 2), x, 1), 1);
    for (std::size_t k = 1; k < x.size(); ++k) {
        CHECK(all[k] == x[k] - x[k - 1]);
        CHECK(cut[k] != x[k] - x[k - 1]);
    }
    CHECK(all[0] == x[0]); // not zero: (20) kicks a system that starts at x_0 != 0
}

TEST_CASE("the kick at t_0: Riemann and Liouville's first step depends on where zero is, Caputo's does not") {
    Q const h(1, 7), rho(2, 5);
    auto const first = [&](initial_history history) { return walk<Q>(fraction<1>{}, rho, h, damping_at::start, history); };
    auto const printed = first(initial_history::riemann_liouville), physical = first(initial_history::caputo);
    // The step's own equation (x_1 - x_0) / h + (h/2) (x_1 + x_0) = p_0 - h rho d has the impulses d = x_0 / h and d = v_0.
    auto const impulse = [&](run<Q> const& z) -> Q { return (z.p[0] - (z.x[1] - z.x[0]) / h - h / 2 * (z.x[1] + z.x[0])) / (h * rho); };
    CHECK(impulse(printed) == Q(2, 3) / h);
    CHECK(impulse(physical) == Q(-1, 4));
}

TEST_CASE("(19): summed to N - 1 it has an end term that (20) for y has not; summed to N it has none") {
    hilger::index_type const N = 6;
    auto const T = uniform(Q(0), Q(1), N);
    auto const x = function_on(T, [](Q const& t) { return Q(t * t - 3 * t + 2); });
    auto const y = function_on(T, [](Q const& t) { return Q(5 / (t + 1) - t); });
    auto const w = first_weights<grunwald_letnikov>(Q(1, 4), N + 1);
    auto const dx = Delta_minus_alpha<1, 4>[x];
    auto const dy = Delta_plus_alpha<1, 4>[y];
    auto const of_x = Delta_minus_alpha<1, 2>[x];
    auto const of_y = Delta_plus_alpha<1, 2>[y];
    for (hilger::index_type n = 1; n < N; ++n) {
        // d/d epsilon of sum_k (Delta_-^alpha x)_k (Delta_+^alpha y)_k for x and y varied at t_n alike
        auto const variation = [&](hilger::index_type last) {
            Q sum(0);
            for (hilger::index_type k = 0; k <= last; ++k) {
                if (k >= n) sum += w[static_cast<std::size_t>(k - n)] * dy[k];
                if (k <= n) sum += w[static_cast<std::size_t>(n - k)] * dx[k];
            }
            return sum;
        };
        CHECK(variation(N) == of_x[n] + of_y[n]);
        CHECK(variation(N - 1) == of_x[n] + of_y[n] - w[static_cast<std::size_t>(N - n)] * y[N]);
    }
}

} // namespace jimenez_equations_tests
