// SPDX-License-Identifier: BSL-1.0
#include "beam.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>

#include "hilger/hilger.hpp"
#include "plot.hpp"

namespace program {

int run_beam(std::string const& out) {
    using hilger::fraction;
    double const length = 0.15, width = 0.025, thickness = 0.005, density = 1000;                  // m, kg/m^3
    double const relaxed = 1e6, unrelaxed = 50e6, relaxation_time = 1e-3, force = 0.01, t1 = 0.05; // Pa, s, N, s
    double const inertia = width * std::pow(thickness, 3) / 12;
    auto const beam = hilger::cantilever(length, relaxed * inertia, density * width * thickness, 5);
    hilger::zener_structure const material{beam.mass, beam.stiffness, relaxed, unrelaxed, relaxation_time, fraction<1, 2>{}};
    auto const load = [&](double t) -> Eigen::VectorXd { return Eigen::VectorXd::Unit(10, beam.tip()) * force * std::min(t / t1, 1.0); };
    auto const scheme = hilger::newmark<hilger::bdf<2>>(material, load);

    std::filesystem::create_directories(out);
    auto const path = (std::filesystem::path(out) / "viscoelastic_beam.csv").string();
    std::ofstream file(path);
    if (not file) hilger::error::raise<hilger::error::unreadable>("cannot write '", path, "'");
    file << "# t in s, deflection of the tip in m, its velocity in m/s\n" << std::setprecision(12);
    Eigen::VectorXd const rest = Eigen::VectorXd::Zero(10);
    double largest = 0, last = 0;
    for (auto const& [t, q, p] : scheme.along(hilger::uniform(0.0, 0.002, 500), rest, rest)) {
        last = q(beam.tip());
        largest = std::max(largest, last);
        file << t << ',' << last << ',' << scheme.velocity(p)(beam.tip()) << '\n';
    }
    file.close();
    std::cout
        << "A cantilever of 150 mm, five elements, fractional Zener material of order 1/2 (1 MPa relaxed, 50 MPa not), G^alpha-Newmark\n"
        << "tip under 10 mN: largest deflection " << 1000 * largest << " mm, after 1 s " << 1000 * last << " mm, relaxed "
        << 1000 * force * std::pow(length, 3) / (3 * relaxed * inertia) << " mm\n";
    auto const picture = draw(out, "viscoelastic_beam",
                              "set grid; unset key\n"
                              "set title 'Tip displacement'; set xlabel 't / s'; set ylabel 'w / mm'\n"
                              "plot 'viscoelastic_beam.csv' using 1:($2*1000) with lines\n"
                              "set title 'Phase diagram'; set xlabel 'w / mm'; set ylabel 'velocity / mm/s'\n"
                              "plot 'viscoelastic_beam.csv' using ($2*1000):($3*1000) with lines\n");
    std::cout << "Written: " << path << " and " << picture << '\n';
    return 0;
}

} // namespace program
