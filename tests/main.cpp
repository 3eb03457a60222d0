// SPDX-License-Identifier: BSL-1.0
// The main function of every doctest program. Not IMPLEMENT_WITH_MAIN: the precompiled header has included doctest already, and
// doctest notices only this one the second time.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include "support/there.hpp"

int main(int argc, char** argv) {
    int const failed = doctest::Context(argc, argv).run();
    return failed == 0 and hilger::testing::something_was_missing ? 77 : failed; // which tests/CMakeLists.txt calls skipped
}
