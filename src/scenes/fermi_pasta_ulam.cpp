// SPDX-License-Identifier: BSL-1.0
#include "path_walk.hpp"
#include "scenes.hpp"
#include "systems.hpp"

namespace program {

PROGRAM_MANY_DIGITS(extern, fermi_pasta_ulam_system)

scene fermi_pasta_ulam() {
    constexpr int d = fermi_pasta_ulam_system::size;
    scene s;
    s.name = "fermi-pasta-ulam";
    s.title = "A chain of 32 particles between walls, springs r^2/2 + r^3/12, in its lowest mode";
    s.dimension = d;
    s.t1 = 100;
    s.usual = {"mid-point", "double", "", 1'000};
    s.columns = {"t"};
    for (char const* x : {"q_", "p_"})
        for (int k = 0; k < d; ++k) s.columns.push_back(x + std::to_string(k));
    s.columns.emplace_back("energy error");
    s.invariants = {"energy"};
    s.picture = "set title 'Particles'; set xlabel 't'; plot for [k=2:33:4] DATA using 1:k with lines title sprintf('q_{%d}', k-2)\n"
                "set title 'Energy error'; plot DATA using 1:" +
                std::to_string(2 * d + 2) + " with lines notitle\n";
    s.reference = {"kahan-li-8", "50-digits", "", 2'000};
    return scene_of(fermi_pasta_ulam_system{}, s);
}

} // namespace program
