// SPDX-License-Identifier: BSL-1.0
// See compiled_once.hpp. With the sanitizers, which numbers.cpp has not.
#include "compiled_once.hpp"

namespace hilger::detail {
HILGER_ENGINES(, double)
} // namespace hilger::detail
