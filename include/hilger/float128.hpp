// SPDX-License-Identifier: BSL-1.0
// IEEE quadruple precision with the compiler's own arithmetic. Needs libquadmath, which g++ brings; clang does not have it.
#pragma once

#include <boost/multiprecision/float128.hpp>

namespace hilger {

using float128 = boost::multiprecision::number<boost::multiprecision::float128_backend, boost::multiprecision::et_off>;

} // namespace hilger
