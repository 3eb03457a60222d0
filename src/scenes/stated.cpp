// SPDX-License-Identifier: BSL-1.0
#include "engine/machine_code/machine_code.hpp"
#include "stated_walk.hpp"

namespace program {

extern template std::unique_ptr<walk> begin_in_numbers<hilger::float50>(stated_problem const&, configuration const&);
extern template std::unique_ptr<walk> begin_in_numbers<hilger::float100>(stated_problem const&, configuration const&);

std::vector<std::string> embeddings_of(stated_problem const& what) {
    if (not what.of.damping.empty()) return {"mid-point"};
    if (what.of.force) return {"order-one", "mid-point", "gauss-4"};
    std::vector<std::string> all(method_names.begin(), method_names.end());
    all.pop_back(); // gauss-16 is for systems in C++
    return all;
}
std::vector<std::string> scalars_of(stated_problem const& what) {
    if (not what.of.damping.empty()) return {"double"};
    if (what.of.force) return {"double", "50-digits"};
    return {"double", "50-digits", "100-digits"};
}

engine::points<double> points_of(stated_problem const& what, hilger::index_type steps) {
    auto const number = [](std::string const& digits) { return *hilger::text::number_in<double>(digits); };
    auto const T = hilger::uniform(hilger::interval<double>{number(what.start), number(what.end)}, steps);
    return {T.min(), T.h(), steps, {}};
}

std::unique_ptr<walk> begin_stated(stated_problem const& what, configuration const& c) {
    engine::prepare_machine_code();
    if (c.scalar == "50-digits") return begin_in_numbers<hilger::float50>(what, c);
    if (c.scalar == "100-digits") return begin_in_numbers<hilger::float100>(what, c);
    return begin_in_numbers<double>(what, c);
}

engine::walker walker_of_member(engine::problem const& one, configuration const& c, engine::points<double> const& T) {
    return [one, c, T](engine::initial<double> const& from, auto const& keep) {
        with_flow<double>(one, c, [&](auto const& flow) {
            hilger::initial_velocity<engine::vector<double>> const start{from.q0, from.other};
            for (auto const& x : flow.along(hilger::uniform(T.start, T.step, T.steps), start))
                if (not keep(x.t, x.q, x.p)) return;
        });
    };
}

} // namespace program
