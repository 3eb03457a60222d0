// SPDX-License-Identifier: BSL-1.0
// Each row of a group of cases is one check.
#pragma once

#include <doctest/doctest.h>

#include "extremes/row.hpp"

namespace extremes {

inline void check(rows const& all) {
    REQUIRE(not all.empty());
    for (row const& r : all) CHECK_MESSAGE(r.ok, r.what << ": promised " << r.promised << ", measured " << r.measured << ", " << r.how);
}

} // namespace extremes
