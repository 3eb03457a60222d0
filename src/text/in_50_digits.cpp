// SPDX-License-Identifier: BSL-1.0
#include "text/in_numbers.hpp"

namespace hilger::text {

HILGER_FORMULAS_IN(float50)
HILGER_SWITCHING_IN(float50)
HILGER_OPERATORS_IN(float50)

} // namespace hilger::text
