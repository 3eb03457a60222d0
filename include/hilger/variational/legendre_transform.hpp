// SPDX-License-Identifier: BSL-1.0
// The Lagrangian of a given Hamiltonian H(p, q) or H(t, p, q): L(q, v) = p.v - H(p, q) with p from dH/dp(p, q) = v (Cresson-Safi (93), read
// backwards). Its derivatives come from those of H by the rules of the Legendre transform, so nothing is differentiated through an
// iteration:
//   dL/dq = -dH/dq,  dL/dv = p,  L_vv = H_pp^-1,  L_qv = -H_qp H_pp^-1,  L_qq = H_qp H_pp^-1 H_pq - H_qq.
#pragma once

#include <Eigen/LU>

#include "hilger/newton/system.hpp"
#include "hilger/variational/problem.hpp"

namespace hilger {

namespace detail {
// Called with the numbers that carry derivatives: max(q, 0.0) of plain numbers would need std:: before it.
template <class H, class V>
concept is_hamiltonian = requires(H const& h, typename jets_for<V>::position const& p, typename jets_for<V>::velocity const& q) {
    h(p, q);
};
template <class H, class S, class V>
concept is_hamiltonian_of_time = requires(H const& h, S const& t, typename jets_for<V>::position const& p,
                                          typename jets_for<V>::velocity const& q) {
    h(t, p, q);
};
} // namespace detail

/// The Lagrangian of a Hamiltonian H(p, q) or H(t, p, q), with its Legendre map and its derivatives.
template <class H>
class legendre_transform {
public:
    static constexpr bool has_derivatives_alone = true; ///< no formula that jets pass through
    constexpr explicit legendre_transform(H h) : hamiltonian_(std::move(h)) {}
    /// H
    [[nodiscard]] constexpr H const& given() const { return hamiltonian_; }

    // Each of (q, v), or of (t, q, v) if H depends on the time.
#define HILGER_OF_HAMILTONIAN(type, member, what_is_asked)                                                                                 \
    template <class V>                                                                                                                     \
        requires detail::is_hamiltonian<H, V>                                                                                              \
    [[nodiscard]] type member(V const& x, V const& y) const { return what_is_asked(hamiltonian_, x, y); }                                  \
    template <class S, class V>                                                                                                            \
        requires detail::is_hamiltonian_of_time<H, S, V>                                                                                   \
    [[nodiscard]] type member(S const& t, V const& x, V const& y) const { return what_is_asked(detail::at_time{hamiltonian_, t}, x, y); }
    /// p with dH/dp(p, q) = v, of (q, v). @throws error::singular if d2H/dp2 is singular, error::no_convergence
    HILGER_OF_HAMILTONIAN(V, momentum, momentum_for)
    /// v = dH/dp(p, q), of (q, p).
    HILGER_OF_HAMILTONIAN(V, velocity, velocity_for)
    /// L(q, v), a number.
    HILGER_OF_HAMILTONIAN(scalar_of<V>, operator(), value_of)
    HILGER_OF_HAMILTONIAN(expansion<V>, expand, expand_with)
#undef HILGER_OF_HAMILTONIAN

private:
    template <class F, class V>
    static V momentum_for(F const& h, V const& q, V const& v) {
        auto const equation = [&](V const& p) {
            auto const e = hilger::expand(h, p, q);
            return newton_system<V>{V(e.by_q - v), e.qq};
        };
        return newton_near(equation, zero_like(v), v, "the Legendre map p -> dH/dp");
    }
    template <class F, class V>
    static V velocity_for(F const& h, V const& q, V const& p) {
        return gradient_first(h, p, q);
    }
    template <class F, class V>
    static scalar_of<V> value_of(F const& h, V const& q, V const& v) {
        V const p = momentum_for(h, q, v);
        return scalar_of<V>(dot_product(p, v) - detail::number_from(h, p, q));
    }
    /// NaN if no momentum has this velocity, as beyond that of light: L is not defined there, and steps avoid such points.
    template <class F, class V>
    static V momentum_or_nan(F const& h, V const& q, V const& v) {
        if constexpr (std::numeric_limits<scalar_of<V>>::is_exact)
            return momentum_for(h, q, v);
        else
            try {
                return momentum_for(h, q, v);
            } catch (error::no_convergence const&) {
                return V(v * std::numeric_limits<scalar_of<V>>::quiet_NaN());
            }
    }
    template <class F, class V>
    static expansion<V> expand_with(F const& h, V const& q, V const& v) {
        using s = detail::shape<V>;
        V const p = momentum_or_nan(h, q, v);
        auto const e = hilger::expand(h, p, q); // by_q, qq: by p; qv: by p, then q; by_v, vv: by q
        expansion<V> l;
        l.by_q = -e.by_v;
        l.by_v = p;
        if constexpr (s::is_scalar) {
            l.vv = scalar_of<V>(1) / e.qq;
            l.qv = -e.qv * l.vv;
            l.qq = e.qv * e.qv * l.vv - e.vv;
        } else {
            l.vv = e.qq.inverse();
            l.qv = -e.qv.transpose() * l.vv;
            l.qq = -l.qv * e.qv - e.vv;
        }
        bool const quadratic = not e.on.coupled and e.on.q <= 2;
        l.on = quadratic ? dependence{e.on.v, 2, false} : dependence{dependence::no_polynomial, dependence::no_polynomial, true};
        return l;
    }
    [[no_unique_address]] H hamiltonian_;
};

/// H(p, q) as a Lagrangian, to be embedded like any other: embed(lagrangian_of(H), mid_point).
template <class H>
constexpr auto lagrangian_of(H h) {
    return legendre_transform<H>(std::move(h));
}

} // namespace hilger
