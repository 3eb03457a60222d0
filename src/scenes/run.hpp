// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <iosfwd>

#include "problems/scene.hpp"

namespace program {

struct run_options {
    std::string scene;
    configuration choice;
    hilger::index_type every = 0; ///< rows are written at every so many points; 0 for about 2000 rows
    std::string out = "out";
    bool anew = false;                 ///< an interrupted run is not continued
    std::string ensemble;              ///< a table of members, where there are many
    int threads = 0;                   ///< for an ensemble; 0 for all processors, or one where there are other ranks
    hilger::index_type stop_after = 0; ///< stops after so many rows, as a signal does; 0 for never
};

/// Runs a scene and writes its rows (CSV), a summary (JSON) and a picture. What is interrupted, by a signal or by a step that fails, leaves
/// a checkpoint, and the same command continues from it as if nothing had happened. Returns the exit code.
int run_scene(run_options const& options);
/// A table of all scenes.
void list_scenes(std::ostream& out);

} // namespace program
