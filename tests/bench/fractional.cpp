// SPDX-License-Identifier: BSL-1.0
// What a fractional history costs a step and does to its accuracy: the damped pendulum by mid-point with different histories, and the
// oscillator of Galucio, Deue, Dubois (3) at 2^20 steps against 45 digits.
#include <array>

#include "hilger/fractional/flow.hpp"
#include "hilger/fractional/newmark.hpp"
#include "hilger/hilger.hpp"
#include "hilger/history/history.hpp"
#include "timing.hpp"

namespace bench {
namespace {

constexpr auto pendulum = [](auto const& q, auto const& v) { return v * v / 2 - (1 - cos(q)); };

/// The fastest of twelve runs.
template <class Run>
double seconds_of(Run const& run) {
    double best = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 12; ++round) {
        auto const begin = std::chrono::steady_clock::now();
        run();
        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    return best;
}
template <class Flow>
double time_of_a_step(char const* name, Flow const& flow, int log2_of_steps, double undamped) {
    long const steps = 1L << log2_of_steps;
    double seen = 0;
    double const ns = 1e9 / static_cast<double>(steps) * seconds_of([&] {
                          for (auto const& x : flow.along(hilger::uniform(0.0, 1.0 / 64, steps), 1.5, 0.0)) seen = x.q;
                      });
    std::cout << "  " << std::left << std::setw(44) << name << "2^" << std::setw(4) << log2_of_steps << std::right << std::fixed
              << std::setprecision(1) << std::setw(9) << ns << " ns" << std::setprecision(2) << std::setw(8)
              << (undamped > 0 ? ns / undamped : 1.0) << std::setprecision(12) << std::setw(18) << seen << '\n'
              << std::defaultfloat;
    return ns;
}

/// u(t) of u'' + D^alpha u + u = 1 from rest: papers/galucio_deu_dubois_2008/fractional_oscillator.csv
struct reference {
    double alpha, t, u;
};
constexpr std::array table{
    reference{1.0 / 3, 1, 0.400911700942735131}, reference{1.0 / 3, 5, 0.524285701059400034}, reference{1.0 / 3, 15, 0.767660749591265585},
    reference{0.5, 1, 0.387738214241532960},     reference{0.5, 5, 0.668914627671081225},     reference{0.5, 15, 0.857933655594914561},
    reference{0.75, 1, 0.365145641817603315},    reference{0.75, 5, 0.872473004107724548},    reference{0.75, 15, 0.959229833098150311}};

} // namespace

void fractional() {
    using hilger::embed;
    using hilger::fraction;
    using hilger::with_fractional_damping;
    std::cout << "Pendulum, mid-point, damping -D^(1/2) q / 10: steps, time of one, ratio to the step without damping, last position\n";
    double const undamped = time_of_a_step("no damping", embed(pendulum, hilger::mid_point), 17, 0);
    auto const damped = [](auto order, auto policy) {
        return embed(with_fractional_damping(pendulum, 0.1, order, policy), hilger::mid_point);
    };
    time_of_a_step("order 1, no history", damped(fraction<1>{}, hilger::direct{}), 17, undamped);
    time_of_a_step("direct", damped(fraction<1, 2>{}, hilger::direct{}), 14, undamped);
    time_of_a_step("blocks", damped(fraction<1, 2>{}, hilger::blocks{}), 17, undamped);
    time_of_a_step("exponentials, 1e-12", damped(fraction<1, 2>{}, hilger::exponentials{1e-12, 1 << 17}), 17, undamped);
    time_of_a_step("exponentials, 1e-8", damped(fraction<1, 2>{}, hilger::exponentials{1e-8, 1 << 17}), 17, undamped);
    time_of_a_step("exponentials, 1e-12, good for 1e7 steps", damped(fraction<1, 2>{}, hilger::exponentials{1e-12, 10'000'000}), 20,
                   undamped);
    time_of_a_step("exponentials, 1e-14, good for 1e7 steps", damped(fraction<1, 2>{}, hilger::exponentials{0, 10'000'000}), 20, undamped);

    std::cout << "\nu'' + D^alpha u + u = 1 from rest, G^alpha-Newmark, exponentials as accurate as the direct sum: errors\n"
                 "  alpha    t        2^16        2^18        2^20   seconds for 2^20\n";
    for (auto const& [alpha, t, exact] : table) {
        std::cout << std::fixed << std::setprecision(3) << std::setw(7) << alpha << std::setw(5) << std::setprecision(0) << t;
        double seconds = 0;
        for (int const log2_of_steps : {16, 18, 20}) {
            long const N = 1L << log2_of_steps;
            auto const begin = std::chrono::steady_clock::now();
            auto const scheme = hilger::newmark<hilger::bdf<2>>(
                hilger::fractional_structure{1.0, 1.0, 1.0, 1.0, alpha}, [](double) { return 1.0; }, hilger::average_acceleration,
                hilger::exponentials{0, N});
            double last = 0;
            for (auto const& x : scheme.along(hilger::uniform(hilger::interval<double>{0.0, t}, N), 0.0, 0.0)) last = x.q;
            seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
            std::cout << std::scientific << std::setprecision(2) << std::setw(12) << last - exact;
        }
        std::cout << std::fixed << std::setprecision(2) << std::setw(10) << seconds << std::defaultfloat << std::endl;
    }
}

} // namespace bench
