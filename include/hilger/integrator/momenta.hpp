// SPDX-License-Identifier: BSL-1.0
// The momenta of a solution given by its positions, as one between two ends:
//   auto const x = solve(EL, T, {.q0 = a, .qN = b});
//   auto const p = momenta_of(flow_of(EL), x);        // p in C(T)
#pragma once

#include <vector>

#include "hilger/function/function.hpp"
#include "hilger/integrator/flow.hpp"

namespace hilger {

/// p in C(T) along a solution x of the flow's equation, forces included: p_i = -d_1 L_h of the step that begins at t_i, and at the end of T
/// d_2 L_h of the last step (Cresson-Safi, definition 12). x has the values inside the steps too where the embedding reads them, as `solve`
/// returns it. Where x is no solution, the momenta at the end of a step and the start of the next differ: these are the latter.
/// @throws error::mismatch where T has no step
template <class F, class Force, class E, sums Sums, discrete_function X>
auto momenta_of(flow<F, Force, E, Sums> const& method, X const& x) {
    using Root = typename X::root_type;
    using S = typename Root::scalar_type;
    using V = value_of<X>;
    constexpr index_type parts = controls_of<E> - 1;
    using Domain = typename X::domain_type;
    static_assert(Domain::front == 0 and Domain::back == 0 and Domain::base_type::last(1) == parts,
                  "momenta are those of a function on T, which has the values inside the steps too where the embedding reads them, as "
                  "solve(equation, T, ...) returns it and with_inner_points(equation, x)");
    Root const& T = x.root();
    if (T.steps() < 1) error::raise<error::mismatch>("momenta are those of steps, and ", T, " has none");
    auto const derivatives = detail::derivatives_at_nodes(method.mechanics());
    auto how = tableau_of(method.embedding(), S(T.step(0)));
    std::vector<V> p;
    p.reserve(static_cast<std::size_t>(T.size()));
    for (index_type i = 0; i < T.steps(); ++i) {
        S const h(T.step(i));
        if (not Root::is_uniform and i > 0) how = tableau_of(method.embedding(), h);
        auto [before, after] = detail::momenta_of_step(derivatives, how, S(T.point(i)), h, [&](int m) { return V(x.get(parts * i + m)); });
        p.push_back(std::move(before));
        if (i + 1 == T.steps()) p.push_back(std::move(after));
    }
    return function_on(T, std::move(p));
}

} // namespace hilger
