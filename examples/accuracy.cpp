// SPDX-License-Identifier: BSL-1.0
// A motion to a wanted accuracy: the embedding and the number of steps are found. Prints what was chosen for some accuracies, and how far
// the end is from Kepler's equation.
#include <cmath>
#include <iomanip>
#include <iostream>

#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    auto const kepler = [](auto const& q, auto const& v) { return v.squaredNorm() / 2 + 1 / q.norm(); };
    initial_velocity<Eigen::Vector2d> const from{{0.4, 0.0}, {0.0, 2.0}};

    double E = 50; // t = E - e sin E for e = 3/5, at t = 50
    for (int i = 0; i < 50; ++i) E -= (E - 0.6 * std::sin(E) - 50) / (1 - 0.6 * std::cos(E));
    Eigen::Vector2d const end(std::cos(E) - 0.6, 0.8 * std::sin(E));

    bool all = true;
    std::cout << "wanted   method                     steps   within      in truth\n" << std::scientific << std::setprecision(1);
    for (double const wanted : {1e-2, 1e-6, 1e-10}) {
        auto const x = solve(kepler, interval{0.0, 50.0}, from, accuracy{wanted});
        double const error = (x.end.q - end).norm();
        std::cout << wanted << "  " << std::left << std::setw(25) << x.method << std::right << std::setw(7) << x.steps << std::setw(10)
                  << x.error << std::setw(12) << error << '\n';
        all = all and error <= wanted;
    }

    // A force may be of time; the driven oscillator below moves as 5 sin t, and what it starts with dies away.
    auto const spring = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };
    auto const driven = [](auto const& t, auto const& q, auto const& v) { return cos(t) - v / 5 + 0 * q; };
    auto const x = solve(with_force(spring, driven), interval{0.0, 50.0}, initial_velocity<double>{0.0, 5.0}, accuracy{1e-9});
    std::cout << "5 sin 50 within " << std::abs(x.end.q - 5 * std::sin(50.0)) << " by " << x.method << '\n';

    // And a pendulum with a memory, x'' + sin x + D^{1/2}[x - 1] = 0; x(1) is known from six stages.
    auto const pendulum = [](auto const& q, auto const& v) { return v * v / 2 + cos(q); };
    auto const y =
        solve(with_fractional_damping(pendulum, 1.0, fraction<1, 2>{}), interval{0.0, 1.0}, {.q0 = 1.0, .v0 = 1.0}, accuracy{1e-12});
    double const at_one = 1.34165212463519;
    std::cout << at_one << " within " << std::abs(y.end.q - at_one) << " by " << y.method << " in " << y.steps << " steps\n";
    return all and std::abs(x.end.q - 5 * std::sin(50.0)) <= 1e-9 and std::abs(y.end.q - at_one) <= 1e-12 ? 0 : 1;
}
