// SPDX-License-Identifier: BSL-1.0
// See engines.cpp.
#include "compiled_once.hpp"

namespace hilger::detail {
HILGER_ENGINES(, float50)
} // namespace hilger::detail
