// SPDX-License-Identifier: BSL-1.0
#include "path_walk.hpp"
#include "scenes.hpp"
#include "systems.hpp"

namespace program {

PROGRAM_MANY_DIGITS(extern, charged_particle_system)

scene charged_particle() {
    scene s;
    s.name = "charged-particle";
    s.title = "A charge that drifts in a magnetic field which grows outwards: L has a term linear in v";
    s.dimension = 2;
    s.t1 = 200;
    s.usual = {"mid-point", "double", "", 4'000};
    s.columns = {"t", "x", "y", "p_x", "p_y", "energy error", "momentum map error"};
    s.invariants = {"energy", "momentum map"};
    s.picture = orbit_and_energy_error;
    s.reference = {"gauss-8", "double", "", 4'000};
    return scene_of(charged_particle_system{}, s);
}

} // namespace program
