// SPDX-License-Identifier: BSL-1.0
#include "path_walk.hpp"
#include "scenes.hpp"
#include "systems.hpp"

namespace program {

scene henon_heiles() {
    scene s;
    s.name = "henon-heiles";
    s.title = "Henon and Heiles, energy 0.1247";
    s.dimension = 2;
    s.t1 = 100;
    s.usual = {"mid-point", "double", "", 2'000};
    s.columns = {"t", "x", "y", "p_x", "p_y", "energy error"};
    s.invariants = {"energy"};
    s.picture = "set title 'Orbit'; set size ratio -1; set xlabel 'x'; set ylabel 'y'; plot DATA using 2:3 with lines notitle\n"
                "set size noratio; set title 'Energy error'; set xlabel 't'; set ylabel ''; plot DATA using 1:6 with lines notitle\n";
    s.reference = {"gauss-16", "50-digits", "", 200};
    return scene_of(henon_heiles_system{}, s);
}

} // namespace program
