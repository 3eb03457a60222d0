// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <iosfwd>

namespace program {

/// One line for each case of extremes/row.hpp, as they are measured. True when all are as promised.
bool report_extremes(std::ostream& out, bool quick);

} // namespace program
