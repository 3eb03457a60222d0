// SPDX-License-Identifier: BSL-1.0
// The time of a step: hilger, loops written by hand for the same scheme, and Boost.odeint, in one run.
//   hilger_bench                the tables
//   hilger_bench rounding [n]   energy error of mid-point over 10^n steps (default 7.5), plain and compensated
//   hilger_bench history        what the memory of a fractional difference costs
#include <cstring>

#include "timing.hpp"

int main(int count, char** arguments) {
    if (count > 1 and std::strcmp(arguments[1], "rounding") == 0) {
        bench::rounding(count > 2 ? std::atof(arguments[2]) : 7.5);
        return 0;
    }
    if (count > 1 and std::strcmp(arguments[1], "history") == 0) {
        bench::histories();
        return 0;
    }
    std::cout << "Nanoseconds a step, ratio to the fastest loop by hand, and the sum of the positions seen\n\n";
    bench::small_systems();
    bench::large_systems();
}
