// SPDX-License-Identifier: BSL-1.0
// What the doctest programs share, compiled once. The tests include what they use all the same.
#pragma once

#include "../src/compiled_once.hpp"
#if HILGER_HAS_FLOAT128
#include "hilger/float128.hpp"
#endif

#include <Eigen/Dense>
#include <doctest/doctest.h>
#include <rapidcheck.h>
