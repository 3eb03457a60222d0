// SPDX-License-Identifier: BSL-1.0
// Hariz, Jimenez and Ober-Bloebaum: errors of problems A and B as printed, and the orders of both methods on A to E.
#include <iostream>
#include <sstream>

#include "../papers/hariz_jimenez_ober_blobaum_2026/stage_schemes.hpp"
#include "../papers/table.hpp"
#include "papers.hpp"
#include "papers_data.hpp"
#include "plot.hpp"

namespace program {

namespace {

using namespace hilger::papers;
using hilger::graded, hilger::interval, hilger::uniform;

void show_printed(agreement& seen) {
    char const* const other = "the printed ones are not those of these equations; the cause is not known";
    std::vector<known_difference> const known{
        {"A, s = 3, 4096 steps", "1.1e-12", "printed with rounding"},
        {"B, s = 3, 4 steps", "2.08e-5", other},
        {"B, s = 3, 256 steps", "6.8e-12", other},
        {"B, s = 4, 4 steps", "5.0e-7", other},
        {"B, s = 4, 256 steps", "3e-13", other},
    };
    std::istringstream in(stage_errors_csv);
    std::cout << "Largest errors with s stages of Lobatto IIIC, the first and the last of each series\n"
                 "  problem  s  steps |  printed       here  difference\n";
    for (auto const& r : rows_of(in)) {
        double const here = preprint_error(r[0], std::stoi(r[1]), std::stoi(r[2]));
        std::string const where = r[0] + ", s = " + r[1] + ", " + r[2] + " steps";
        bool const is_rounding = where == "A, s = 4, 4096 steps";
        std::cout << right(r[0], 9) << right(r[1], 3) << right(r[2], 7) << " | " << right(r[3], 8) << right(scientific(here, 3), 11)
                  << right(is_rounding ? "less " + seen.exact(where, 1, here < number<double>(r[3]) ? 1 : 0)
                                       : seen.number(where, r[3], here, known),
                           12)
                  << '\n';
    }
    std::cout << '\n';
}

/// Orders of one problem at the stages of both methods, equal steps and graded ones, and the errors as lines of a file.
void show_orders(char const* name, forced_oscillator const& p, std::ostream& errors) {
    for (int stages = 2; stages <= 4; ++stages)
        with_stages(stages, [&](auto s) {
            auto const row = [&](char const* method, auto const& flow, double gamma) {
                std::cout << right(name, 9) << right(method, 14) << right(std::to_string(stages), 3) << right(fixed(gamma, 1), 6) << " |";
                double last = 0;
                for (int N = 4; N <= 64; N *= 2) {
                    double const error = largest_error_of(p, flow, graded(0.0, 1.0, N, gamma));
                    std::cout << right(scientific(error, 1), 9) << (N == 4 ? "      " : right(fixed(std::log2(last / error), 1), 6));
                    errors << name << ',' << method << ',' << stages << ',' << gamma << ',' << N << ',' << error << '\n';
                    last = error;
                }
                std::cout << '\n';
            };
            for (double const gamma : {1.0, stages == 4 and p.mu > 1 ? 4.0 : stages == 4 ? 2.5 : p.mu > 1 ? 3.0 : 2.0}) {
                row("Lobatto IIIC", lobatto_flow<s>(p.mechanics(), p.rho, p.mu), gamma);
                row("Radau IIA", radau_flow<s>(p.mechanics(), p.rho, p.mu), gamma);
            }
        });
}

/// Whether problem A has the order with this flow.
template <class Flow>
void show_order_of_a(agreement& seen, std::string const& method, Flow const& flow, int order) {
    double const fitted = std::log2(largest_error_of_a(flow, 128) / largest_error_of_a(flow, 256));
    std::cout << "  A, " << method << ": " << fixed(fitted, 2) << ", difference from " << order << ": "
              << seen.order("A, " + method, order, fitted) << '\n';
}

} // namespace

void show_hariz(std::string const& out, agreement& seen) {
    show_printed(seen);
    std::cout << "Orders of a damping without memory\n";
    auto const L = problem_a.lagrangian();
    show_order_of_a(seen, "Lobatto IIIC, s = 2", lobatto_flow<2>(L, problem_a.c, 1), 2);
    show_order_of_a(seen, "Lobatto IIIC, s = 3", lobatto_flow<3>(L, problem_a.c, 1), 4);
    show_order_of_a(seen, "Lobatto IIIC, s = 4", lobatto_flow<4>(L, problem_a.c, 1), 6);
    std::cout << "\nLargest errors on [0, 1] with 4, 8, ..., 64 steps, equal or graded by gamma, and orders\n"
                 "  problem        method  s gamma |\n";
    auto errors = create(out, "stage_errors.csv");
    errors << "# problem, method, stages, gamma, steps, largest error\n";
    show_orders("B", problem_b, errors);
    show_orders("C", problem_c, errors);
    std::cout << "\nMid-point with trapezoidal weights, 128 and 256 steps\n";
    for (auto const& p : problems_d) {
        auto const error = [&](int N) {
            return largest_error_of(p, mid_point_flow(p.mechanics(), p.rho, p.mu), uniform(interval{0.0, 1.0}, N));
        };
        std::cout << "  D, t^" << fixed(p.power, 1) << ", mu = " << fixed(p.mu, 1) << ": " << scientific(error(256), 2) << ", order "
                  << fixed(std::log2(error(128) / error(256)), 2) << '\n';
    }
    auto const exact = [](double t) { return problem_e.solution(1, 0.5, t); };
    std::cout << "  E, three stages of Lobatto IIIC, 128 steps: "
              << scientific(largest_error(lobatto_flow<3>(problem_e.lagrangian(), problem_e.c, 1), uniform(interval{0.0, 16.0}, 128), 1.0,
                                          0.5, exact),
                            2)
              << "\n\n";
}

} // namespace program
