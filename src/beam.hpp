// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

namespace program {

/// The viscoelastic cantilever of Galucio, Deue, Dubois (2008), section 4.3: 1 s, the tip's deflection and its phase diagram (their figure
/// 4), as CSV and as a picture in the directory `out`. Returns the exit code.
int run_beam(std::string const& out);

} // namespace program
