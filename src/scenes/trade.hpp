// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

namespace program {

struct trade_options {
    std::string scene;
    double accuracy = 0; ///< recommends a method for it; 0 prints all
    double budget = 1;   ///< seconds for one run; ten times that for many digits
    std::string out = "out";
};
/// Measures the error at the end against the time, over embeddings, numbers of steps, scalars and histories, beside other libraries, and
/// prints and draws the work-precision diagram and its Pareto front. Returns the exit code.
int run_trade(trade_options const& options);

} // namespace program
