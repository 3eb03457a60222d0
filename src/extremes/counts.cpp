// SPDX-License-Identifier: BSL-1.0
// Many points: weights, points, sums and steps, up to 10^8 in the report, and in the tests as many as fit into two seconds.
#include <cmath>

#include "extremes/row.hpp"
#include "hilger/hilger.hpp"

namespace extremes {

namespace {

using namespace hilger;
using hilger::index_type;

/// ln Gamma(x) in 50 digits, for x >= 1000 (Stirling; the first term left out is below 1e-50).
float50 log_gamma(float50 const& x) {
    static float50 const half_log_2pi = log(float50(8) * atan(float50(1))) / 2;
    // B_2k / (2k (2k - 1))
    static float50 const terms[]{float50(1) / 12,    float50(-1) / 360,       float50(1) / 1260,
                                 float50(-1) / 1680, float50(1) / 1188,       float50(-691) / 360360,
                                 float50(1) / 156,   float50(-3617) / 122400, float50(43867) / 244188};
    float50 sum = (x - float50(1) / 2) * log(x) - x + half_log_2pi, power = x;
    for (auto const& term : terms) {
        sum += term / power;
        power *= x * x;
    }
    return sum;
}
/// w_n = Gamma(n - alpha) / (Gamma(-alpha) Gamma(n + 1)), the quotient from n = 1000 on by its logarithms.
float50 weight(float50 const& alpha, long n) {
    float50 w(1);
    long const start = 1000;
    for (long k = 1; k <= start; ++k) w *= (k - 1 - alpha) / k;
    return w * exp(log_gamma(n - alpha) - log_gamma(float50(n + 1)) - log_gamma(start - alpha) + log_gamma(float50(start + 1)));
}
template <class S>
row weight_far_out(char const* what, S alpha, long n) {
    weight_sequence<grunwald_letnikov, S> sequence(alpha);
    for (long k = 0; k < n; ++k) (void)sequence.next();
    return kept(what + few_digits(static_cast<double>(n)), in_epsilons(sequence.next(), weight(float50(alpha), n)), 1);
}

void points(rows& all) {
    index_type const N = 100'000'000;
    double worst = 0, moved = 0;
    auto const T = uniform(0.0, 0.1, N), U = uniform(1.0 / 3, 0.1, N);
    bool found = true;
    for (index_type i = N - 1000; i < N; ++i) {
        worst = std::max(worst, in_epsilons(T.point(i), float50(float50(i) * 0.1)));
        moved = std::max(moved, in_epsilons(U.point(i), float50(float50(1.0 / 3) + float50(i) * 0.1)));
        found = found and U.number_of(U.point(i)) == i;
    }
    all.push_back(kept("points ih of T at i = 1e8: one rounding", worst, 0.5));
    all.push_back(kept("points a + ih of T at i = 1e8: two roundings", moved, 1));
    all.push_back(holds("each of the points there is found by its number", "number_of(point(i)) = i", found));
    all.push_back(refused<error::invalid_scale>("1e8 steps in float: h is lost beside b", [] { (void)uniform(0.0f, 0.1f, N); }));
}

void sums(rows& all, index_type N) {
    std::string const n = few_digits(static_cast<double>(N));
    // Sums of rounded products with h, and 2 epsilon for the sum, relative to the sum of magnitudes.
    auto const T = uniform(0.0, 0.1, N);
    float50 const exact = float50(N) * 0.1 * 0.3;
    all.push_back(
        kept("integral of a constant over points " + n, in_epsilons(integral(function_on(T, [](double) { return 0.3; }), T), exact), 2));
    all.push_back(kept("nabla integral of it", in_epsilons(nabla_integral(function_on(T, [](double) { return 0.3; }), T), exact), 2));
    all.push_back(kept("integral over T_half", in_epsilons(integral(function_on(half(T), [](double) { return 0.3; }), half(T)), exact), 2));
    all.push_back(kept("antiderivative at the last point",
                       in_epsilons(antiderivative_h[function_on(half(T), [](double) { return 0.3; })][N], exact), 2));
    // (-1)^i (i mod 1024): an exact sum with cancellation, relative to the sum of magnitudes
    auto const U = uniform(0.0, 0.0625, N);
    auto const f = function_on(U, [](double t) {
        auto const i = static_cast<long>(16 * t);
        return (i % 2 == 0 ? 0.1 : -0.1) * static_cast<double>(i % 1024 + 1);
    });
    float50 cancelled(0), size(0);
    long const blocks = N / 1024;
    for (long i = 0; i < 1024; ++i) {
        long const times = blocks + (i < N % 1024 ? 1 : 0);
        cancelled += float50(f[i]) * times / 16;
        size += abs(float50(f[i])) * times / 16;
    }
    all.push_back(kept("integral of what cancels, of the sum of magnitudes", in_epsilons(integral(f, U), cancelled, size), 2));
}

/// The change of the energy v^2/2 + q^2/2 of the oscillator after so many mid-point steps, which conserve it up to rounding.
template <class Flow>
double drift(Flow const& flow, index_type N) {
    auto const end = last_of(flow.along(uniform(0.0, 0.0625, N), 0.75, 0.5));
    float50 const start = float50(0.75) * 0.75 + 0.25;
    return in_epsilons(1.0, float50((float50(end.q) * end.q + float50(end.p) * end.p) / start));
}

} // namespace

rows counts(scope how) {
    bool const report = how == scope::report;
    rows all;
    all.push_back(weight_far_out("weight of order 1/2 at n = ", 0.5, report ? 100'000'000 : 1'000'000));
    all.push_back(weight_far_out("weight of order 1e-15 at n = ", 1e-15, report ? 100'000'000 : 1'000'000));
    all.push_back(weight_far_out("weight of order 1/4 in float at n = ", 0.25f, report ? 100'000'000 : 1'000'000));
    points(all);
    sums(all, report ? 100'000'000 : 1'000'000);
    index_type const N = report ? 10'000'000 : 1'000'000;
    std::string const n = few_digits(static_cast<double>(N));
    // Each step rounds q and p by at most half an epsilon: a random walk, with deviation sqrt(N/6). Five deviations.
    double const by_chance = 5 * std::sqrt(static_cast<double>(N) / 6);
    all.push_back(kept("energy of the oscillator, steps " + n, drift(embed(oscillator, mid_point), N), by_chance));
    // Exact sums leave the rounding of increments, which are h = 1/16 times smaller.
    all.push_back(kept("the same with compensated sums", drift(embed(oscillator, mid_point, compensated), N), by_chance / 16));
    return all;
}

} // namespace extremes
