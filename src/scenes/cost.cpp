// SPDX-License-Identifier: BSL-1.0
#include "cost.hpp"

#include <iostream>
#include <sstream>

#include "hilger/hilger.hpp"
#include "problems/from_file.hpp"
#include "problems/scene.hpp"
#include "text/in_numbers.hpp"

HILGER_FORMULAS_IN(hilger::counted) // costs alone are computed in these

namespace program {

namespace {

auto scale_of(scene const& s) { return hilger::uniform(hilger::interval{s.t0, s.t1}, s.usual.steps); }
void head(std::ostream& out, scene const& s) { hilger::write_heading(out << '\n' << s.name << ", h = " << scale_of(s).h() << '\n'); }
/// Implicit; and explicit where the system lets it be.
void tell_free(std::ostream& out, scene const& s) {
    auto const& L = s.stated->of.lagrangian;
    hilger::initial_velocity<engine::vector<double>> const from{numbers_of(s.stated->q), numbers_of(s.stated->v)};
    auto const row = [&](char const* method, auto const& flow) {
        out << hilger::requirements_row{method, hilger::requirements_of(flow.along(scale_of(s), from))};
    };
    row("mid-point", hilger::embed(L, hilger::mid_point));
    row("verlet", hilger::stoermer_verlet(L));
}

} // namespace

void list_costs(std::ostream& out, std::string const& name) {
    out << "A step of each, counted: what is computed, solved, and kept beside the state\n";
    auto const tell = [&](scene const& s) {
        stated_problem const& what = *s.stated;
        if (not what.last.empty()) { // not stepped
            out << '\n' << s.name << ": all points at once\n";
            return;
        }
        head(out, s);
        if (s.usual.embedding == "g-alpha-newmark")
            for (bool const whole : {false, true})
                out << hilger::requirements_row{whole ? "direct" : "exponentials", requirements_of_structure(what, s.usual.steps, whole)};
        else if (what.of.force or what.of.has_memory())
            out << hilger::requirements_row{"mid-point", requirements_with_force(what, s.usual.steps)};
        else
            tell_free(out, s);
    };
    if (not name.empty()) return tell(scene_named(name));
    for (scene const& s : all_scenes()) tell(s);
}

} // namespace program
