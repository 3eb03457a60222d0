// SPDX-License-Identifier: BSL-1.0
// IEEE quadruple precision with the compiler's own arithmetic. Needs libquadmath, which g++ brings, and -std=gnu++20; clang does not have
// it.
#pragma once

#if defined(__STRICT_ANSI__) && !defined(__clang__)
#error hilger/float128.hpp needs -std=gnu++20 and -lquadmath: Boost writes its constants as 1.0Q, which -std=c++20 has not
#endif

#include <boost/multiprecision/float128.hpp>

namespace hilger {

using float128 = boost::multiprecision::number<boost::multiprecision::float128_backend, boost::multiprecision::et_off>;

} // namespace hilger
