// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

namespace program {

struct demo_options {
    double days = 200'000;
    double step = 100; ///< days
    std::string data;  ///< a CSV file; empty for the built-in one
    std::string out = "out";
};

/// hilger's main job on the outer solar system: equations, identities, integration, pictures. Returns the exit code.
int run_demo(demo_options const& options);

} // namespace program
