// SPDX-License-Identifier: BSL-1.0
#include "scenes/path_walk.hpp"
#include "scenes/systems.hpp"

namespace program {

PROGRAM_MANY_DIGITS(, fermi_pasta_ulam_system)

} // namespace program
