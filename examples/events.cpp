// SPDX-License-Identifier: BSL-1.0
// The period of a pendulum, from the moments at which it turns, and from the elliptic integral: T = 4 K(sin(a/2)) at amplitude a.
#include <cmath>
#include <iostream>

#include <boost/math/special_functions/ellint_1.hpp>

#include "hilger/hilger.hpp"

using namespace hilger;

constexpr lagrangian L{[](auto const& q, auto const& v) {
    using std::cos;
    return v * v / 2 + cos(q);
}};

/// The mean of the first ten periods: the pendulum is let go at rest, and p falls through zero once in a period.
double period(double amplitude, double h) {
    double last = 0;
    int count = 0;
    auto const path = embed(L, mid_point).along(uniform(0.0, h, 1'000'000), amplitude, 0.0);
    for (auto const& x : events(
             path, [](auto const& at) { return at.p; }, crossing::falling)) {
        last = x.t;
        if (++count == 10) break; // nothing beyond is computed
    }
    return last / count;
}

int main() {
    bool good = true;
    std::cout << "amplitude  4 K(sin(a/2))  events, h = 0.02  error   extrapolated error\n";
    for (double const a : {0.1, 0.5, 1.0, 2.0, 3.0}) {
        double const exact = 4 * boost::math::ellint_1(std::sin(a / 2));
        double const coarse = period(a, 0.02), fine = period(a, 0.01);
        double const extrapolated = fine + (fine - coarse) / 3; // mid-point is of order 2, with even powers only
        std::cout << a << "  " << exact << "  " << coarse << "  " << coarse - exact << "  " << extrapolated - exact << '\n';
        double const residual = largest_residual(embed(L, mid_point).along(uniform(0.0, 0.02, 1000), a, 0.0)); // of what is located in
        good = good and residual < 1e-9 and std::abs(coarse - exact) < 1e-3 and std::abs(extrapolated - exact) < 1e-7;
    }
    return good ? 0 : 1;
}
