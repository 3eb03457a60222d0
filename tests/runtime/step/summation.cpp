// SPDX-License-Identifier: BSL-1.0
// A compensated sum loses nothing of two summands, whichever is larger, and adds what rounding cut off with the next one.
#include <doctest/doctest.h>

#include "hilger/multiprecision.hpp"
#include "hilger/step/summation.hpp"

namespace summation_tests {

using namespace hilger;

TEST_CASE("z + carry = x + y exactly, also where the increment is larger than the state") {
    for (double const x : {1.0, -0.1, 0x1p-60, 1e10, 0.0})
        for (double const y : {0x1p-60, 0.1, -1e-30, 0x1p70, 1.0 / 3, -1e10, -0x1.8p53}) {
            CAPTURE(x);
            CAPTURE(y);
            detail::summation<true, double, 2> sum;
            double z = x;
            sum.add(z, y, 1);
            CHECK(Q(z) + Q(sum.rest[1]) == Q(x) + Q(y));
            CHECK(z == x + y);
            CHECK(sum.rest[0] == 0.0);
        }
}

TEST_CASE("eight increments of 2^-54 are 2^-51, and nothing where they are not compensated") {
    detail::summation<true, double, 1> sum;
    double x = 1, plain = 1;
    for (int k = 0; k < 8; ++k) {
        sum.add(x, 0x1p-54, 0);
        detail::summation<false, double, 1>::add(plain, 0x1p-54, 0);
    }
    CHECK(x == 1 + 0x1p-51);
    CHECK(sum.rest[0] == 0.0);
    CHECK(plain == 1.0);
}

TEST_CASE("an increment in two parts is added as their sum, to twice the digits of the state") {
    for (double const x : {1.0, -0.1, 0x1p-60, 1e10})
        for (double const y : {0x1p-60, 0.1, -1e-30, 1.0 / 3}) {
            CAPTURE(x);
            CAPTURE(y);
            detail::summation<true, double, 1> sum;
            double z = x;
            sum.add(z, y, y * 0x1p-54, 0);
            sum.add(z, y, -y * 0x1p-55, 0);
            Q const all = Q(x) + Q(2) * Q(y) + Q(y) * (Q(0x1p-54) - Q(0x1p-55));
            CHECK(abs(Q(z) + Q(sum.rest[0]) - all) <= Q(0x1p-104) * (abs(Q(x)) + abs(Q(y))));
        }
}

} // namespace summation_tests
