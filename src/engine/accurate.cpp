// SPDX-License-Identifier: BSL-1.0
// Solutions to an accuracy, from initial values and between two ends.
#include "engine/motions.hpp"
#include "hilger/accuracy/between_ends.hpp"
#include "hilger/accuracy/from_start.hpp"

namespace engine {

namespace {

template <class Data>
accurate solved(problem const& what, hilger::interval<double> const& I, Data const& from, hilger::accuracy const& goal) {
    if (what.has_memory())
        hilger::error::raise<hilger::error::invalid_parameter>("an accuracy is for Lagrangians and forces, without fractional damping");
    if (what.time_transformation)
        hilger::error::raise<hilger::error::invalid_parameter>("an accuracy chooses its own steps in t: it is for Lagrangians in t");
    return with_mechanics(what, [&](auto const& mechanics) {
        auto const x = hilger::solve(mechanics, I, from, goal);
        accurate made{elements_of<double>(x.q.root()), {}, {}, x.method, x.error};
        for (hilger::index_type i = x.q.first(); i <= x.q.last(); ++i) {
            made.q.push_back(x.q[i]);
            made.p.push_back(x.p[i]);
        }
        return made;
    });
}

} // namespace

accurate solve_accurately(problem const& what, hilger::interval<double> const& I, hilger::initial_velocity<vector<double>> const& from,
                          hilger::accuracy const& goal) {
    return solved(what, I, from, goal);
}
accurate solve_accurately(problem const& what, hilger::interval<double> const& I, hilger::boundary_values<vector<double>> const& ends,
                          hilger::accuracy const& goal) {
    return solved(what, I, ends, goal);
}

} // namespace engine
