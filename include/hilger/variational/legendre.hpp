// SPDX-License-Identifier: BSL-1.0
// The Legendre map v -> p = dL/dv(q, v), its inverse, and the Hamiltonian H(p, q) = p.v - L(q, v) (Cresson-Safi (79), (81), (93)).
#pragma once

#include "hilger/differentiation/derivatives.hpp"
#include "hilger/newton/newton.hpp"

namespace hilger {

/// p = dL/dv(q, v): the member momentum(q, v) of an L that has one, else by jets.
template <class L, class V>
V momentum_of(L const& lagrangian, V const& q, V const& v) {
    if constexpr (requires { lagrangian.momentum(q, v); })
        return lagrangian.momentum(q, v);
    else
        return gradient_second(lagrangian, q, v);
}

namespace detail {
/// v -> dL/dv(q, v) - p and its derivative in the pattern that it has, of states of any size.
template <class L, class V>
newton_system<V, patterned_matrix<scalar_of<V>>> momentum_equation(L const& lagrangian, V const& q, V const& v, V const& p) {
    auto const there = trace_there(lagrangian, q, v, on_velocity);
    newton_system<V, patterned_matrix<scalar_of<V>>> made{V(there.by_v - p), {}};
    std::vector<std::pair<int, int>> pattern;
    there.for_each_in(block_vv, [&](int row, int column, auto const&) { pattern.emplace_back(row, column); });
    made.jacobian.prepare(shape<V>::dimension(q), pattern);
    there.for_each_in(block_vv, [&](int row, int column, auto const& x) { made.jacobian[made.jacobian.place(row, column)] = x; });
    return made;
}
} // namespace detail

/// The v with dL/dv(q, v) = p: the member velocity(q, p) of an L that has one, else by Newton from `guess`.
/// @throws error::singular when d2L/dv2 is singular, error::no_convergence.
template <class L, class V>
V velocity_of(L const& lagrangian, V const& q, V const& p, V const& guess) {
    if constexpr (requires { lagrangian.velocity(q, p); })
        return lagrangian.velocity(q, p);
    else {
        constexpr char const* name = "the Legendre map v -> dL/dv";
        if constexpr (detail::is_traced_state<V> and not requires { lagrangian.expand(q, q); })
            return newton([&](V const& v) { return detail::momentum_equation(lagrangian, q, v, p); }, guess, p, name);
        else {
            auto const equation = [&](V const& v) {
                auto d = expand_second(lagrangian, q, v);
                return newton_system<V>{V(d.by_v - p), std::move(d.vv)};
            };
            return newton(equation, guess, p, name);
        }
    }
}
/// From v = 0; or, where there is no mass at rest, as in L = v^4, from v = p.
template <class L, class V>
V velocity_of(L const& lagrangian, V const& q, V const& p) {
    try {
        return velocity_of(lagrangian, q, p, zero_like(q));
    } catch (error::singular const&) {
        if (magnitude(p) == scalar_of<V>(0)) throw;
    }
    return velocity_of(lagrangian, q, p, p);
}

/// H(p, q) = p.v - L(q, v) with v from the inverse Legendre map; also its derivatives dH/dp = v and dH/dq = -dL/dq.
template <class L>
class hamiltonian {
public:
    constexpr explicit hamiltonian(L lagrangian) : lagrangian_(std::move(lagrangian)) {}

    /// The energy, a scalar. @throws error::singular, error::no_convergence
    template <class V>
    scalar_of<V> operator()(V const& p, V const& q) const {
        V const v = velocity_of(lagrangian_, q, p);
        return scalar_of<V>(dot_product(p, v) - detail::number_from(lagrangian_, q, v));
    }
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
