// SPDX-License-Identifier: BSL-1.0
// Cresson and Safi (2022) have no numbers: their theorems in exact rationals, and their figure of the time scales.
#include <algorithm>
#include <cmath>
#include <iostream>

#include "../papers/cresson_safi_2022/hamiltonian_action.hpp"
#include "papers.hpp"
#include "plot.hpp"
#include "prove.hpp"

namespace program {

namespace {

using namespace hilger::papers;
using hilger::index_type, hilger::Q, hilger::Delta_plus, hilger::Delta_o_plus;

constexpr hilger::unknown q;
constexpr auto q_o = hilger::extend[q];
using V = plane<Q>;

auto scale() { return hilger::uniform(Q(-1, 3), Q(2, 7), 5); }

template <class Action>
std::string pairings(std::string const& where, Action const& action, agreement& seen) {
    std::mt19937 random(67);
    long held = 0, cases = 20;
    for (long i = 0; i < cases; ++i) {
        auto const both = pair_with_residual<V>(action, random);
        held += both.derivative == both.of_residual ? 1 : 0;
    }
    return seen.exact(where, cases, held);
}

void show_theorems(agreement& seen) {
    auto const T = scale();
    auto const right_action = integral(plane_cubic(q, Delta_plus[q]), T);
    auto const action = integral(plane_cubic(q_o, Delta_o_plus[q_o]), half(T));
    std::cout << "  (12) to (14): the derivative of the order-one action pairs with its Euler-Lagrange residual, "
              << pairings("(14)", right_action, seen) << " times\n  theorems 1 and 2: so does that of the mid-point action, "
              << pairings("theorems 1 and 2", action, seen) << " times, and (56) is\n    " << variation(action);
    std::mt19937 random(64);
    long equal = 0, cases = 0;
    for (int trial = 0; trial < 20; ++trial) {
        auto const x = some_function<V>(T, random);
        auto const residual = hilger::tabulate(variation(action).residual(x));
        for (index_type i = 1; i < T.steps(); ++i, ++cases) equal += T.h() * residual[i] == wendlandt_marsden(plane_cubic, x, i) ? 1 : 0;
    }
    std::cout << "  (64), (66): Wendlandt and Marsden's equation is h times (56), " << seen.exact("(64), (66)", cases, equal) << " times\n";
    hilger::lagrangian const L{[](auto const& x, auto const& v) { return v * v / 2 + v * x / 3 - x * x / 2; }};
    long one_space = 0, scales = 0;
    for (int N = 2; N <= 5; ++N, ++scales) {
        auto const r = ranks_of_theorem_4(hilger::hamiltonian(L), hilger::uniform(Q(0), Q(2, 7), N));
        auto const expected = static_cast<std::size_t>(2 * N - 1);
        one_space += r.critical == expected and r.system == expected and r.both == expected ? 1 : 0;
    }
    std::cout << "  theorem 4: critical points of (97) and solutions of (94) are one space of dimension 3, "
              << seen.exact("theorem 4", scales, one_space) << " times (N = 2, ..., 5)\n\n";
}

void write_scales(std::string const& out) {
    auto const T = hilger::uniform(0.0, 1.0, 4);
    auto scales = create(out, "time_scales.csv");
    scales << "# point, row: T is 2, T_half is 1, T_o is 0\n";
    for (double const t : T) scales << t << ",2\n";
    for (double const t : half(T)) scales << t << ",1\n";
    for (double const t : circ(T)) scales << t << ",0\n";
    auto const f = hilger::function_on(T, [](double t) { return 1 + std::sin(1.3 * t); });
    auto const f_o = hilger::extend[f];
    auto extension = create(out, "extension.csv");
    extension << "# t in T_o, f_o, Delta_o_plus[f_o] where there is one, derivative of the interpolation\n";
    auto const slope = hilger::Delta_o_plus[f_o];
    for (index_type i = 0; i < f_o.size(); ++i) {
        extension << f_o.scale().element(i) << ',' << f_o[i] << ',';
        if (i < slope.size()) extension << slope[i];
        extension << ',' << slope[std::min(i, slope.size() - 1)];
        extension << '\n';
    }
}

} // namespace

void show_cresson(std::string const& out, agreement& seen) {
    std::cout << "No numbers are printed; what is proved, in exact rationals\n";
    bool const proved = prove_identities(std::cout);
    seen.exact("the identities of sections 1 and 2", 1, proved ? 1 : 0);
    show_theorems(seen);
    write_scales(out);
    auto const picture =
        draw(out, "time_scales",
             "unset key; set xrange [-0.4:4.4]; set yrange [-0.7:2.7]; unset border; unset xtics\n"
             "set ytics ('T_o' 0, 'T_{1/2}' 1, 'T' 2) scale 0\n"
             "set title 'Time scales, N = 4: figure 1'\n"
             "do for [i=0:3] {set arrow from i,1.95 to i+0.47,1.06 filled lc rgb '#0072b2'; set arrow from i+0.5,0.95 to i+0.5,0.06 nohead "
             "dt 3; "
             "set arrow from i+0.07,2 to i+0.93,2 filled; set arrow from i+0.04,0 to i+0.46,0 filled; set arrow from i+0.54,0 to i+0.96,0 "
             "filled}\n"
             "do for [i=0:2] {set arrow from i+0.57,1 to i+1.43,1 filled}\n"
             "do for [i=0:4] {set arrow from i,1.92 to i,0.06 nohead dt 3 lc rgb '#999999'; set label sprintf('t_%d', i) at i,2.2 center}\n"
             "do for [i=0:3] {set label sprintf('t_{%d+1/2}', i) at i+0.5,1.2 left offset 0.5,0}\n"
             "set label '{/Symbol s}' at 0.5,2.12 center; set label '{/Symbol p}' at 0.17,1.4 center tc rgb '#0072b2'\n"
             "set label '{/Symbol s}_{1/2}' at 0.85,0.86; set label '{/Symbol s}_o' at 0.25,-0.15 center\n"
             "plot 'time_scales.csv' using 1:2 with points pt 7 ps 1.8 lc rgb '#d55e00'\n"
             "unset label; unset arrow; set border; set xtics; set ytics auto; set autoscale; set grid; set key right top\n"
             "set xrange [-0.2:4.2]; set title 'Extension and its derivative: definition 4, lemma 1'; set xlabel 't'\n"
             "plot 'extension.csv' using 1:2 with linespoints lw 2 pt 6 ps 1.6 title 'f_o on T_o', '' using 1:2 every 2 with points pt 7 "
             "ps 1.6 lt 1 "
             "title 'f on T', '' using 1:4 with steps lw 2 lt 2 title 'derivative of the interpolation', '' using 1:3 with points pt 7 lt "
             "2 title "
             "'{/Symbol D}_{o,+}[f_o]'\n");
    std::cout << "Written: " << picture << "\n\n";
}

} // namespace program
