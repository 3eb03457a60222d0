// SPDX-License-Identifier: BSL-1.0
// What tests and scenes spend their time in when they are compiled to be looked into: arithmetic of rationals and of many digits, and
// factorizations. Compiled once, optimised, and linked first: of what is in several files the linker takes the first. Nothing depends on it
// but the time: where a compiler puts these functions elsewhere, all is as slow as it was.
#include "compiled_once.hpp"

HILGER_NUMBERS()
