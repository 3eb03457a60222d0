// SPDX-License-Identifier: BSL-1.0
// What a solution does inside its steps. Where the operators of an action read points inside the steps, as those of galerkin<s, Q> do, the
// equation at these points says what the values there are, each step for itself, once those on T are known:
//   auto const EL = variation(integral(L(G.position[q], G.velocity[q]), at_nodes<gauss, 3>(T)));
//   auto const x = with_inner_points(EL, values_on_T);        // on T/3; EL.residual(x) is then zero inside, and at T where x solves EL
#pragma once

#include <vector>

#include "hilger/function/function.hpp"
#include "hilger/integrator/march.hpp"
#include "hilger/newton/newton.hpp"
#include "hilger/step/state.hpp"
#include "hilger/variational/variation.hpp"

namespace hilger {

/// The function that is x on T, and inside the steps solves the equation, of a Lagrangian with a force f(q, v) or f(t, q, v) beside dL/dq
/// or without. @throws newton_failure, error::singular, error::not_finite with the points between which there is no solution
template <class Action, discrete_function X, class Force = no_force>
auto with_inner_points(euler_lagrange<Action> const& equation, X const& x, Force const& force = {}) {
    using Root = typename Action::root_type;
    using Base = typename Action::position_type::from;
    using S = typename Root::scalar_type;
    using V = value_of<X>;
    using s = detail::shape<V>;
    using vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;
    static_assert(std::same_as<typename X::domain_type, domain<nodes>>, "the values that are known are those of a function on T");
    constexpr index_type parts = Base::last(1);
    constexpr int inside = static_cast<int>(parts) - 1;
    Root const& T = x.root();
    int const d = s::dimension(x.get(0));
    std::vector<V> all(static_cast<std::size_t>(Base::last(T.steps()) + 1), V(x.get(0)));
    detail::values_so_far<V, Root, Base> const made{{}, &T, &all};
    auto const at = [&](index_type j) -> V& { return all[static_cast<std::size_t>(j)]; };
    auto const residual = equation.residual(made, force);
    for (index_type i = 0; i <= T.steps(); ++i) at(parts * i) = V(x.get(i));
    if constexpr (inside > 0)
        for (index_type i = 0; i < T.steps(); ++i) {
            vector guess(inside * d), rounding(inside * d);
            auto const put = [&](vector const& y) {
                for (int m = 0; m < inside; ++m)
                    for (int c = 0; c < d; ++c) s::component(at(parts * i + m + 1), c) = y(m * d + c);
            };
            auto const system = [&](vector const& y) {
                put(y);
                newton_system<vector> now{vector(inside * d), block_of<vector>(inside * d, inside * d)};
                for (int n = 0; n < inside; ++n) {
                    auto const slope = equation.residual_slope(made, parts * i + n + 1, force);
                    for (int m = 0; m < inside; ++m) {
                        auto const block = slope.get(parts * i + m + 1);
                        for (int c = 0; c < d; ++c)
                            for (int e = 0; e < d; ++e) now.jacobian(m * d + c, n * d + e) = s::entry(block, c, e);
                    }
                }
                for (int m = 0; m < inside; ++m) {
                    V const row = residual.get(parts * i + m + 1);
                    for (int c = 0; c < d; ++c) now.residual(m * d + c) = s::component(row, c);
                }
                return now;
            };
            V const &first = at(parts * i), &last = at(parts * (i + 1));
            for (int m = 0; m < inside; ++m)
                for (int c = 0; c < d; ++c)
                    guess(m * d + c) = s::component(first, c) + (s::component(last, c) - s::component(first, c)) * S(m + 1) / S(parts);
            auto jacobian = system(guess).jacobian;
            rounding.setConstant(S(detail::largest_entry(jacobian)) * std::max(S(magnitude(first)), S(magnitude(last))));
            saying_where(state<S, V>{S(T.point(i)), first, zero_like(first)}, S(T.step(i)),
                         [&] { put(newton(system, guess, rounding, "the equation inside a step")); });
        }
    return function_on(derived_scale(T, domain<Base>{}), std::move(all));
}

} // namespace hilger
