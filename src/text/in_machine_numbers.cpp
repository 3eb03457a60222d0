// SPDX-License-Identifier: BSL-1.0
#include "text/in_numbers.hpp"

HILGER_TEXT_IN(double)
HILGER_TEXT_IN(float)
HILGER_TEXT_IN(long double)
