// SPDX-License-Identifier: BSL-1.0
// Lagrangians of second degree with constant coefficients,
//   L = v.Mv/2 - q.Kq/2 + f.q,
// as linear structures (fractional/structure.hpp). M, K and f are derivatives of L's traced formula, which shows that they are constant:
//   auto const [M, K, f] = second_degree_of<double>(L, 2);
//   newmark<bdf<2>>(fractional_structure{M, C, K, tau, alpha}, [f](double) { return f; })
#pragma once

#include "hilger/differentiation/derivatives.hpp"
#include "hilger/variational/nodes/gradients.hpp"

namespace engine {

/// Mass and stiffness, d x d and symmetric, and a constant load of d components.
template <class S>
struct second_degree {
    Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> mass, stiffness;
    Eigen::Matrix<S, Eigen::Dynamic, 1> load;
};

/// L(q, v) of d coordinates, generic in the number type.
/// @throws hilger::error::invalid_parameter, which names the term of L that is not of this kind; hilger::error::not_finite
template <class S, class L>
second_degree<S> second_degree_of(L const& l, int d) {
    using V = Eigen::Matrix<S, Eigen::Dynamic, 1>;
    using namespace hilger;
    using namespace hilger::detail;
    auto const refuse = [](char const* what) {
        error::raise<error::invalid_parameter>(
            "a linear structure has a Lagrangian v.Mv/2 - q.Kq/2 + f.q with constant M, K and f, and this "
            "one has ",
            what);
    };
    if (reads_time_in<S, V>(l)) refuse("the time: what drives a structure is a force");
    V const rest = V::Zero(d);
    traced_there<V> const at(rest, rest, on_position | on_velocity, [&](auto const& q, auto const& v, auto&) {
        return as_jet<traced<S>>(at_time{l, S(0)}(q, v));
    });
    auto const& places = at.formula.places;
    if (not at.formula.guards.empty()) refuse("branches");
    if (not places.constant[block_vv]) refuse("a mass that changes");
    if (not places.constant[block_qq]) refuse("a force that is not linear in q");
    if (not places.entries[block_qv].empty()) refuse("a term with both q and v");
    if (not(magnitude(at.by_v) == S(0))) refuse("a term that is linear in v");
    second_degree<S> made{block_of<V>::Zero(d, d), block_of<V>::Zero(d, d), at.by_q};
    at.for_each_in(block_vv, [&](int row, int column, S const& x) { made.mass(row, column) = x; });
    at.for_each_in(block_qq, [&](int row, int column, S const& x) { made.stiffness(row, column) = -x; });
    if (not is_finite(made.mass) or not is_finite(made.stiffness) or not is_finite(made.load))
        error::raise<error::not_finite>("a linear structure has finite numbers, and this Lagrangian has NaN or infinity");
    return made;
}

} // namespace engine
