// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <iosfwd>

namespace program {

/// For each scene whose steps can be walked with numbers that count: what a step computes, solves and keeps, a table a scene.
void list_costs(std::ostream& out);

} // namespace program
