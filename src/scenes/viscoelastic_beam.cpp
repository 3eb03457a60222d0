// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include "hilger/integrator/fractional_zener.hpp"
#include "hilger/mechanics/beam.hpp"
#include "histories.hpp"
#include "path_walk.hpp"
#include "scenes.hpp"

namespace program {

scene viscoelastic_beam() {
    scene s;
    s.name = "viscoelastic-beam";
    s.title = "A cantilever of 150 mm under 10 mN at its tip, fractional Zener material (Galucio, Deue, "
              "Dubois, section 4)";
    s.units = "s";
    s.dimension = 10;
    s.t1 = 1;
    s.usual = {"g-alpha-newmark", "double", "exponentials", 500};
    s.embeddings = newmark_names();
    s.scalars = {"double"};
    s.histories = history_names();
    s.begin = [t1 = s.t1](configuration const& c) {
        double const length = 0.15, width = 0.025, thickness = 0.005, density = 1000;                      // m, kg/m^3
        double const relaxed = 1e6, unrelaxed = 50e6, relaxation_time = 1e-3, force = 0.01, loaded = 0.05; // Pa, s, N, s
        auto const beam = hilger::cantilever(length, relaxed * width * std::pow(thickness, 3) / 12, density * width * thickness, 5);
        hilger::zener_structure const material{beam.mass, beam.stiffness, relaxed, unrelaxed, relaxation_time, hilger::fraction<1, 2>{}};
        auto const load = [tip = beam.tip(), force, loaded](double t) -> Eigen::VectorXd {
            return Eigen::VectorXd::Unit(10, tip) * force * std::min(t / loaded, 1.0);
        };
        Eigen::VectorXd const rest = Eigen::VectorXd::Zero(10);
        auto const T = hilger::uniform(hilger::interval{0.0, t1}, c.steps);
        std::unique_ptr<walk> result;
        with_newmark(c, material, load, [&](auto const& scheme) {
            result = walk_along(scheme.along(T, rest, rest),
                                [scheme, tip = beam.tip()](auto const& x) { return std::vector<double>{scheme.velocity(x.p)(tip)}; });
        });
        return result;
    };
    s.columns = {"t"};
    for (char const* x : {"w_", "p_"})
        for (int k = 0; k < 10; ++k) s.columns.push_back(x + std::to_string(k));
    s.columns.emplace_back("velocity of the tip");
    s.picture =
        "set title 'Displacement of the tip'; set xlabel 't / s'; set ylabel 'w / mm'; plot DATA using 1:($10*1000) with lines notitle\n"
        "set title 'Phase'; set xlabel 'w / mm'; set ylabel 'velocity / mm/s'\n"
        "plot DATA using ($10*1000):($22*1000) with lines notitle\n";
    return s;
}

} // namespace program
