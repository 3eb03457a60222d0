// SPDX-License-Identifier: BSL-1.0
#include "histories.hpp"
#include "path_walk.hpp"
#include "scenes.hpp"
#include "structures.hpp"

namespace program {

namespace {

constexpr auto nothing = [](auto const& x) { return std::vector<std::remove_cvref_t<decltype(x.t)>>{}; };

/// From rest, by Newmark's scheme with both kinds of weights.
scene oscillator(scene s, fractional_oscillator_system const& system) {
    s.embeddings = newmark_names();
    s.scalars = {"double", "50-digits"};
    s.histories = history_names();
    s.begin = [=, t1 = s.t1](configuration const& c) {
        std::unique_ptr<walk> result;
        auto const in = [&]<class S>(S const&) {
            auto const T = hilger::uniform(hilger::interval<S>{S(0), S(t1)}, c.steps);
            with_newmark(c, system.structure<S>(), system.load(),
                         [&](auto const& scheme) { result = walk_along(scheme.along(T, S(0), S(0)), nothing); });
        };
        if (c.scalar == "double")
            in(double{});
        else
            in(hilger::float50{});
        return result;
    };
    s.columns = {"t", "u", "p"};
    s.picture = "set title 'Displacement'; set xlabel 't'; plot <rows> using 1:2 with lines notitle\n"
                "set title 'Phase'; set xlabel 'u'; plot <rows> using 2:3 with lines notitle\n";
    return s;
}

} // namespace

scene fractional_oscillator() {
    scene s;
    s.name = "fractional-oscillator";
    s.title = "u'' + D^(1/2) u + u = 1 from rest (Galucio, Deue, Dubois (3))";
    s.t1 = 15;
    s.usual = {"g-alpha-newmark", "double", "exponentials", 1'500};
    s.exact_source = "45 digits (papers/galucio_deu_dubois_2008/fractional_oscillator.csv)";
    s.exact_error = 1e-45;
    s.exact = [] { return std::vector{hilger::float100("0.857933655594914560893696297980414318052698379")}; };
    return oscillator(s, damped_by_half_a_derivative);
}
scene bagley_torvik() {
    scene s;
    s.name = "bagley-torvik";
    s.title = "A plate in a Newtonian fluid, u'' + D^(3/2) u / 2 + u / 2 = 8 from rest (Bagley, Torvik)";
    s.t1 = 20;
    s.usual = {"g-alpha-newmark", "double", "exponentials", 2'000};
    return oscillator(s, plate_in_a_fluid);
}

} // namespace program
