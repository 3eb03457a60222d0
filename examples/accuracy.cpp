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
    return all ? 0 : 1;
}
