// SPDX-License-Identifier: BSL-1.0
// Problems between two ends with 10 000 steps: their time, and that of a walk of the same embedding from the first of them; and the time
// after which a soap film between rings that are too far apart is refused.
#include "hilger/hilger.hpp"
#include "timing.hpp"

namespace bench {
namespace {

constexpr hilger::index_type steps = 10000;

template <class Run>
double median(Run const& run) {
    std::vector<double> seconds;
    for (int r = 0; r < 5; ++r) {
        auto const begin = std::chrono::steady_clock::now();
        run();
        seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    std::sort(seconds.begin(), seconds.end());
    return seconds[2];
}
template <class L, class E, class V>
void time_of(char const* name, L const& l, E const& how, V const& q0, V const& p0) {
    auto const T = hilger::uniform(hilger::interval{0.0, 1.0}, steps);
    auto const EL = equation_of(embed(l, how), T);
    V last = q0;
    double const walk = median([&] {
        auto const x = solve(EL, T, hilger::initial_momentum<V>{q0, p0});
        last = x[x.size() - 1];
    });
    double const ends = median([&] { (void)solve(EL, T, hilger::boundary_values<V>{q0, last}); });
    std::cout << std::left << std::setw(32) << name << std::right << std::scientific << std::setprecision(1) << std::setw(10) << walk
              << " s" << std::setw(10) << ends << " s" << std::fixed << std::setw(10) << ends / walk << '\n'
              << std::defaultfloat;
}

} // namespace

void ends() {
    constexpr hilger::lagrangian pendulum{[](auto const& x, auto const& v) { return v * v / 2 + 9.81 * cos(x); }};
    constexpr hilger::lagrangian oscillator{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
    constexpr hilger::lagrangian in_space{[](auto const& x, auto const& v) { return v.dot(v) / 2 - x.dot(x) / 2 - x(0) * x(1); }};
    constexpr hilger::lagrangian catenoid{[](auto const& x, auto const& v) { return x * sqrt(1 + v * v); }};
    std::cout << "Between two ends, " << steps << " steps" << std::setw(19) << "walk" << std::setw(12) << "two ends" << std::setw(10)
              << "ratio\n";
    time_of("pendulum, mid-point", pendulum, hilger::mid_point, 0.3, 1.0);
    time_of("pendulum, 2 Gauss nodes", pendulum, hilger::galerkin<2, hilger::gauss>, 0.3, 1.0);
    time_of("pendulum, 4 Gauss nodes", pendulum, hilger::galerkin<4, hilger::gauss>, 0.3, 1.0);
    time_of("oscillator, mid-point", oscillator, hilger::mid_point, 0.3, 1.0);
    time_of("oscillator, order one", oscillator, hilger::order_one, 0.3, 1.0);
    time_of("linear, d = 3, mid-point", in_space, hilger::mid_point, Eigen::Vector3d(0.3, 1, 2), Eigen::Vector3d(1, 0, -1));
    time_of("linear, d = 3, 4 Gauss nodes", in_space, hilger::galerkin<4, hilger::gauss>, Eigen::Vector3d(0.3, 1, 2),
            Eigen::Vector3d(1, 0, -1));
    for (double const half : {0.5, 1.0}) {
        auto const T = hilger::uniform(hilger::interval{-half, half}, steps);
        auto const EL = equation_of(embed(catenoid, hilger::mid_point), T);
        char const* how = "found";
        double const seconds = median([&] {
            try {
                (void)solve(EL, T, {.q0 = 1.0, .qN = 1.0});
            } catch (hilger::error::no_convergence const&) {
                how = "refused";
            }
        });
        std::cout << "soap film over " << 2 * half << ", " << how << std::scientific << std::setprecision(1) << std::setw(10) << seconds
                  << " s\n"
                  << std::defaultfloat;
    }
}

} // namespace bench
