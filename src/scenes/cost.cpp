// SPDX-License-Identifier: BSL-1.0
#include "cost.hpp"

#include <iostream>
#include <sstream>

#include "hilger/hilger.hpp"
#include "outer_solar_system_data.hpp"
#include "scene.hpp"
#include "systems.hpp"

namespace program {

namespace {

auto scale_of(scene const& s) { return hilger::uniform(hilger::interval{s.t0, s.t1}, s.usual.steps); }
void head(std::ostream& out, scene const& s) { hilger::write_heading(out << '\n' << s.name << ", h = " << scale_of(s).h() << '\n'); }

/// Implicit; and explicit where the system lets it be.
template <class System>
void tell(std::ostream& out, char const* name, System const& system) {
    scene const& s = scene_named(name);
    auto const L = system.template lagrangian<double>();
    auto const start = system.template start<double>();
    auto const row = [&](char const* method, auto const& flow) {
        auto const path = flow.along(scale_of(s), start.q0, hilger::momentum_of(L, start.q0, start.v0));
        out << hilger::requirements_row{method, hilger::requirements_of(path)};
    };
    head(out, s);
    row("mid-point", hilger::embed(L, hilger::midpoint));
    if constexpr (System::wide != in_many_digits::nothing) row("verlet", hilger::stoermer_verlet(L));
}
/// u'' + D^(1/2) u + u = 1 under mid-point, by its histories.
void tell_fractional(std::ostream& out) {
    scene const& s = scene_named("fractional-oscillator");
    auto const L = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2 + q; };
    auto const row = [&](char const* history, auto const& policy) {
        auto const damped = hilger::with_fractional_damping(L, 1.0, hilger::fraction<1, 2>{}, policy);
        out << hilger::requirements_row{history,
                                        hilger::requirements_of(hilger::embed(damped, hilger::midpoint).along(scale_of(s), 0.0, 0.0))};
    };
    head(out, s);
    row("exponentials", hilger::exponentials{0.0, s.usual.steps + 1});
    row("window:1000", hilger::window{1000});
    row("direct", hilger::direct{});
}

} // namespace

void list_costs(std::ostream& out) {
    out << "A step of each, counted: what is computed, solved, and kept beside the state\n";
    tell(out, "pendulum", pendulum_system{});
    tell(out, "double-pendulum", double_pendulum_system{});
    tell(out, "kepler", kepler_system{});
    tell(out, "henon-heiles", henon_heiles_system{});
    std::istringstream built_in(outer_solar_system_csv);
    tell(out, "outer-solar-system", planetary_system{read_solar_system(built_in, "the built-in data")});
    tell(out, "fermi-pasta-ulam", fermi_pasta_ulam_system{});
    tell(out, "charged-particle", charged_particle_system{});
    tell_fractional(out);
}

} // namespace program
