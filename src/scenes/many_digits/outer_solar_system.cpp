// SPDX-License-Identifier: BSL-1.0
#include "scenes/path_walk.hpp"
#include "scenes/systems.hpp"

namespace program {

PROGRAM_MANY_DIGITS(, outer_solar_system_system)

} // namespace program
