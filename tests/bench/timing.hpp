// SPDX-License-Identifier: BSL-1.0
// Competitors are timed in turns in one run, and the fastest round of each counts: what else the machine does then falls on all of them.
#pragma once

#include <chrono>
#include <cmath>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace bench {

struct competitor {
    std::string name;
    std::function<double(long)> run; ///< makes so many steps and returns what it saw, so that nothing is optimised away
    bool by_hand = false;
    double seconds = std::numeric_limits<double>::infinity();
    double seen = 0;
};

/// Prints one block: nanoseconds a step, and the ratio to the fastest loop written by hand.
inline void race(std::string const& title, long steps, int rounds, std::vector<competitor> all) {
    for (int r = 0; r < rounds; ++r)
        for (auto& c : all) {
            auto const begin = std::chrono::steady_clock::now();
            c.seen = c.run(steps);
            c.seconds = std::min(c.seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
        }
    double best = std::numeric_limits<double>::infinity();
    for (auto const& c : all)
        if (c.by_hand) best = std::min(best, c.seconds);
    std::cout << title << '\n';
    for (auto const& c : all)
        std::cout << "  " << std::left << std::setw(52) << c.name << std::right << std::fixed << std::setprecision(1) << std::setw(9)
                  << c.seconds / static_cast<double>(steps) * 1e9 << " ns" << std::setprecision(2) << std::setw(8) << c.seconds / best
                  << (c.by_hand ? "  by hand" : "") << std::setprecision(9) << std::setw(c.by_hand ? 20 : 29) << c.seen << '\n'
                  << std::defaultfloat;
    std::cout << '\n';
}

void small_systems();
void large_systems();
void plain_lambdas();
void boundary();
void ends();
void formulas();
void ensembles();
void rounding(double log10_of_steps);
void drift(double log10_of_steps);
void histories();
void fractional();

} // namespace bench
