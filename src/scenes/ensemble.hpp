// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "run.hpp"

namespace program {

/// Runs a stated problem from each row of a table, members.csv: its first line names coordinates, velocities and parameters, as q, v[1], g,
/// and what it does not name is as the file has it. Writes q and p of members x points x 2 d coordinates into one file for numpy, and says
/// which members failed. Under mpirun or srun each rank makes its share and writes it into the same file. Returns the exit code.
int run_ensemble(run_options const& options);

} // namespace program
