// SPDX-License-Identifier: BSL-1.0
#include "path_walk.hpp"
#include "scenes.hpp"
#include "systems.hpp"

namespace program {

PROGRAM_MANY_DIGITS(extern, henon_heiles_system)

scene henon_heiles() {
    scene s;
    s.name = "henon-heiles";
    s.title = "Henon and Heiles, energy 0.1247";
    s.dimension = 2;
    s.t1 = 100;
    s.usual = {"mid-point", "double", "", 2'000};
    s.columns = {"t", "x", "y", "p_x", "p_y", "energy error"};
    s.invariants = {"energy"};
    s.picture = orbit_and_energy_error;
    s.reference = {"gauss-16", "100-digits", "", 400};
    return scene_of(henon_heiles_system{}, s);
}

} // namespace program
