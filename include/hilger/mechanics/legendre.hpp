// SPDX-License-Identifier: BSL-1.0
// The Legendre map v -> p = dL/dv(q, v), its inverse, and the Hamiltonian H(p, q) = p.v - L(q, v) (Cresson-Safi (79), (81), (93)).
#pragma once

#include "hilger/mechanics/derivatives.hpp"
#include "hilger/mechanics/newton.hpp"

namespace hilger {

/// p = dL/dv(q, v): the member momentum(q, v) of an L that has one, else by jets.
template <class L, class V>
V momentum_of(L const& lagrangian, V const& q, V const& v) {
    if constexpr (requires { lagrangian.momentum(q, v); })
        return lagrangian.momentum(q, v);
    else
        return gradient_second(lagrangian, q, v);
}

/// The v with dL/dv(q, v) = p: the member velocity(q, p) of an L that has one, else by Newton from `guess`.
/// @throws error::singular when d2L/dv2 is singular, error::no_convergence.
template <class L, class V>
V velocity_of(L const& lagrangian, V const& q, V const& p, V const& guess) {
    if constexpr (requires { lagrangian.velocity(q, p); })
        return lagrangian.velocity(q, p);
    else {
        auto const equation = [&](V const& v) {
            auto d = expand_second(lagrangian, q, v);
            return newton_system<V>{V(d.by_v - p), std::move(d.vv)};
        };
        return newton(equation, guess, p, "the Legendre map v -> dL/dv");
    }
}
template <class L, class V>
V velocity_of(L const& lagrangian, V const& q, V const& p) {
    return velocity_of(lagrangian, q, p, zero_like(q));
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
