// SPDX-License-Identifier: BSL-1.0
// The main function of every doctest program. Not IMPLEMENT_WITH_MAIN: the precompiled header has included doctest already, and
// doctest notices only this one the second time.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

int main(int argc, char** argv) { return doctest::Context(argc, argv).run(); }
