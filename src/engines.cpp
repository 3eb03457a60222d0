// SPDX-License-Identifier: BSL-1.0
// See compiled_once.hpp. Compiled with the sanitizers, unlike numbers.cpp.
#include "compiled_once.hpp"

namespace hilger::detail {
HILGER_ENGINES(, double)
} // namespace hilger::detail
