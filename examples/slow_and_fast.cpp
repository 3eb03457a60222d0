// SPDX-License-Identifier: BSL-1.0
// Actions that read the steps in different ways add up. Here a chain of six masses with stiff and soft springs in turn (Hairer, Lubich,
// Wanner, "Geometric Numerical Integration", I.5.1): the stiff ones in the middle of each step, and the soft ones at its ends.
#include <cmath>
#include <iostream>
#include <limits>

#include "hilger/hilger.hpp"

using namespace hilger;
using state6 = Eigen::Matrix<double, 6, 1>;

constexpr double omega = 50;
constexpr auto stiff = [](auto const& q) {
    auto const a = q(1) - q(0), b = q(3) - q(2), c = q(5) - q(4);
    return omega * omega / 4 * (a * a + b * b + c * c);
};
constexpr auto soft = [](auto const& q) {
    auto const fourth = [](auto const& r) { return r * r * r * r; };
    return fourth(q(0)) + fourth(q(2) - q(1)) + fourth(q(4) - q(3)) + fourth(q(5));
};

int main() {
    auto const T = uniform(0.0, 0.1, 2000); // omega h = 5: explicit steps are unstable from 2 on
    constexpr unknown q;
    constexpr auto q_o = extend[q];
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v.squaredNorm() / 2 - stiff(x); }};
    constexpr lagrangian U{[](auto const& x, auto const&) { return soft(x); }};

    auto const in_the_middle = integral(L(q_o, Delta_o_plus[q_o]), half(T));
    auto const at_the_ends = 0.5 * (integral(U(q, Delta_plus[q]), T) + nabla_integral(U(q, Delta_minus[q]), T));
    auto const EL = variation(in_the_middle - at_the_ends);
    std::cout << EL;

    constexpr lagrangian whole{[](auto const& x, auto const& v) { return v.squaredNorm() / 2 - stiff(x) - soft(x); }};
    state6 const q0 = (state6() << 1 - 1 / omega, 1 + 1 / omega, 0, 0, 0, 0).finished() / std::sqrt(2.0);
    state6 const v0 = (state6() << 0, 2, 0, 0, 0, 0).finished() / std::sqrt(2.0);
    auto const report = [&](char const* name, auto const& flow) {
        try {
            auto const path = flow.along(T, initial_velocity<state6>{q0, v0});
            double const drift = drift_along(path, energy(whole)).largest;
            std::cout << name << ": largest error of energy " << drift << '\n';
            return drift;
        } catch (error::exception const& e) {
            std::cout << name << ": " << e.what() << '\n';
            return std::numeric_limits<double>::infinity();
        }
    };
    double const sum = report("middle and ends", flow_of(EL));
    double const implicit = report("mid-point", embed(whole, mid_point));
    double const explicitly = report("Stoermer-Verlet", stoermer_verlet(whole));
    auto const x = solve(EL, T, {.q0 = q0, .v0 = v0});
    std::cout << "largest residual of the equation: " << largest_residual(EL, x) << '\n';
    return sum < 0.1 and implicit < 0.1 and explicitly > 1 ? 0 : 1;
}
