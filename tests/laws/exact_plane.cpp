// SPDX-License-Identifier: BSL-1.0
#include <Eigen/Core>
#include <doctest/doctest.h>

#include "hilger/multiprecision.hpp"
#include "prove.hpp"

TEST_CASE("every identity is exact in the rationals, d = 2") {
    laws::prove_all<hilger::Q>(Eigen::Matrix<hilger::Q, 2, 1>(hilger::Q(0), hilger::Q(0)), 1);
    laws::report("d = 2, rationals");
}
