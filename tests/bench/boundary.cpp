// SPDX-License-Identifier: BSL-1.0
// Two-sided fractional problems: the Dirichlet example of Bourdin, Cresson, Greff, Inizan (2013), section 3.4, and the harmonic oscillator
// of 4.3, for alpha = 3/4. Time, the memory that the process has had at its peak so far, and for Dirichlet the error at t = 1/2 (the closed
// form has 2F1(1/4, 1; 7/4; 1/2) in it, computed here by its series).
#include <fstream>

#include "hilger/boundary/solve.hpp"
#include "timing.hpp"

namespace bench {
namespace {

constexpr double alpha = 0.75;

/// From the kernel's accounts; 0 where there are none.
double megabytes_at_peak() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == "VmHWM:") {
            double kilobytes = 0;
            status >> kilobytes;
            return kilobytes / 1024;
        }
    return 0;
}
double exact_at_one_half() {
    double sum = 1, term = 1;
    for (int n = 0; n < 60; ++n) sum += term *= (1 - alpha + n) / (1 + alpha + n) / 2;
    return (2 * alpha - 1) / alpha * std::pow(0.5, alpha) * sum;
}
template <class Solve>
double seconds(int rounds, Solve const& solve) {
    double best = std::numeric_limits<double>::infinity();
    for (int r = 0; r < rounds; ++r) {
        auto const begin = std::chrono::steady_clock::now();
        solve();
        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    return best;
}

} // namespace

void boundary() {
    constexpr hilger::lagrangian dirichlet{[](auto const&, auto const& v) { return v * v / 2; }};
    constexpr hilger::lagrangian oscillator{[](auto const& x, auto const& v) { return (x * x + v * v) / 2; }};
    auto const equation_of = [](auto const& L, auto const& T) {
        constexpr hilger::unknown q;
        return variation(nabla_integral(L(q, hilger::Delta_minus(alpha)[q]), T));
    };
    double const exact = exact_at_one_half();
    std::cout << "Two-sided problems, alpha = 3/4\n        N   Dirichlet    error     residual  oscillator  applications   peak memory\n";
    for (hilger::index_type N = 1000; N <= 1'000'000; N *= 10) {
        auto const T = hilger::uniform(hilger::interval{0.0, 1.0}, N);
        double error = 0, residual = 0;
        int applications = 0;
        double const line = seconds(3, [&] {
            auto const x = solve(equation_of(dirichlet, T), T, {.q0 = 0, .qN = 1}, hilger::boundary_options{});
            error = std::abs(x.q[N / 2] - exact), residual = x.residual;
        });
        double const memory = megabytes_at_peak();
        double const spring = seconds(
            1, [&] { applications = solve(equation_of(oscillator, T), T, {.q0 = 0, .qN = 1}, hilger::boundary_options{}).applications; });
        std::cout << std::setw(9) << N << std::scientific << std::setprecision(1) << std::setw(10) << line << " s" << std::setw(9) << error
                  << std::setw(13) << residual << std::setw(10) << spring << " s" << std::defaultfloat << std::setw(14) << applications
                  << std::fixed << std::setprecision(0) << std::setw(11) << memory << " MB\n"
                  << std::defaultfloat;
    }
}

} // namespace bench
