// SPDX-License-Identifier: BSL-1.0
// The time of a step: hilger, loops written by hand for the same scheme, and Boost.odeint, in one run.
//   hilger_bench                the tables
//   hilger_bench rounding [n]   energy error of mid-point over 10^n steps (default 7.5), plain and compensated
//   hilger_bench drift [n]      energy after 10^n steps (default 9), plain and compensated
//   hilger_bench plain          plain lambdas of many degrees of freedom
//   hilger_bench history        what the memory of a fractional difference costs
//   hilger_bench fractional     steps with fractional damping, and their errors
//   hilger_bench formulas       formulas known at run time
//   hilger_bench ensemble       many members, in lanes and alone
//   hilger_bench boundary       two-sided fractional problems
//   hilger_bench ends           problems between two ends, beside walks
#include "timing.hpp"

int main(int count, char** arguments) {
    std::string const what = count > 1 ? arguments[1] : "";
    if (what == "rounding")
        bench::rounding(count > 2 ? std::atof(arguments[2]) : 7.5);
    else if (what == "drift")
        bench::drift(count > 2 ? std::atof(arguments[2]) : 9);
    else if (what == "history")
        bench::histories();
    else if (what == "plain")
        bench::plain_lambdas();
    else if (what == "formulas")
        bench::formulas();
    else if (what == "ensemble")
        bench::ensembles();
    else if (what == "boundary")
        bench::boundary();
    else if (what == "ends")
        bench::ends();
    else if (what == "fractional")
        bench::fractional();
    else {
        std::cout << "Nanoseconds a step, ratio to the fastest loop by hand, and the sum of the positions seen\n\n";
        bench::small_systems();
        bench::large_systems();
    }
}
