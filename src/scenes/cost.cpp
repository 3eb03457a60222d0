// SPDX-License-Identifier: BSL-1.0
#include "cost.hpp"

#include <iostream>
#include <sstream>

#include "from_file.hpp"
#include "hilger/hilger.hpp"
#include "scene.hpp"
#include "structures.hpp"

namespace program {

namespace {

auto scale_of(scene const& s) { return hilger::uniform(hilger::interval{s.t0, s.t1}, s.usual.steps); }
void head(std::ostream& out, scene const& s) { hilger::write_heading(out << '\n' << s.name << ", h = " << scale_of(s).h() << '\n'); }

/// Implicit; and explicit where the system lets it be.
void tell_stated(std::ostream& out, scene const& s) {
    auto const& L = s.stated->of.lagrangian;
    hilger::initial_velocity<engine::vector<double>> const from{numbers_of(s.stated->q), numbers_of(s.stated->v)};
    auto const row = [&](char const* method, auto const& flow) {
        out << hilger::requirements_row{method, hilger::requirements_of(flow.along(scale_of(s), from))};
    };
    head(out, s);
    row("mid-point", hilger::embed(L, hilger::mid_point));
    row("verlet", hilger::stoermer_verlet(L));
}
/// With a memory, from rest: kept as the scene usually has it, and whole.
template <class Structure, class Load, class V>
void tell_structure(std::ostream& out, char const* name, Structure const& on, Load const& load, V const& rest) {
    scene const& s = scene_named(name);
    auto const row = [&](char const* history, auto const& policy) {
        auto const scheme = hilger::newmark<hilger::bdf<2>>(on, load, hilger::average_acceleration, policy);
        out << hilger::requirements_row{history, hilger::requirements_of(scheme.along(scale_of(s), rest, rest))};
    };
    head(out, s);
    row("exponentials", hilger::exponentials{0.0, s.usual.steps + 1});
    row("direct", hilger::direct{});
}
/// Not stepped: all points at once.
void tell_boundary(std::ostream& out) {
    scene const& s = scene_named("fractional-dirichlet");
    auto const found = fractional_dirichlet_solution(s.usual.steps);
    out << '\n'
        << s.name << ", N = " << s.usual.steps << ": no steps; " << found.iterations << " corrections by Newton's method, "
        << found.applications << " applications of its matrix\n";
}

} // namespace

void list_costs(std::ostream& out) {
    out << "A step of each, counted: what is computed, solved, and kept beside the state\n";
    for (scene const& s : all_scenes())
        if (s.stated and s.stated->of.damping.empty() and not s.stated->of.force) tell_stated(out, s);
    viscoelastic_beam_system const beam;
    tell_structure(out, "fractional-oscillator", damped_by_half_a_derivative.structure<double>(), damped_by_half_a_derivative.load(), 0.0);
    tell_structure(out, "bagley-torvik", plate_in_a_fluid.structure<double>(), plate_in_a_fluid.load(), 0.0);
    tell_structure(out, "viscoelastic-beam", beam.structure(), beam.load(), beam.rest());
    tell_boundary(out);
}

} // namespace program
