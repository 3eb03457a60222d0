// SPDX-License-Identifier: BSL-1.0
#include "text/in_numbers.hpp"

namespace hilger::text {

HILGER_FORMULAS_IN(Q)
HILGER_SWITCHING_IN(Q)
HILGER_OPERATORS_IN(Q)

} // namespace hilger::text
