// SPDX-License-Identifier: BSL-1.0
// Formulas in text, in numbers that count: costs alone need these.
#include "hilger/trajectory/counted.hpp"
#include "text/in_numbers.hpp"

namespace hilger::text {

HILGER_FORMULAS_IN(counted)
HILGER_SWITCHING_IN(counted)

} // namespace hilger::text
