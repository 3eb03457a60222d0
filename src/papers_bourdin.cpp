// SPDX-License-Identifier: BSL-1.0
// Section 3.4 of Bourdin et al. (2013): both tables of errors, the slopes and the figures; section 4.3 in exact rationals.
#include <algorithm>
#include <iostream>
#include <sstream>

#include "../papers/bourdin_cresson_greff_inizan_2013/exact.hpp"
#include "../papers/bourdin_cresson_greff_inizan_2013/oscillator.hpp"
#include "papers.hpp"
#include "papers_data.hpp"
#include "plot.hpp"

namespace program {

namespace {

using namespace hilger::papers;
using hilger::index_type, hilger::Q;

std::string const is_cut_off = "cut off after its last digit";
std::string const of_rounded_errors = "the print is the slope of the errors as they were printed, cut off after two digits";
std::vector<known_difference> const known{
    {"errors, alpha = 0.9, N = 200, mean square", "0.00041654909", is_cut_off},
    {"errors, alpha = 0.95, N = 4000, mean square", "0.0000076528502", is_cut_off},
    {"slope, alpha = 0.7", "0.396247", of_rounded_errors},
    {"slope, alpha = 0.75", "0.494699", of_rounded_errors},
    {"slope, alpha = 0.8", "0.593246", of_rounded_errors},
    {"slope, alpha = 0.85", "0.691178", of_rounded_errors},
    {"slope, alpha = 0.95", "0.892961", "not what the errors as they were printed have either, which is 0.95"},
};

/// The table of section 3.4, including the one for alpha = 3/4.
void show_errors(std::vector<row> const& rows, std::string const& out, agreement& seen) {
    auto file = create(out, "fractional_dirichlet_errors.csv");
    file << "# alpha, h, largest error printed, computed, mean square error printed, computed\n";
    std::cout << "Section 3.4, errors (21) of the Dirichlet example\n"
                 "  alpha     N | largest       here  difference | mean square   here  difference\n";
    for (auto const& r : rows) {
        auto const e = dirichlet_errors(number<double>(r[0]), std::stol(r[1]));
        std::string const where = "errors, alpha = " + r[0] + ", N = " + r[1];
        std::cout << "  " << right(r[0], 5) << right(r[1], 6) << " | " << right(r[2], 8) << right(fixed(e.largest, 7), 11) << "  "
                  << right(seen.number(where + ", largest", r[2], e.largest, known), 10) << " | " << right(r[3], 8)
                  << right(fixed(e.mean_square, 7), 11) << "  "
                  << right(seen.number(where + ", mean square", r[3], e.mean_square, known), 10) << '\n';
        file << r[0] << ',' << 1 / number<double>(r[1]) << ',' << r[2] << ',' << e.largest << ',' << r[3] << ',' << e.mean_square << '\n';
    }
}

void show_slopes(std::vector<row> const& rows, std::string const& out, agreement& seen) {
    auto file = create(out, "fractional_dirichlet_slopes.csv");
    file << "# alpha, slope printed, of the largest error, of the mean square error\n";
    std::cout << "\nSection 3.4, slopes between N = 2000 and 4000, the mean of both norms\n"
              << "  alpha | printed    here  difference | largest  mean square  2 alpha - 1\n";
    for (auto const& r : rows) {
        double const alpha = number<double>(r[0]);
        auto const own = slopes_between(dirichlet_errors(alpha, 2000), dirichlet_errors(alpha, 4000));
        std::cout << "  " << right(r[0], 5) << " | " << right(r[1], 7) << right(fixed(own.mean(), 4), 8) << "  "
                  << right(seen.number("slope, alpha = " + r[0], r[1], own.mean(), known), 10) << " | "
                  << right(fixed(own.of_largest, 4), 7) << right(fixed(own.of_mean_square, 4), 13) << right(fixed(2 * alpha - 1, 1), 13)
                  << '\n';
        file << r[0] << ',' << r[1] << ',' << own.of_largest << ',' << own.of_mean_square << '\n';
    }
}

void write_solutions(std::string const& out) {
    auto file = create(out, "fractional_dirichlet.csv");
    file << "# t, exact solution (19), discrete solution where there is one, alpha = 3/4, N = 100\n";
    auto const T = hilger::uniform(hilger::interval{0.0, 1.0}, 100);
    auto const fine = hilger::uniform(hilger::interval{0.0, 1.0}, 1000);
    auto const solution = solve(dirichlet_equation(0.75, T), T, {.q0 = 0, .qN = 1});
    for (index_type k = 0; k <= 1000; ++k) {
        file << fine.point(k) << ',' << dirichlet_solution(0.75, fine.point(k)) << ',';
        if (k % 10 == 0) file << solution[k / 10];
        file << '\n';
    }
}

void show_oscillator(agreement& seen) {
    std::cout << "\nSection 4.3, the harmonic oscillator (31) with its rotations, in exact rationals\n";
    for (Q const& alpha : {Q(1), Q(3, 4), Q(3, 10)}) {
        auto const r = rotation_residual(alpha);
        long const zeros = std::count(r.begin(), r.end(), Q(0));
        std::ostringstream where;
        where << "theorem 4, (26), alpha = " << alpha;
        std::cout << "  " << where.str() << ": zero at " << seen.exact(where.str(), static_cast<long>(r.size()), zeros) << " points\n";
    }
    auto const c = rotation_constant();
    std::cout << "  theorem 5, (34): (-Q^2, Q^1).sigma(Delta Q) = " << c.front() << " at "
              << seen.exact("theorem 5, (34)", static_cast<long>(c.size()), std::count(c.begin(), c.end(), c.front())) << " points\n\n";
}

} // namespace

void show_bourdin(std::string const& out, agreement& seen) {
    std::istringstream errors_in(fractional_dirichlet_errors_csv), slopes_in(fractional_dirichlet_slopes_csv);
    show_errors(rows_of(errors_in), out, seen);
    show_slopes(rows_of(slopes_in), out, seen);
    show_oscillator(seen);
    write_solutions(out);
    auto const solution = draw(
        out, "fractional_dirichlet",
        "set grid; set key left top\n"
        "set title 'Dirichlet example, α = 3/4, N = 100'; set xlabel 't'; set ylabel 'q'\n"
        "plot 'fractional_dirichlet.csv' using 1:2 with lines lw 2 title 'exact (19)', '' using 1:3 every 20 with points pt 7 ps 0.6 title "
        "'discrete'\n"
        "set title 'Errors, α = 3/4'; set xlabel 'h'; set ylabel 'error' offset 1; set logscale xy; set format '10^{%L}'\n"
        "plot 'fractional_dirichlet_errors.csv' using ($1==0.75?$2:NaN):4 with linespoints pt 7 title 'largest', '' using "
        "($1==0.75?$2:NaN):3 with points pt 6 ps 2 title 'largest, printed', '' using ($1==0.75?$2:NaN):6 with linespoints pt 7 title "
        "'mean "
        "square', '' using ($1==0.75?$2:NaN):5 with points pt 6 ps 2 title 'mean square, printed', 0.25*sqrt(x) with lines dt 2 lc "
        "'black' title 'slope 1/2'\n");
    auto const slopes =
        draw(out, "fractional_dirichlet_slopes",
             "set grid; set key right bottom; set colorsequence podo\n"
             "set title 'Largest error; circles: as printed'; set xlabel 'h'; set ylabel 'error' offset 1; set logscale xy\n"
             "set format '10^{%L}'; set xrange [2e-4:0.03]\n"
             "plot for [i=0:8] 'fractional_dirichlet_errors.csv' using 2:4 every ::8*i::8*i+7 with linespoints lt i%8+1 pt 7 ps "
             "0.5 title sprintf('α = %.2f', 0.55+0.05*i), for [i=0:8] '' using 2:3 every ::8*i::8*i+7 with points lt i%8+1 "
             "pt 6 ps 1.6 notitle\n"
             "unset logscale; set format; set xrange [0.5:1]; set yrange [0:1]; set key left top\n"
             "set title 'Slopes between N = 2000 and 4000'; set xlabel 'α'; set ylabel 'slope'\n"
             "plot 2*x-1 with lines dt 2 lc 'black' title '2α − 1', 'fractional_dirichlet_slopes.csv' using 1:2 with "
             "points pt 6 ps 2 title 'printed', '' using 1:3 with points pt 7 title 'largest', '' using 1:4 with points pt 5 "
             "title 'mean square'\n");
    std::cout << "Written: " << solution << " and " << slopes << "\n\n";
}

} // namespace program
