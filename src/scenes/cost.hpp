// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <iosfwd>
#include <string>

#include "hilger/trajectory/requirements.hpp"
#include "problems/from_file.hpp"

namespace program {

/// What a step computes, solves and keeps, by walking with numbers that count: a table for the scene of that name or file, or for each that
/// there is.
void list_costs(std::ostream& out, std::string const& name);
/// The same of a step of the G^alpha-Newmark scheme, with exponentials or with the whole history.
hilger::requirements requirements_of_structure(stated_problem const& what, hilger::index_type steps, bool whole);
/// Of a step of the mid-point with a force or fractional damping.
hilger::requirements requirements_with_force(stated_problem const& what, hilger::index_type steps);

} // namespace program
