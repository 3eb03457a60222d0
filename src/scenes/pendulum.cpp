// SPDX-License-Identifier: BSL-1.0
#include "path_walk.hpp"
#include "scenes.hpp"
#include "systems.hpp"

namespace program {

PROGRAM_MANY_DIGITS(extern, pendulum_system)

scene pendulum() {
    scene s;
    s.name = "pendulum";
    s.title = "A pendulum that swings to 1.5";
    s.t1 = 100;
    s.usual = {"mid-point", "double", "", 2'000};
    s.columns = {"t", "q", "p", "energy error"};
    s.invariants = {"energy"};
    s.picture = "set title 'Phase'; set xlabel 'q'; set ylabel 'p'; plot <rows> using 2:3 with lines notitle\n"
                "set title 'Energy error'; set xlabel 't'; set ylabel ''; plot <rows> using 1:4 with lines notitle\n";
    s.reference = {"gauss-16", "100-digits", "", 400};
    return scene_of(pendulum_system{}, s);
}

} // namespace program
