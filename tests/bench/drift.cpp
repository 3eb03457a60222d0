// SPDX-License-Identifier: BSL-1.0
// What 10^9 steps leave of the energy. Mid-point keeps that of the oscillator exactly, so that what is seen is rounding; order one keeps
// that of the pendulum up to an error that comes and goes with the motion, and its mean over many periods drifts with rounding only.
#include <cmath>

#include "hilger/hilger.hpp"
#include "timing.hpp"

namespace bench {
namespace {

/// The relative change of the mean energy over 2^16 steps, from the first ones to the last of each decade.
template <class Flow, class Energy>
void follow(std::string const& name, Flow const& flow, double h, double steps, Energy const& energy) {
    using hilger::index_type;
    constexpr index_type window = 1 << 16;
    auto const N = static_cast<index_type>(steps);
    auto const begin = std::chrono::steady_clock::now();
    double q = 0, p = 0, sum = 0, first = 0;
    index_type from = 0, decade = 1'000'000;
    std::cout << name << "\n    steps     change of the mean energy\n";
    auto const path = flow.along(hilger::uniform(0.0, h, N), 1.0, 0.25);
    auto at = path.begin();
    // The loop that only steps is apart from the one that looks.
    auto const pass = [&](index_type count) {
        for (index_type i = 0; i < count; ++i) ++at;
    };
    // Weights that vanish with all their derivatives at both ends: what is periodic averages out, whatever its period.
    auto const mean = [&] {
        double total = 0, weights = 0;
        for (index_type i = 1; i <= window; ++i) {
            double const x = static_cast<double>(i) / static_cast<double>(window + 1), w = std::exp(-1 / (x * (1 - x)));
            q = at->q;
            p = at->p;
            total += w * energy(q, p);
            weights += w;
            ++at;
        }
        return total / weights;
    };
    first = mean();
    from = window;
    while (decade <= N) {
        pass(decade - window - from);
        sum = mean();
        from = decade;
        std::cout << std::setw(12) << std::scientific << std::setprecision(2) << static_cast<double>(decade) << std::setw(14)
                  << (sum - first) / first << std::defaultfloat << '\n';
        decade = decade < N and decade * 10 > N ? N : decade * 10;
    }
    double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::cout << "    " << std::setprecision(3) << seconds << " s, " << seconds / static_cast<double>(N) * 1e9
              << " ns a step, ends at q = " << std::setprecision(17) << q << "\n\n";
}

} // namespace

void drift(double log10_of_steps) {
    double const steps = std::pow(10, log10_of_steps);
    auto const oscillator = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };
    auto const pendulum = [](auto const& q, auto const& v) { return v * v / 2 - (1 - cos(q)); };
    auto const of_oscillator = [](double q, double p) { return (p * p + q * q) / 2; };
    auto const of_pendulum = [](double q, double p) { return p * p / 2 + (1 - std::cos(q)); };
    double const h = 0.0625;
    follow("oscillator, mid-point, plain sums", hilger::embed(oscillator, hilger::mid_point), h, steps, of_oscillator);
    follow("oscillator, mid-point, compensated sums", hilger::embed(oscillator, hilger::mid_point, hilger::compensated), h, steps,
           of_oscillator);
    follow("pendulum, order one, plain sums", hilger::embed(pendulum, hilger::order_one), h, steps, of_pendulum);
    follow("pendulum, order one, compensated sums", hilger::embed(pendulum, hilger::order_one, hilger::compensated), h, steps, of_pendulum);
}

} // namespace bench
