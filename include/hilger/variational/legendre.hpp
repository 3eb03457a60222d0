// SPDX-License-Identifier: BSL-1.0
// The Legendre map v -> p = dL/dv(q, v), its inverse, and the Hamiltonian H(p, q) = p.v - L(q, v) (Cresson-Safi (79), (81), (93)).
#pragma once

#include "hilger/differentiation/derivatives.hpp"
#include "hilger/newton/system.hpp"
#include "hilger/variational/nodes/node_derivatives.hpp"

namespace hilger {

/// p = dL/dv(q, v): the member momentum(q, v) of L if it has one, else by jets.
template <class L, class V>
V momentum_of(L const& lagrangian, V const& q, V const& v) {
    if constexpr (requires { lagrangian.momentum(q, v); })
        return lagrangian.momentum(q, v);
    else
        return gradient_second(lagrangian, q, v);
}

namespace detail {
inline constexpr char const* legendre_map = "the Legendre map v -> dL/dv";
/// dL/dv(q, v) - p and its derivative by v in its sparsity pattern: `each(use)` calls use(row, column, entry) for nonzero entries.
template <class V, class Each>
newton_system<V, patterned_matrix<scalar_of<V>, shape<V>::size>> momentum_equation(V residual, Each const& each) {
    newton_system<V, patterned_matrix<scalar_of<V>, shape<V>::size>> made{std::move(residual), {}};
    std::vector<std::pair<int, int>> pattern;
    each([&](int row, int column, auto const&) { pattern.emplace_back(row, column); });
    made.jacobian.prepare(shape<V>::dimension(made.residual), pattern);
    each([&](int row, int column, auto const& x) { made.jacobian[made.jacobian.place(row, column)] = x; });
    return made;
}
/// The v with dL/dv(q, v) = p: the member velocity(q, p) of L if it has one, else found from the equation by `find`.
template <class L, class V, class Find>
V velocity_found(L const& lagrangian, V const& q, V const& p, Find const& find) {
    if constexpr (requires { lagrangian.velocity(q, p); })
        return lagrangian.velocity(q, p);
    else if constexpr (is_traced_state<V> and not requires { lagrangian.expand(q, q); })
        return find([&](V const& v) {
            auto const there = trace_there(lagrangian, q, v, on_velocity);
            return momentum_equation(V(there.by_v - p), [&](auto const& use) { there.for_each_in(block_vv, use); });
        });
    else
        return find([&](V const& v) {
            auto d = expand(lagrangian, q, v);
            return newton_system<V>{V(d.by_v - p), std::move(d.vv)};
        });
}
} // namespace detail

/// The v with dL/dv(q, v) = p: the member velocity(q, p) of L if it has one, else by Newton from `guess`. @throws error::singular if
/// d2L/dv2 is singular, error::no_convergence
template <class L, class V>
V velocity_of(L const& lagrangian, V const& q, V const& p, V const& guess) {
    return detail::velocity_found(lagrangian, q, p, [&](auto const& equation) { return newton(equation, guess, p, detail::legendre_map); });
}
/// The same from v = 0, and if that fails from v = p and v = 1. If several velocities have the momentum p, as with L = v^4 - v^2, it is one
/// of them.
template <class L, class V>
V velocity_of(L const& lagrangian, V const& q, V const& p) {
    return detail::velocity_found(lagrangian, q, p,
                                  [&](auto const& equation) { return newton_near(equation, zero_like(p), p, detail::legendre_map); });
}
namespace detail {
/// The same at time t with kept derivatives, from the velocity `near`: 0 if nothing is known of it.
template <class Problem, class S, class V>
V velocity_by(kept_derivatives<Problem> const& kept, S const& t, V const& q, V const& p, V const& near) {
    at_time const lagrangian{kept.what().lagrangian, t};
    auto const find = [&](auto const& equation) { return newton_near(equation, near, p, legendre_map); };
    if constexpr (not is_traced_at<Problem, V> or requires { lagrangian.velocity(q, p); })
        return velocity_found(lagrangian, q, p, find);
    else
        return find([&](V const& v) {
            return kept.at(t, q, v, wanted::with_seconds, [&](auto const& node) {
                V residual = p;
                for (int k = 0; k < shape<V>::dimension(p); ++k)
                    shape<V>::component(residual, k) = node.by_v(k) - shape<V>::component(p, k);
                return momentum_equation(std::move(residual), [&](auto const& use) {
                    for (auto const& e : node.places().entries[block_vv]) use(e.row, e.column, node.value(e.place));
                });
            });
        });
}
/// p.v - L(q, v)
template <class L, class V>
scalar_of<V> energy_of(L const& lagrangian, V const& q, V const& v, V const& p) {
    return scalar_of<V>(dot_product(p, v) - number_from(lagrangian, q, v));
}
} // namespace detail

/// The Hamiltonian H(p, q) = p.v - L(q, v) with v from the inverse Legendre map, and its derivatives.
template <class L>
class hamiltonian {
public:
    constexpr explicit hamiltonian(L lagrangian) : lagrangian_(std::move(lagrangian)) {}

    /// The energy, a scalar. @throws error::singular, error::no_convergence
    template <class V>
    scalar_of<V> operator()(V const& p, V const& q) const {
        return detail::energy_of(lagrangian_, q, velocity_of(lagrangian_, q, p), p);
    }
    /// dH/dp = v and dH/dq = -dL/dq, states like q. @throws as the energy
    template <class V>
    V by_momentum(V const& p, V const& q) const {
        return velocity_of(lagrangian_, q, p);
    }
    template <class V>
    V by_position(V const& p, V const& q) const {
        return -gradient_first(lagrangian_, q, velocity_of(lagrangian_, q, p));
    }

private:
    [[no_unique_address]] L lagrangian_;
};

} // namespace hilger
