// SPDX-License-Identifier: BSL-1.0
// expect 1: numbers of Boost.Multiprecision need expression templates off
// expect 2: numbers of Boost.Multiprecision need expression templates off
// Boost.Multiprecision's default number keeps references to temporaries.
#include "hilger/calculus.hpp"
#include <boost/multiprecision/cpp_int.hpp>

using namespace hilger;

int main() {
#ifdef MUST_NOT_COMPILE
    using S = boost::multiprecision::cpp_rational;
#else
    using S = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;
#endif
#if not defined(MUST_NOT_COMPILE) or MUST_NOT_COMPILE == 1
    [[maybe_unused]] auto const T = uniform(S(0), S(1), 10);
#endif
#if not defined(MUST_NOT_COMPILE) or MUST_NOT_COMPILE == 2
    [[maybe_unused]] auto const U = time_scale<S>{S(0), S(1), S(3)};
#endif
}
