// SPDX-License-Identifier: BSL-1.0
// Walks of Galerkin's embedding in steps that adapt to a tolerance (hilger/accuracy/adapted_steps.hpp), with states of static size for
// few coordinates and no force.
#include "engine/motions.hpp"
#include "engine/small_lagrangian.hpp"
#include "hilger/accuracy/adapted_steps.hpp"
#include "hilger/accuracy/pieces.hpp"

namespace engine {

namespace {

/// Walks to the last of the ends of pieces. The trace of a small Lagrangian remains for the next walk.
template <int Nodes, class Mechanics, class V>
adapted_walk walk_by(Mechanics const& mechanics, std::vector<double> const& ends, hilger::initial_velocity<V> const& from) {
    return [flow = hilger::embed(mechanics, hilger::galerkin<Nodes, hilger::gauss>), ends, from](double tolerance) -> vector<double> {
        auto const watch = [](hilger::index_type made) {
            if (made > 1 << 22) hilger::error::raise<hilger::error::no_convergence>("the walk needs more than ", 1 << 22, " steps");
        };
        hilger::detail::adapted_steps<Nodes, decltype(flow), double, V, decltype(watch)> const steps(flow, ends, from, watch);
        auto const made = steps.adapted_to([=](double) { return tolerance; }, (ends.back() - ends.front()) / 32);
        return made.q.back();
    };
}

template <int Nodes>
adapted_walk walk_of(problem const& what, std::vector<double> const& ends, vector<double> const& q0, vector<double> const& v0) {
    if (what.force) return walk_by<Nodes>(forced_problem{what.lagrangian, *what.force}, ends, hilger::initial_velocity{q0, v0});
    return with_small_size(static_cast<int>(q0.size()), [&]<int D>(std::integral_constant<int, D>) {
        if constexpr (D == 0)
            return walk_by<Nodes>(what.lagrangian, ends, hilger::initial_velocity{q0, v0});
        else {
            using V = Eigen::Matrix<double, D, 1>;
            return walk_by<Nodes>(small_lagrangian<double, D>(what.lagrangian), ends, hilger::initial_velocity<V>{q0, v0});
        }
    });
}

} // namespace

adapted_walk walk_in_adapted_steps(problem const& what, std::string const& method, double a, double b, vector<double> const& q0,
                                   vector<double> const& v0) {
    if (what.has_memory() or what.time_transformation or not what.besides.empty())
        hilger::error::raise<hilger::error::invalid_parameter>(
            "adapted steps are for one Lagrangian in t and a force, without fractional damping");
    prepare_machine_code();
    hilger::interval<double> const I{a, b};
    auto const ends =
        what.force ? hilger::detail::ends_of_pieces(I, what.lagrangian, *what.force) : hilger::detail::ends_of_pieces(I, what.lagrangian);
    if (method == "gauss-6") return walk_of<6>(what, ends, q0, v0);
    if (method == "gauss-8") return walk_of<8>(what, ends, q0, v0);
    hilger::error::raise<hilger::error::invalid_parameter>("the methods with adapted steps are gauss-6 and gauss-8, and not '", method,
                                                           "'");
}

} // namespace engine
