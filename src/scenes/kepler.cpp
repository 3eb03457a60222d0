// SPDX-License-Identifier: BSL-1.0
#include "path_walk.hpp"
#include "scenes.hpp"
#include "systems.hpp"

namespace program {

PROGRAM_MANY_DIGITS(extern, kepler_system)

scene kepler() {
    scene s;
    s.name = "kepler";
    s.title = "Kepler's problem, eccentricity 3/5, eight revolutions";
    s.dimension = 2;
    s.t1 = 50;
    s.usual = {"mid-point", "double", "", 5'000};
    s.columns = {"t", "x", "y", "p_x", "p_y", "energy error", "angular momentum error"};
    s.invariants = {"energy", "angular momentum"};
    s.picture = orbit_and_energy_error;
    s.exact_source = "Kepler's equation in 100 digits";
    s.exact = [] {
        using R = hilger::float100;
        R const e = R(3) / 5, t = 50;
        R E = t; // Kepler's equation t = E - e sin E, by Newton
        for (int i = 0; i < 60; ++i) E -= (E - e * sin(E) - t) / (1 - e * cos(E));
        return std::vector<R>{cos(E) - e, sqrt(1 - e * e) * sin(E)};
    };
    return scene_of(kepler_system{}, s);
}

} // namespace program
