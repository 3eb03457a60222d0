// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <iosfwd>

#include "hilger/trajectory/requirements.hpp"
#include "problems/from_file.hpp"

namespace program {

/// For each scene whose steps can be walked with numbers that count: what a step computes, solves and keeps, a table a scene.
void list_costs(std::ostream& out);
/// The same of a step of the G^alpha-Newmark scheme, with exponentials or with the whole history.
hilger::requirements requirements_of_structure(stated_problem const& what, hilger::index_type steps, bool whole);

} // namespace program
