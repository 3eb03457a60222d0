// SPDX-License-Identifier: BSL-1.0
// The scenes in C++; each is made in a file of its own. All others are files of examples/problems.
#pragma once

#include "scene.hpp"

namespace program {

/// The picture of one body in the plane: columns t, x, y, p_x, p_y, energy error.
inline constexpr char const* orbit_and_energy_error =
    "set title 'Orbit'; set size ratio -1; set xlabel 'x'; set ylabel 'y'; plot <rows> using 2:3 with lines notitle\n"
    "set size noratio; set title 'Energy error'; set xlabel 't'; set ylabel ''; plot <rows> using 1:6 with lines notitle\n";

scene pendulum();
scene kepler();
scene henon_heiles();
scene outer_solar_system();
scene fractional_oscillator();
scene bagley_torvik();
scene viscoelastic_beam();
scene fractional_dirichlet();

} // namespace program
