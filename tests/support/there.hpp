// SPDX-License-Identifier: BSL-1.0
// What a test needs of the machine. Where that is not there the test ends, and main.cpp tells ctest that it was skipped.
#pragma once

#include <cstdlib>

#include <doctest/doctest.h>

namespace hilger::testing {

inline bool something_was_missing = false;
inline bool is_there(bool found, char const* what) {
    if (not found) {
        MESSAGE("skipped: there is no " << what);
        something_was_missing = true;
    }
    return found;
}
/// CC, or cc.
inline bool there_is_a_c_compiler() {
    static bool const found = std::system("${CC:-cc} --version >/dev/null 2>&1") == 0;
    return is_there(found, "C compiler");
}

} // namespace hilger::testing
