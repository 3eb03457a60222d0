// SPDX-License-Identifier: BSL-1.0
// Arithmetic of rationals and of many digits, and factorizations: most of the time of tests and scenes in debug builds. Compiled once,
// optimised, and linked first, since the linker takes the first of equal definitions. A linker with another rule only costs time.
#include "compiled_once.hpp"

HILGER_NUMBERS()
