// SPDX-License-Identifier: BSL-1.0
#include "compiled_once.hpp"

namespace hilger::detail {
HILGER_ENGINES(, Q)
} // namespace hilger::detail
