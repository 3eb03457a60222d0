// SPDX-License-Identifier: BSL-1.0
#include "text/in_numbers.hpp"

namespace hilger::text {

HILGER_FORMULAS_IN(float100)
HILGER_SWITCHING_IN(float100)
HILGER_OPERATORS_IN(float100)

} // namespace hilger::text
