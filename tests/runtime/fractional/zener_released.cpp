// SPDX-License-Identifier: BSL-1.0
// A viscoelastic structure that is released from a deflection, with a velocity and under a load: order two in position and momentum, in 50
// digits and for every order of the material, against its own double power series.
#include <vector>

#include <boost/math/special_functions/gamma.hpp>
#include <doctest/doctest.h>

#include "../../../papers/table.hpp"
#include "hilger/fractional/newmark.hpp"
#include "hilger/fractional/zener.hpp"
#include "hilger/multiprecision.hpp"

namespace fractional_zener_released_tests {

using namespace hilger;
using papers::fitted_slope;

using S = float50;

namespace {

S const R = 4, tau = S(1) / 2, u0 = 1, v0 = 2, load = -3; // m = k = E_o = 1, E_inf = R

struct position_and_velocity {
    S u, v;
};
/// u'' + R (u - a) = load, a + tau^alpha D^alpha a = (R - 1)/R u, a(0) = 0, by the coefficients of t^{m + k alpha}: those of a are the
/// integral of order alpha of ((R - 1)/R u - a) / tau^alpha, those of u the second integral of load - R (u - a).
position_and_velocity series(S const& alpha, S const& t) {
    std::size_t const M = 40, K = 2 + static_cast<std::size_t>(25 / static_cast<double>(alpha));
    std::vector<std::vector<S>> u(M, std::vector<S>(K, S(0))), a(u), gamma(u);
    for (std::size_t m = 0; m < M; ++m)
        for (std::size_t k = 0; k < K; ++k) gamma[m][k] = boost::math::tgamma(S(m + k * alpha + 1));
    position_and_velocity sum{0, 0};
    for (std::size_t m = 0; m < M; ++m)
        for (std::size_t k = 0; k < K; ++k) {
            if (m >= 2) u[m][k] = (a[m - 2][k] - u[m - 2][k]) * R * gamma[m - 2][k] / gamma[m][k];
            if (k == 0) u[m][k] += m == 0 ? u0 : m == 1 ? v0 : m == 2 ? S(load / 2) : S(0);
            if (k > 0) a[m][k] = ((R - 1) / R * u[m][k - 1] - a[m][k - 1]) / pow(tau, alpha) * gamma[m][k - 1] / gamma[m][k];
            S const power = m + k * alpha, term = u[m][k] * pow(t, power);
            sum.u += term;
            sum.v += term * power / t;
        }
    return sum;
}

template <generating_function G>
void has_order(S const& alpha, double order) {
    auto const exact = series(alpha, S(1));
    zener_structure const material{S(1), S(1), S(1), R, tau, alpha};
    std::vector<S> position, momentum;
    for (int const N : {256, 512, 1024}) {
        S q, p;
        for (auto const& x : newmark<G>(material, [](S const&) { return load; }).along(uniform(interval{S(0), S(1)}, N), u0, v0))
            q = x.q, p = x.p;
        position.push_back(abs(S(q - exact.u)));
        momentum.push_back(abs(S(p - exact.v)));
    }
    CAPTURE(alpha);
    CHECK(std::abs(fitted_slope(position) - order) < 0.02);
    CHECK(std::abs(fitted_slope(momentum) - order) < 0.02);
}

} // namespace

TEST_CASE("released from a deflection, with a velocity and under a load that begin at once: order two for every material") {
    has_order<bdf<2>>(S(1) / 10, 2);
    has_order<bdf<2>>(S(1) / 2, 2);
    has_order<bdf<2>>(S(9) / 10, 2);
    has_order<bdf<2>>(S(1), 2);
}
TEST_CASE("whatever generating function of order two or more") {
    has_order<bdf<3>>(S(1) / 2, 2);
    has_order<trapezoid>(S(1) / 2, 2);
}

} // namespace fractional_zener_released_tests
