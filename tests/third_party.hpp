// SPDX-License-Identifier: BSL-1.0
// What hilger's headers include that is not hilger's, compiled once for all that are compiled alone.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <boost/hana/for_each.hpp>
#include <boost/hana/tuple.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>

#include <charconv>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <unordered_map>
#include <variant>
