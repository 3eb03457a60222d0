// SPDX-License-Identifier: BSL-1.0
#include "path_walk.hpp"
#include "scenes.hpp"
#include "systems.hpp"

namespace program {

scene charged_particle() {
    scene s;
    s.name = "charged-particle";
    s.title = "A charge that drifts in a magnetic field which grows outwards: L has a term linear in v";
    s.dimension = 2;
    s.t1 = 200;
    s.usual = {"mid-point", "double", "", 4'000};
    s.columns = {"t", "x", "y", "p_x", "p_y", "energy error", "momentum map error"};
    s.invariants = {"energy", "momentum map"};
    s.picture = "set title 'Orbit'; set size ratio -1; set xlabel 'x'; set ylabel 'y'; plot DATA using 2:3 with lines notitle\n"
                "set size noratio; set title 'Energy error'; set xlabel 't'; set ylabel ''; plot DATA using 1:6 with lines notitle\n";
    s.reference = {"gauss-8", "double", "", 4'000};
    return scene_of(charged_particle_system{}, s);
}

} // namespace program
