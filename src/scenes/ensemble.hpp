// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "run.hpp"

namespace program {

/// Runs a problem from each row of a table, members.csv. Its first line names coordinates, velocities and parameters, as q, v[1], g; others
/// keep the values of the problem's file. Writes q and p of members x points x 2 d coordinates into one numpy file, and lists the members
/// that failed. Under mpirun or srun each rank writes its share into the same file. Returns the exit code.
int run_ensemble(run_options const& options);

} // namespace program
