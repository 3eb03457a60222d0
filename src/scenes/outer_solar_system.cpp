// SPDX-License-Identifier: BSL-1.0
#include "outer_solar_system_data.hpp"
#include "path_walk.hpp"
#include "scenes.hpp"
#include "systems.hpp"

namespace program {

PROGRAM_MANY_DIGITS(extern, planetary_system)

scene outer_solar_system() {
    std::istringstream built_in(outer_solar_system_csv);
    planetary_system const system{read_solar_system(built_in, "the built-in data")};
    scene s;
    s.name = "outer-solar-system";
    s.title = "Sun, Jupiter, Saturn, Uranus, Neptune, Pluto from 5 September 1994";
    s.units = "days";
    s.dimension = dimension;
    s.t1 = 20'000;
    s.usual = {"mid-point", "double", "", 400};
    s.columns = {"t"};
    for (char const* x : {"", "p_"})
        for (auto const& name : system.data.names)
            for (char const* c : {"x", "y", "z"}) s.columns.push_back(name + ' ' + x + c);
    s.invariants = {"energy", "angular momentum x", "angular momentum y", "angular momentum z"};
    for (auto const& name : s.invariants) s.columns.push_back(name + " error");
    s.picture =
        "set title 'Orbits'; set size ratio -1; set xlabel 'x / au'; set ylabel 'y / au'\n"
        "plot for [k=0:5] <rows> using (column(2+3*k)):(column(3+3*k)) with lines notitle\n"
        "set size noratio; set title 'Energy error'; set xlabel 't / days'; set ylabel ''; plot <rows> using 1:38 with lines notitle\n";
    s.reference = {"gauss-16", "100-digits", "", 160};
    return scene_of(system, s);
}

} // namespace program
