// SPDX-License-Identifier: BSL-1.0
// The scenes there are; each is made in a file of its own.
#pragma once

#include "scene.hpp"

namespace program {

scene pendulum();
scene double_pendulum();
scene kepler();
scene henon_heiles();
scene outer_solar_system();
scene fermi_pasta_ulam();
scene charged_particle();
scene fractional_oscillator();
scene bagley_torvik();
scene viscoelastic_beam();
scene fractional_dirichlet();

} // namespace program
