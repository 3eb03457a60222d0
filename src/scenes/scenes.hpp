// SPDX-License-Identifier: BSL-1.0
// The scenes in C++, all of them with a memory; each is made in a file of its own. All others are files of examples/problems.
#pragma once

#include "scene.hpp"

namespace program {

scene fractional_oscillator();
scene bagley_torvik();
scene viscoelastic_beam();
scene fractional_dirichlet();

} // namespace program
