// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <iosfwd>

#include "problems/scene.hpp"

namespace program {

struct run_options {
    std::string scene;
    configuration choice;
    hilger::index_type every = 0; ///< points between rows; 0 for about 2000 rows
    std::string out = "out";
    bool anew = false;                 ///< does not continue an interrupted run
    std::string ensemble;              ///< a table of members, for ensembles
    int threads = 0;                   ///< for an ensemble; 0 for all processors, or one with several ranks
    hilger::index_type stop_after = 0; ///< stops after so many rows, as a signal would; 0 for never
};

/// Runs a scene and writes its rows (CSV), a summary (JSON) and a picture. A run stopped by a signal or by a failing step leaves a
/// checkpoint, and the same command continues from it with the same result. Returns the exit code.
int run_scene(run_options const& options);
/// Prints a table of all scenes.
void list_scenes(std::ostream& out);

} // namespace program
