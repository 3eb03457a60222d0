// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "from_file.hpp"
#include "toml_file.hpp"

namespace program {

/// Reads what a file looks at and is measured with: units, conserved, observed, pictures, reference, exact. The columns of t, positions
/// and momenta are there.
void observe(toml_file const& file, std::shared_ptr<hilger::text::vocabulary const> const& words, stated_problem& what, scene& s);

} // namespace program
