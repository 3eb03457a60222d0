// SPDX-License-Identifier: BSL-1.0
#include "text/in_numbers.hpp"

namespace hilger::text {

HILGER_FORMULAS_AS(symbol)

} // namespace hilger::text
