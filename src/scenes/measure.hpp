// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <bit>
#include <chrono>

namespace program {

/// The next number on a grid that divides each of [2^k, 2^(k + 1)] into so many parts.
inline long next_number(long n, long parts) { return n + static_cast<long>(std::bit_floor(static_cast<unsigned long>(n))) / parts; }

/// Seconds of the fastest of several runs: at most a hundred, within a fifth of a second or the given time.
template <class Run>
double fastest(Run const& run, double enough = 0.2) {
    using clock = std::chrono::steady_clock;
    double best = 1e300, all = 0;
    for (int i = 0; i < 100 and (i < 2 or all < enough) and all < 2; ++i) {
        auto const begin = clock::now();
        run();
        double const seconds = std::chrono::duration<double>(clock::now() - begin).count();
        best = std::min(best, seconds);
        all += seconds;
    }
    return best;
}

} // namespace program
