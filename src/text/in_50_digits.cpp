// SPDX-License-Identifier: BSL-1.0
#include "text/in_numbers.hpp"

HILGER_TEXT_IN(hilger::float50)
