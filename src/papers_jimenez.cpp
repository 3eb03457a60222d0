// SPDX-License-Identifier: BSL-1.0
// Jimenez and Ober-Bloebaum (2019) have no table and no figure: fits of their claimed orders, and plots of the errors.
#include <iostream>

#include "../papers/jimenez_ober_blobaum_2019/local_truncation.hpp"
#include "papers.hpp"
#include "plot.hpp"

namespace program {

namespace {

using namespace hilger::papers;
using hilger::damping_at;

constexpr auto free_spring = [](point const& z, hilger::float50 const& h) { return harmonic(z, h, 0); };
constexpr auto free_pendulum = [](point const& z, hilger::float50 const& h) { return pendulum(z, h, 0); };
constexpr auto damped_spring = [](point const& z, hilger::float50 const& h) { return harmonic(z, h); };
constexpr auto damped_pendulum = [](point const& z, hilger::float50 const& h) { return pendulum(z, h); };

template <class Flow, class Solution>
void show_orders(std::string const& what, int claimed, Flow const& flow, Solution const& solution, int step, agreement& seen) {
    auto const p = truncation_orders(flow, solution, step);
    std::string const where = what + ", step " + std::to_string(step + 1);
    std::cout << "  " << where << std::string(where.size() < 52 ? 52 - where.size() : 1, ' ') << right(std::to_string(claimed), 9);
    for (std::size_t i = 0; i < 2; ++i)
        std::cout << " |" << right(fixed(p[i], 4), 8) << "  " << right(seen.order(where + (i == 0 ? ", x" : ", v"), claimed, p[i]), 10);
    std::cout << '\n';
}

/// The errors of the pendulum's first step, or with damping of its seventh, for h = 2^-6, ..., 2^-14.
void write_errors(std::string const& out) {
    using hilger::theta, hilger::order_one, hilger::mid_point;
    auto file = create(out, "local_truncation.csv");
    file << "# h, errors in x and in v: gamma = 1, 3/4, 1/2; (21), remark 2, at the seventh step\n";
    for (int m = 6; m <= 14; ++m) {
        hilger::float50 const h = hilger::float50(1) / (1 << m);
        file << static_cast<double>(h);
        auto const add = [&](auto const& flow, auto const& solution, int step) {
            point const e = truncation_error(flow, solution, h, step);
            file << ',' << static_cast<double>(e.x) << ',' << static_cast<double>(e.v);
        };
        add(embed(bob, order_one), free_pendulum, 0);
        add(embed(bob, theta<1, 4>), free_pendulum, 0);
        add(embed(bob, mid_point), free_pendulum, 0);
        add(linearly_damped(bob, damping_at::start), damped_pendulum, 6);
        add(linearly_damped(bob, damping_at::end), damped_pendulum, 6);
        file << '\n';
    }
}

} // namespace

void show_jimenez(std::string const& out, agreement& seen) {
    using hilger::theta, hilger::order_one, hilger::mid_point;
    std::cout << "Orders of local truncation, fitted in 50 digits between h = 1/" << coarsest_step << " and 1/"
              << coarsest_step * step_ratio << ", from x = 1, v = 1/2\n"
              << std::string(54, ' ') << "  claimed |  in x  difference  |  in v  difference\n";
    auto const both = [&](std::string const& what, int claimed, auto const& how) {
        show_orders(what + ", spring", claimed, embed(spring, how), free_spring, 0, seen);
        show_orders(what + ", pendulum", claimed, embed(bob, how), free_pendulum, 0, seen);
    };
    both("theorem 1, (11), gamma = 1", 1, order_one);
    both("theorem 1, (11), gamma = 3/4", 1, theta<1, 4>);
    both("theorem 1, (11), gamma = 1/2", 2, mid_point);
    for (int const step : {0, 6}) {
        show_orders("theorem 2, (21), damped spring", 1, linearly_damped(spring, damping_at::start), damped_spring, step, seen);
        show_orders("theorem 2, (21), damped pendulum", 1, linearly_damped(bob, damping_at::start), damped_pendulum, step, seen);
        show_orders("remark 2, damped spring", 1, linearly_damped(spring, damping_at::end), damped_spring, step, seen);
        show_orders("remark 2, damped pendulum", 1, linearly_damped(bob, damping_at::end), damped_pendulum, step, seen);
    }
    write_errors(out);
    auto const picture = draw(
        out, "local_truncation",
        "set grid; set key left top; set logscale xy; set format '10^{%L}'; set xlabel 'h'; set ylabel 'error of one step' offset 1\n"
        "set title 'Pendulum, (11): lines for x, points for v'\n"
        "plot for [k=0:2] 'local_truncation.csv' using 1:2*k+2 with lines lw 2 lt k+1 title 'γ = '.word('1 3/4 1/2', k+1), for [k=0:2] "
        "'' "
        "using 1:2*k+3 with points pt 7 lt k+1 notitle, 0.02*x**2 with lines dt 2 lc 'black' title 'h^2, order 1', 0.01*x**3 with lines dt "
        "3 lc 'black' title 'h^3, order 2'\n"
        "set title 'Pendulum with linear damping, α = 1/2, seventh step'\n"
        "plot for [k=3:4] 'local_truncation.csv' using 1:2*k+2 with lines lw 6-k lt k-2 title (k==3 ? '(21), x' : 'remark 2, x'), for "
        "[k=3:4] '' "
        "using 1:2*k+3 with points pt 7 lt k-2 title (k==3 ? '(21), v' : 'remark 2, v'), 0.02*x**2 with lines dt 2 lc 'black' title 'h^2, "
        "order 1'\n");
    std::cout << "Written: " << picture << "\n\n";
}

} // namespace program
