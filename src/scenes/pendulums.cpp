// SPDX-License-Identifier: BSL-1.0
#include "path_walk.hpp"
#include "scenes.hpp"
#include "systems.hpp"

namespace program {

PROGRAM_MANY_DIGITS(extern, pendulum_system)
PROGRAM_MANY_DIGITS(extern, double_pendulum_system)

scene pendulum() {
    scene s;
    s.name = "pendulum";
    s.title = "A pendulum that swings to 1.5";
    s.t1 = 100;
    s.usual = {"mid-point", "double", "", 2'000};
    s.columns = {"t", "q", "p", "energy error"};
    s.invariants = {"energy"};
    s.picture = "set title 'Phase'; set xlabel 'q'; set ylabel 'p'; plot DATA using 2:3 with lines notitle\n"
                "set title 'Energy error'; set xlabel 't'; set ylabel ''; plot DATA using 1:4 with lines notitle\n";
    s.reference = {"gauss-16", "100-digits", "", 400};
    return scene_of(pendulum_system{}, s);
}
scene double_pendulum() {
    scene s;
    s.name = "double-pendulum";
    s.title = "Two pendulums, one hanging from the other: the mass depends on the position";
    s.dimension = 2;
    s.t1 = 40;
    s.usual = {"mid-point", "double", "", 4'000};
    s.columns = {"t", "q_0", "q_1", "p_0", "p_1", "energy error"};
    s.invariants = {"energy"};
    s.picture = "set title 'Path of the lower mass'; set size ratio -1; set xlabel 'x'; set ylabel 'y'\n"
                "plot DATA using (sin($2)+sin($3)):(-cos($2)-cos($3)) with lines notitle\n"
                "set size noratio; set title 'Energy error'; set xlabel 't'; set ylabel ''; plot DATA using 1:6 with lines notitle\n";
    s.reference = {"gauss-8", "double", "", 2'000};
    return scene_of(double_pendulum_system{}, s);
}

} // namespace program
