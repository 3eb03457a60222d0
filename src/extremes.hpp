// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <iosfwd>

namespace program {

/// Prints one line for each case of extremes/row.hpp as it is measured. True when all keep their promises.
bool report_extremes(std::ostream& out, bool quick);

} // namespace program
