// SPDX-License-Identifier: BSL-1.0
#include "histories.hpp"
#include "path_walk.hpp"
#include "scenes.hpp"
#include "structures.hpp"

namespace program {

scene viscoelastic_beam() {
    scene s;
    s.name = "viscoelastic-beam";
    s.title = "A cantilever of 150 mm under 10 mN at its tip, fractional Zener material (Galucio, Deue, "
              "Dubois, section 4)";
    s.units = "s";
    s.dimension = viscoelastic_beam_system::degrees_of_freedom;
    s.t1 = 1;
    s.usual = {"g-alpha-newmark", "double", "exponentials", 500};
    s.embeddings = newmark_names();
    s.scalars = {"double"};
    s.histories = history_names();
    s.begin = [t1 = s.t1](configuration const& c) {
        viscoelastic_beam_system const beam;
        auto const T = hilger::uniform(hilger::interval{0.0, t1}, c.steps);
        std::unique_ptr<walk> result;
        with_newmark(c, beam.structure(), beam.load(), [&](auto const& scheme) {
            result = walk_along(scheme.along(T, beam.rest(), beam.rest()),
                                [scheme, tip = beam.tip()](auto const& x) { return std::vector<double>{scheme.velocity(x.p)(tip)}; });
        });
        return result;
    };
    s.columns = {"t"};
    for (char const* x : {"w_", "p_"})
        for (int k = 0; k < s.dimension; ++k) s.columns.push_back(x + std::to_string(k));
    s.columns.emplace_back("velocity of the tip");
    s.picture =
        "set title 'Displacement of the tip'; set xlabel 't / s'; set ylabel 'w / mm'; plot <rows> using 1:($10*1000) with lines notitle\n"
        "set title 'Phase'; set xlabel 'w / mm'; set ylabel 'velocity / mm/s'\n"
        "plot <rows> using ($10*1000):($22*1000) with lines notitle\n";
    return s;
}

} // namespace program
