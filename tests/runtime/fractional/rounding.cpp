// SPDX-License-Identifier: BSL-1.0
// Rounding in long runs with fractional damping, of orders next to 1 and 2 above all: a million steps in double end where the order two of
// the scheme says, with the rounding of a few positions more, from u_0 and u'_0 that are not zero.
#include <cmath>

#include <doctest/doctest.h>

#include "hilger/fractional/flow.hpp"
#include "hilger/fractional/newmark.hpp"
#include "hilger/history/history.hpp"
#include "series.hpp"

namespace fractional_rounding_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

double const u0 = 0.5, v0 = -0.25, c = 0.5;

state<double, double> end_of_a_run(double alpha, int N) {
    auto const scheme = newmark<bdf<2>>(
        fractional_structure{1.0, c, 1.0, 1.0, alpha}, [](double) { return 0.0; }, average_acceleration, exponentials{0, N});
    state<double, double> last{};
    for (auto const& x : scheme.along(uniform(interval{0.0, 1.0}, N), initial_velocity{u0, v0})) last = x;
    return last;
}
/// Where mid-point with the weights of G^alpha leads to from (1, -2) within three units of time.
template <class S>
S damped_end(S alpha, int N) {
    auto const oscillator = [](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; };
    auto const flow = embed(with_fractional_damping<bdf<2>>(oscillator, S(1) / S(2), alpha, direct{}), mid_point);
    S q(0);
    for (auto const& x : flow.along(uniform(interval{S(0), S(3)}, N), S(1), S(-2))) q = x.q;
    return q;
}

} // namespace

TEST_CASE("2^14 and 2^20 steps: the error falls by 2^12 to the rounding of some positions, for orders below 1, above it and next to 2") {
    int const coarse = 1 << 14, fine = 1 << 20;
    for (double const alpha : {0.5, 0.99, 1.25, 1.7, 1.99}) {
        auto const exact = fractional_oscillator<float50>{float50(c), float50(alpha), 1, float50(u0), float50(v0), 0}.at(1);
        auto const first = end_of_a_run(alpha, coarse), second = end_of_a_run(alpha, fine);
        auto const error = [&](state<double, double> const& x) {
            return std::array{static_cast<double>(x.q - exact.u), static_cast<double>(x.p - exact.v)};
        };
        for (std::size_t k = 0; k < 2; ++k) {
            double const e = error(first)[k], f = error(second)[k];
            CAPTURE(alpha);
            CAPTURE(k);
            CAPTURE(e);
            CAPTURE(f);
            CHECK(std::abs(f - e / 4096) <= 32 * epsilon<double>());
        }
    }
}

TEST_CASE("a damped flow of an order above 1 has compensated sums: the same steps in 50 digits end within some roundings") {
    for (double const alpha : {1.5, 1.99}) { // in plain sums 2^10 steps lose 3e-14 and 3e-13
        CAPTURE(alpha);
        CHECK(std::abs(static_cast<double>(damped_end(alpha, 1 << 10) - damped_end(float50(alpha), 1 << 10))) <= 64 * epsilon<double>());
    }
}

} // namespace fractional_rounding_tests
