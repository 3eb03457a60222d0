// SPDX-License-Identifier: BSL-1.0
// Galucio, Deue and Dubois (2008): table 1 exactly, tables 2 and 3 with their meshes, and figures 1 to 4.
#include <iostream>
#include <sstream>

#include "../papers/galucio_deu_dubois_2008/newmark_oscillator.hpp"
#include "hilger/multiprecision.hpp"
#include "papers.hpp"
#include "papers_data.hpp"
#include "plot.hpp"
#include "scenes/run.hpp"

namespace program {

namespace {

using namespace hilger::papers;
using hilger::bdf, hilger::grunwald_letnikov, hilger::Q;

void show_coefficients(agreement& seen) {
    std::istringstream in(galpha_coefficients_csv);
    auto const rows = rows_of(in);
    std::array const orders{Q(1, 3), Q(1, 2), Q(3, 4)};
    std::cout << "Table 1, coefficients of G^alpha, in exact rationals\n"
                 "   j |       alpha = 1/3, printed                       here |      1/2, printed              here |       3/4, printed  "
                 "             here\n";
    std::array<std::vector<Q>, 3> g;
    for (std::size_t k = 0; k < 3; ++k) g[k] = hilger::first_weights<bdf<2>, Q>(orders[k], static_cast<hilger::index_type>(rows.size()));
    long equal = 0;
    for (std::size_t j = 0; j < rows.size(); ++j) {
        std::cout << right(rows[j][0], 4);
        for (std::size_t k = 0; k < 3; ++k) {
            std::size_t const width = k == 0 ? 26 : k == 1 ? 17 : 18;
            std::cout << " | " << right(rows[j][k + 1], width) << ' ' << right(g[k][j].str(), width);
            equal += g[k][j] == Q(rows[j][k + 1]) ? 1 : 0;
        }
        std::cout << '\n';
    }
    std::cout << "  equal: " << seen.exact("table 1", static_cast<long>(3 * rows.size()), equal) << "\n\n";
}

std::vector<double> errors_of(bool second_order, double alpha, double c) {
    return second_order ? largest_errors<bdf<2>>(alpha, c) : largest_errors<grunwald_letnikov>(alpha, c);
}

void show_rates(agreement& seen) {
    std::istringstream in(galpha_newmark_rates_csv);
    auto const rows = rows_of(in);
    std::vector<std::vector<double>> errors;
    std::vector<std::string> printed;
    for (auto const& r : rows) {
        errors.push_back(errors_of(r[0] == "G_alpha", number<double>(r[1]), number<double>(r[2])));
        printed.push_back(r[3]);
    }
    auto const ranges = ranges_with_rates(errors, printed);
    mesh_range const meshes = ranges.empty() ? mesh_range{7, 9} : ranges.front();
    std::cout << "Tables 2 and 3, rates of the largest error over [0, " << final_time
              << "] with meshes T/2^m. The paper says \"7-9 meshes\";\n"
              << "of all ranges of three or more, m = " << coarsest_mesh << " ... " << finest_mesh
              << ", one has all rates to their digits ("
              << seen.exact("ranges of meshes with all twelve rates", 1, static_cast<long>(ranges.size())) << "): m = " << meshes.first
              << " ... " << meshes.last << ".\n"
              << "Last column: the rate between the two finest\n"
                 "  scheme   alpha    c | printed    here  difference | error at m = " +
                     right(std::to_string(meshes.first), 3) + "       m = " + right(std::to_string(finest_mesh), 2) + "  finest\n";
    for (std::size_t k = 0; k < rows.size(); ++k) {
        auto const& r = rows[k];
        double const rate = fitted_rate(errors[k], meshes), last = errors[k].back();
        std::cout << "  " << r[0] << right(r[1], 14 - r[0].size()) << right(r[2], 5) << " | " << right(r[3], 7) << right(fixed(rate, 4), 8)
                  << "  " << right(seen.number("rate of " + r[0] + ", alpha = " + r[1] + ", c = " + r[2], r[3], rate), 10) << " | "
                  << right(scientific(errors[k][static_cast<std::size_t>(meshes.first - coarsest_mesh)], 3), 16)
                  << right(scientific(last, 3), 13) << right(fixed(std::log2(errors[k][errors[k].size() - 2] / last), 3), 8) << '\n';
    }
    std::cout << '\n';
}

/// u at the points of T / 2^m.
template <hilger::generating_function G>
std::vector<double> response(double alpha, double c, int m) {
    std::vector<double> u;
    for (auto const& x : oscillator<G>(alpha, c).along(hilger::uniform(hilger::interval{0.0, final_time}, 1 << m), 0.0, 0.0))
        u.push_back(x.q);
    return u;
}

/// Figures 1 and 2: (a) the responses for T / 2^6, (b) the errors.
std::string draw_schemes(std::string const& out, int figure, double alpha, std::string const& alpha_text) {
    std::string const name = "galpha_figure_" + std::to_string(figure);
    auto const second = response<bdf<2>>(alpha, 1, 6), first = response<grunwald_letnikov>(alpha, 1, 6);
    oscillator_solution const exact(alpha, 1);
    auto curves = create(out, name + "a.csv");
    curves << "# t, exact solution at t, and at the meshes' points t: G^alpha, GL\n";
    for (std::size_t j = 0; j <= 512; ++j) {
        double const t = final_time * static_cast<double>(j) / 512;
        curves << t << ',' << exact(t) << ',';
        if (j % 8 == 0)
            curves << second[j / 8] << ',' << first[j / 8];
        else
            curves << ',';
        curves << '\n';
    }
    auto errors = create(out, name + "b.csv");
    errors << "# step, largest error of G^alpha, of GL\n";
    auto const of_second = errors_of(true, alpha, 1), of_first = errors_of(false, alpha, 1);
    for (std::size_t i = 0; i < of_second.size(); ++i)
        errors << std::ldexp(final_time, -coarsest_mesh - static_cast<int>(i)) << ',' << of_second[i] << ',' << of_first[i] << '\n';
    curves.close(), errors.close();
    return draw(out, name,
                "set grid; set key right bottom; set xrange [0:15]\n"
                "set title 'Oscillator (3), α = " +
                    alpha_text +
                    ", step T/2^6'; set xlabel 't'; set ylabel 'u'\n"
                    "plot '" +
                    name +
                    "a.csv' using 1:2 with lines lw 2 title 'exact', '' using 1:3 with points pt 7 ps 0.8 title 'G^α-Newmark', "
                    "'' using 1:4 with points pt 6 title 'GL-Newmark'\n"
                    "set autoscale x; set title 'Largest errors'; set xlabel 'step'; set ylabel 'error' offset 1; set logscale xy; set "
                    "format y '10^{%L}'\n"
                    "plot '" +
                    name +
                    "b.csv' using 1:3 with linespoints pt 6 title 'GL', '' using 1:2 with linespoints pt 7 title 'G^α', "
                    "0.1*x with lines dt 2 lc 'black' title 'slope 1', 0.02*x**2 with lines dt 3 lc 'black' title 'slope 2'\n");
}

/// Figure 3: three damping constants, alpha = 1/2, T / 2^9.
std::string draw_damping(std::string const& out) {
    std::array const constants{0.5, 1.0, 1.5};
    auto curves = create(out, "galpha_figure_3a.csv"), errors = create(out, "galpha_figure_3b.csv");
    curves << "# t, then for c = 0.5, 1, 1.5: exact solution, G^alpha\n";
    errors << "# step, largest errors for c = 0.5, 1, 1.5\n";
    std::array<std::vector<double>, 3> u, e;
    for (std::size_t k = 0; k < 3; ++k) {
        u[k] = response<bdf<2>>(0.5, constants[k], 9);
        e[k] = errors_of(true, 0.5, constants[k]);
    }
    std::array const exact{oscillator_solution(0.5, 0.5), oscillator_solution(0.5, 1), oscillator_solution(0.5, 1.5)};
    for (std::size_t j = 0; j < u[0].size(); ++j) {
        double const t = final_time * static_cast<double>(j) / 512;
        curves << t;
        for (std::size_t k = 0; k < 3; ++k) curves << ',' << exact[k](t) << ',' << u[k][j];
        curves << '\n';
    }
    for (std::size_t i = 0; i < e[0].size(); ++i)
        errors << std::ldexp(final_time, -coarsest_mesh - static_cast<int>(i)) << ',' << e[0][i] << ',' << e[1][i] << ',' << e[2][i]
               << '\n';
    curves.close(), errors.close();
    return draw(out, "galpha_figure_3",
                "set grid; set key right bottom; set xrange [0:15]\n"
                "set title 'G^α-Newmark, α = 1/2, step T/2^9'; set xlabel 't'; set ylabel 'u'\n"
                "plot for [k=0:2] 'galpha_figure_3a.csv' using 1:2*k+2 with lines lw 2 lt k+1 title sprintf('c = %.1f, exact', 0.5+0.5*k), "
                "for [k=0:2] '' using 1:2*k+3 every 16 with points pt 7 ps 0.8 lt k+1 title sprintf('c = %.1f, G^α', 0.5+0.5*k)\n"
                "set autoscale x; set title 'Largest errors'; set xlabel 'step'; set ylabel 'error' offset 1; set logscale xy; set format "
                "y '10^{%L}'\n"
                "plot for [k=0:2] 'galpha_figure_3b.csv' using 1:k+2 with linespoints pt 7 lt k+1 title sprintf('c = %.1f', 0.5+0.5*k), "
                "0.02*x**2 with lines dt 3 lc 'black' title 'slope 2'\n");
}

} // namespace

void show_galucio(std::string const& out, agreement& seen) {
    show_coefficients(seen);
    show_rates(seen);
    auto const one = draw_schemes(out, 1, 1.0 / 3, "1/3"), two = draw_schemes(out, 2, 0.75, "3/4"), three = draw_damping(out);
    std::cout << "Figures 1 to 3\nWritten: " << one << ", " << two << " and " << three << "\n\nFigure 4\n";
    run_options beam;
    beam.scene = "viscoelastic-beam";
    beam.out = out;
    beam.anew = true;
    run_scene(beam);
    std::cout << '\n';
}

} // namespace program
