// SPDX-License-Identifier: BSL-1.0
// A way that fails is tried again after one step, after two, four, ...: never less often than every 1024 steps.
#include <doctest/doctest.h>

#include "hilger/newton/stop.hpp"

namespace back_off_tests {

using hilger::detail::back_off;

namespace {

/// After how many steps the way is allowed again, for a way that fails now.
int steps_without(back_off& way) {
    way.has_failed();
    int steps = 0;
    for (; not way.allows() and steps < 5000; ++steps) way.passes();
    return steps;
}

} // namespace

TEST_CASE("a way that fails is left out twice as long each time, until it works") {
    back_off way;
    CHECK(way.allows());
    for (int n = 1; n <= 1024; n *= 2) CHECK(steps_without(way) == n);
    CHECK(steps_without(way) == 1024);
    way.has_worked();
    CHECK(steps_without(way) == 1);
    CHECK(steps_without(way) == 2);
}

} // namespace back_off_tests
