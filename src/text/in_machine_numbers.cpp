// SPDX-License-Identifier: BSL-1.0
#include "text/in_numbers.hpp"

namespace hilger::text {

HILGER_FORMULAS_IN(double)
HILGER_SWITCHING_IN(double)
HILGER_OPERATORS_IN(double)
HILGER_FORMULAS_IN(float)
HILGER_SWITCHING_IN(float)
HILGER_OPERATORS_IN(float)
HILGER_FORMULAS_IN(long double)
HILGER_SWITCHING_IN(long double)
HILGER_OPERATORS_IN(long double)

} // namespace hilger::text
