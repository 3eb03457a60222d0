// SPDX-License-Identifier: BSL-1.0
// expect: numbers of Boost.Multiprecision need expression templates off
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
    [[maybe_unused]] auto const T = uniform(S(0), S(1) / S(3), 10);
}
