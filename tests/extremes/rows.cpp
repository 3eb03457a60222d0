// SPDX-License-Identifier: BSL-1.0
// A row fails when it should: what checks the others is checked here.
#include <limits>

#include "check.hpp"

namespace rows_tests {

using namespace extremes;

TEST_CASE("digits are lost above the bound, and where there is no number") {
    CHECK(kept("", 1, 1).ok);
    CHECK(not kept("", 1.5, 1).ok);
    CHECK(not kept("", std::numeric_limits<double>::quiet_NaN(), 1).ok);
    CHECK(kept("", 2, 1).how == "digits lost");
    CHECK(in_epsilons(1 + hilger::epsilon<double>(), hilger::float50(1)) == 1);
    CHECK(in_epsilons(0.5, hilger::float50(0.5), hilger::float50(0)) == 0);
    CHECK(in_epsilons(-3.0, hilger::float50(-3), hilger::float50(1)) == 0);
    CHECK(not(in_epsilons(std::numeric_limits<double>::quiet_NaN(), hilger::float50(1)) <= 1e300));
}

TEST_CASE("an error is the one that was promised, and says what it should") {
    auto const fails = [] { hilger::error::raise<hilger::error::singular>("a mass is positive"); };
    CHECK(refused<hilger::error::singular>("", fails).ok);
    CHECK(refused<hilger::error::singular>("", fails, "positive").ok);
    CHECK(refused<hilger::error::exception>("", fails).ok);
    CHECK(not refused<hilger::error::singular>("", fails, "the step from").ok);
    CHECK(not refused<hilger::error::not_finite>("", fails).ok);
    CHECK(refused<hilger::error::not_finite>("", fails).how == "another error");
    CHECK(not refused<hilger::error::singular>("", [] {}).ok);
    CHECK(refused<hilger::error::singular>("", [] {}).how == "silence");
    CHECK(not refused<hilger::error::singular>("", [] { throw std::runtime_error("something else"); }).ok);
}

} // namespace rows_tests
