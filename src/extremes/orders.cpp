// SPDX-License-Identifier: BSL-1.0
// Fractional orders near 0 and 1: weights against 50 digits, differences against their limits, and flows with fractional damping, which
// tend to one with another spring and to one with a dashpot (Kelvin-Voigt).
#include "extremes/apart.hpp"
#include "extremes/row.hpp"
#include "hilger/hilger.hpp"

namespace extremes {

namespace {

using namespace hilger;
using hilger::index_type;

struct order {
    double alpha;
    char const* name;
    double of_difference; ///< loss of N additions: for order 1e-15 whole terms, which are below half an epsilon of the first
};
constexpr order all_orders[]{
    {1e-300, "1e-300", 4}, {1e-15, "1e-15", 100}, {0.5, "1/2", 4}, {1 - 1e-15, "1 - 1e-15", 4}, {1, "1 at run time", 4}};

/// The largest relative error of the first weights, in epsilons, against the recurrences of both series in 50 digits.
template <class G>
double worst_weight(double alpha, int count) {
    bool const gear = std::same_as<G, bdf<2>>;
    float50 const a(alpha);
    weight_sequence<G, double> sequence(alpha);
    float50 before(0), now(1);
    double worst = in_epsilons(sequence.next(), now);
    for (int n = 1; n <= count; ++n) {
        float50 const one = (n - 1 - a) / n; // not 1 - (1 + a)/n, where 1e-300 is lost
        float50 const next = gear ? float50((4 * one * now - (n - 2 - 2 * a) / n * before) / 3) : float50(one * now);
        before = now;
        now = next;
        double const w = sequence.next();
        bool const ended = alpha == 1 and n > (gear ? 2 : 1);
        worst = std::max(worst, ended ? std::abs(w) / epsilon<double>() : in_epsilons(w, now));
    }
    return worst;
}

/// Delta_-^alpha[f] on [0, 2] against 50 digits, relative to the sum of the terms' magnitudes, in epsilons.
double worst_difference(double alpha) {
    index_type const N = 200;
    auto const T = uniform(0.0, 1.0 / 128, N);
    auto const f = tabulate(function_on(T, [](double t) { return 2 + std::cos(5 * t); }));
    auto const difference = Delta_minus(alpha)[f];
    auto const w = first_weights<grunwald_letnikov>(float50(alpha), N + 1);
    float50 const scale = pow(float50(T.h()), -float50(alpha));
    double worst = 0;
    for (index_type k = 0; k <= N; ++k) {
        float50 sum(0), size(0);
        for (index_type n = 0; n <= k; ++n) {
            float50 const term = w[static_cast<std::size_t>(n)] * f[k - n] * scale;
            sum += term;
            size += abs(term);
        }
        worst = std::max(worst, in_epsilons(difference[k], sum, size));
    }
    return worst;
}

constexpr int flow_steps = 1000;

template <class Flow, class Other>
double apart(Flow const& flow, Other const& other) {
    return extremes::apart(flow, other, uniform(0.0, 1.0 / 64, flow_steps), 1.0, 0.0);
}
template <class Order, class History>
auto damped(Order beta, History history, initial_history initial) {
    return embed(with_fractional_impulses(oscillator, 0.3, beta, history, {damping_at::start, initial}), order_one);
}

void flows(rows& all) {
    // Delta^beta q differs from its limit by beta (|ln h| + H_N) |q|, 12 epsilon for beta = 1e-15; each step rounds like a random walk, and
    // the damping forgets it.
    double const bound = 8 * std::sqrt(flow_steps);
    auto const spring = embed([](auto const& q, auto const& v) { return v * v / 2 - q * q / 2 - q * q * 3 / 20; }, order_one);
    auto const moved = embed([](auto const& q, auto const& v) { return v * v / 2 - q * q / 2 - (q - 1) * (q - 1) * 3 / 20; }, order_one);
    auto const rl = initial_history::riemann_liouville;
    auto const caputo = initial_history::caputo;
    all.push_back(kept("damping of order 1e-300: a spring, no loss", apart(damped(1e-300, direct{}, rl), spring), bound));
    all.push_back(kept("damping of order 1e-15: a spring, no loss", apart(damped(1e-15, direct{}, rl), spring), bound));
    all.push_back(kept("damping of order 1e-15, Caputo: a spring at q0", apart(damped(1e-15, exponentials{}, caputo), moved), bound));
    auto const voigt = damped(fraction<1>{}, direct{}, caputo);
    all.push_back(kept("damping of order 1 - 1e-15: Kelvin-Voigt", apart(damped(1 - 1e-15, blocks{}, caputo), voigt), bound / 4));
    all.push_back(kept("damping of order 1 at run time: Kelvin-Voigt", apart(damped(1.0, exponentials{}, caputo), voigt), 0));
}

} // namespace

rows orders(scope) {
    rows all;
    for (auto const& [alpha, name, of_difference] : all_orders) {
        int const count = alpha == 0.5 or alpha == 1 ? 1000 : 100'000;
        all.push_back(kept("weights up to n = " + few_digits(count) + ", order " + name, worst_weight<grunwald_letnikov>(alpha, count), 1));
        all.push_back(kept("weights of bdf<2> up to n = " + few_digits(count) + ", order " + name, worst_weight<bdf<2>>(alpha, count), 1));
    }
    for (auto const& [alpha, name, of_difference] : all_orders)
        all.push_back(kept(std::string("Delta_-^alpha[f] at 201 points, order ") + name, worst_difference(alpha), of_difference));
    flows(all);
    all.push_back(refused<error::invalid_parameter>("order 0 of a damping", [] { (void)damped(0.0, direct{}, initial_history::caputo); }));
    all.push_back(refused<error::invalid_parameter>("order 101 of a difference", [] { (void)Delta_minus(101.0); }));
    all.push_back(refused<error::invalid_parameter>("order NaN of a difference", [] { (void)Delta_minus(std::nan("")); }));
    return all;
}

} // namespace extremes
