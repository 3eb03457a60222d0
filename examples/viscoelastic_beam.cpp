// SPDX-License-Identifier: BSL-1.0
// A viscoelastic cantilever under a force at its tip (Galucio, Deue, Dubois 2008, section 4): 150 mm x 25 mm x 5 mm, five finite elements,
// a fractional Zener material of order 1/2 whose modulus relaxes from 50 MPa to 1 MPa. Prints the tip's deflection and velocity.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>

#include "beam.hpp"
#include "hilger/fractional/newmark.hpp"
#include "hilger/fractional/zener.hpp"
#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    double const length = 0.15, width = 0.025, thickness = 0.005, density = 1000;                  // m, kg/m^3
    double const relaxed = 1e6, unrelaxed = 50e6, relaxation_time = 1e-3, force = 0.01, t1 = 0.05; // Pa, s, N, s
    double const area = width * thickness, inertia = width * std::pow(thickness, 3) / 12;

    auto const beam = beams::cantilever(length, relaxed * inertia, density * area, 5);
    auto const load = [&](double t) -> Eigen::VectorXd { return Eigen::VectorXd::Unit(10, beam.tip()) * force * std::min(t / t1, 1.0); };
    zener_structure const material{beam.mass, beam.stiffness, relaxed, unrelaxed, relaxation_time, fraction<1, 2>{}};
    auto const scheme = newmark<bdf<2>>(material, load); // G^alpha with average acceleration

    Eigen::VectorXd const rest = Eigen::VectorXd::Zero(10);
    double const static_deflection = force * std::pow(length, 3) / (3 * relaxed * inertia);
    double largest = 0, last = 0;
    std::cout << "  t (ms)   tip (mm)   velocity (mm/s)\n" << std::fixed << std::setprecision(3);
    int step = 0;
    for (auto const& [t, q, p] : scheme.along(uniform(0.0, 0.002, 500), rest, rest)) {
        last = q(beam.tip());
        largest = std::max(largest, last);
        if (step++ % 50 == 0)
            std::cout << std::setw(8) << 1000 * t << std::setw(11) << 1000 * last << std::setw(18) << 1000 * scheme.velocity(p)(beam.tip())
                      << '\n';
    }
    std::cout << "relaxed, after a long time: " << 1000 * static_deflection << " mm\n";
    return 0 < last and last < static_deflection and largest < static_deflection ? 0 : 1;
}
