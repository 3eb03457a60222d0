// SPDX-License-Identifier: BSL-1.0
// doctest itself, for programs that have a main of their own and are linked to what they share with the tests.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>
