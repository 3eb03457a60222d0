// SPDX-License-Identifier: BSL-1.0
// The order of fractional damping in 50 digits, from x_0 != 0 and v_0 != 0.
#include <doctest/doctest.h>

#include "orders.hpp"

namespace fractional_wide_tests {

using namespace hilger;
using namespace hilger::testing;

TEST_CASE("the mean over the step has order two in 50 digits, and its history is exact") {
    float50 const rho = float50(7) / 10, half = float50(1) / 2;
    fractional_oscillator<float50> const wide{rho, half, 1, 1, -half, 0};
    auto const exact = wide.at(1);
    auto const flow = embed(with_fractional_damping(spring, rho, fraction<1, 2>{}), mid_point);
    std::vector<float50> eq, ep;
    for (int const N : {64, 128, 256}) {
        state<float50, float50> last;
        for (auto const& x : flow.along(uniform(interval{float50(0), float50(1)}, N), float50(1), float50(-half))) last = x;
        eq.push_back(abs(last.q - exact.u));
        ep.push_back(abs(last.p - exact.v));
    }
    CHECK(std::abs(fitted_slope(eq) - 2) < 0.02);
    CHECK(std::abs(fitted_slope(ep) - 2) < 0.02);
    // What is left after one extrapolation is of a higher order: nothing of order two is hidden in rounding.
    auto const left = [](auto const& e) { return static_cast<double>(abs((4 * e[2] - e[1]) / 3) / e[2]); };
    CHECK(left(eq) < 0.01);
    CHECK(left(ep) < 0.01);
}

} // namespace fractional_wide_tests
