// SPDX-License-Identifier: BSL-1.0
// A scale that follows the motion, by Poincare's transformation dt = g(q) dtau, g > 0. With q' = dq/dtau
//   L~(q, q') = g(q) (L(q, q'/g(q)) + E)
// is a Lagrangian with the momentum p = dL/dv of L and the Hamiltonian g(q) (H(q, p) - E). Along motions of energy E that is 0, and its
// equations are those of L in the new time. So T is uniform in tau, every embedding and composition of L~ is variational, and the times t
// of the points of T are the integral of g, part of the solution (integrator/times.hpp).
//   embed(transform_time(L, sundman(1), E), mid_point).along(T, q0, p0)          E = hamiltonian(L)(p0, q0)
// A Lagrangian L(t, q, v), and one with a force, has no constant E. There t and the energy e are coordinates, x = (q, t, e), and
//   L^(x, x') = g(q) (L(t, q, q'/g(q)) + e) - e t'
// has the equations t' = g, e' = -g dL/dt beside those of q: its Hamiltonian is g(q) (H(t, q, p) - e).
//   embed(transform_time(L, g), mid_point).along(T, (q0, t0, E), (p0, -E, 0))
#pragma once

#include <utility>

#include "hilger/inlining.hpp"
#include "hilger/variational/lagrangian.hpp"
#include "hilger/variational/legendre.hpp"
#include "hilger/variational/legendre_transform.hpp"
#include "hilger/variational/problem.hpp"
#include "hilger/variational/rates_of_time.hpp"

namespace hilger {

namespace detail {
/// g(q) of a state, a number.
template <class G, class V>
scalar_of<V> rate_at(G const& rate, V const& q) {
    return as_jet<jet<scalar_of<V>, 0, 1, 1>>(value_from(rate, in_constants(q))).value;
}
/// v = w / g; in registers where w is.
template <class W, class R>
HILGER_ALWAYS_INLINE constexpr auto velocity_in_time(W const& w, R const& g) {
    return evaluated(w / g);
}
template <class J, int N, class R>
HILGER_ALWAYS_INLINE constexpr auto velocity_in_time(jet_vector<J, N> const& w, R const& g) {
    jet_vector<std::remove_cvref_t<decltype(w(0) / g)>, N> v;
    [&]<int... K>(std::integer_sequence<int, K...>) HILGER_ALWAYS_INLINE { ((v(K) = w(K) / g), ...); }
    (std::make_integer_sequence<int, N>{});
    return v;
}
} // namespace detail

/// g(q) (L(q, q'/g(q)) + E), with the Legendre map of L where L has one of its own.
template <class L, class G, class S>
struct transformed_in_time {
    [[no_unique_address]] L lagrangian;
    [[no_unique_address]] G rate; ///< g
    S energy;

    template <class Q, class W>
    requires std::invocable<L const&, Q const&, Q const&> HILGER_ALWAYS_INLINE constexpr auto operator()(Q const& q, W const& w) const {
        auto const g = evaluated(rate(q));
        return evaluated(g * (evaluated(lagrangian(q, detail::velocity_in_time(w, g))) + energy));
    }
    template <class V>
        requires requires(L const& l, V const& x) { l.momentum(x, x); }
    [[nodiscard]] V momentum(V const& q, V const& w) const { return lagrangian.momentum(q, V(w / detail::rate_at(rate, q))); }
    template <class V>
        requires requires(L const& l, V const& x) { l.velocity(x, x); }
    [[nodiscard]] V velocity(V const& q, V const& p) const { return V(lagrangian.velocity(q, p) * detail::rate_at(rate, q)); }
};

/// g(q) (H(p, q) - E)
template <class H, class G, class S>
struct hamiltonian_in_time {
    [[no_unique_address]] H hamiltonian;
    [[no_unique_address]] G rate;
    S energy;
    template <class P, class Q>
    constexpr auto operator()(P const& p, Q const& q) const {
        return evaluated(evaluated(rate(q)) * (evaluated(hamiltonian(p, q)) - energy));
    }
};
/// The same Lagrangian where L is given by its Hamiltonian.
template <class H, class G, class S>
struct transformed_in_time<legendre_transform<H>, G, S> : legendre_transform<hamiltonian_in_time<H, G, S>> {
    transformed_in_time(legendre_transform<H> const& of, G g, S const& energy)
        : legendre_transform<hamiltonian_in_time<H, G, S>>({of.given(), g, energy}), rate(std::move(g)) {}
    [[no_unique_address]] G rate;
};

/// L in the time tau with dt = g(q) dtau, for motions of energy E = hamiltonian(L)(p0, q0). g(q) > 0 is a callable of q, by name or any
/// other (variational/rates_of_time.hpp). With g = 1 the steps are those of L, to the bit.
template <class L, class G, class S>
constexpr auto transform_time(L const& l, G rate, S const& energy) {
    constexpr bool has_force = requires { detail::is_problem(l); };
    static_assert(not has_force,
                  "a force changes the energy, and here it is constant: transform_time(with_force(L, f), g) has the time and "
                  "the energy as coordinates");
    if constexpr (has_force)
        return l;
    else if constexpr (requires { l.function; })
        return transform_time(l.function, std::move(rate), energy);
    else
        return transformed_in_time<L, G, S>{l, std::move(rate), energy};
}

namespace detail {
/// q in x = (q, t, e).
template <class X>
constexpr auto without_time(X const& x) {
    constexpr int size = plain_t<X>::SizeAtCompileTime, d = size == Eigen::Dynamic ? Eigen::Dynamic : size - 2;
    static_assert(size == Eigen::Dynamic or size > 2,
                  "a state with its time and energy, (q, t, e), is a vector of three or more components");
    return evaluated(x.template head<d>(x.size() - 2));
}
/// (q, t, e)
template <class X, class Q, class S>
X with_time(X const& like, Q const& q, S const& t, S const& e) {
    X x = like;
    x.head(q.size()) = q;
    x(q.size()) = t;
    x(q.size() + 1) = e;
    return x;
}
} // namespace detail

/// g(q) (L(t, q, q'/g(q)) + e) - e t' of x = (q, t, e). q is a vector, also of one component. d2L^/dv2 is singular: mid_point, galerkin<s,
/// gauss> and their compositions step it, as Gauss' Runge-Kutta methods.
template <class L, class G>
struct transformed_with_time {
    [[no_unique_address]] L lagrangian;
    [[no_unique_address]] G rate;

    template <class X, class Y>
        requires requires(X const& x) { x(0); }
    constexpr auto operator()(X const& x, Y const& y) const {
        auto const q = detail::without_time(x);
        auto const g = evaluated(rate(q));
        auto const t = x(q.size()), e = x(q.size() + 1);
        auto const v = evaluated(detail::without_time(y) / g);
        return evaluated(g * (detail::at_time{lagrangian, t}(q, v) + e) - e * y(q.size()));
    }
    /// (dL/dv, -e, 0)
    template <class V>
    [[nodiscard]] V momentum(V const& x, V const& w) const {
        auto const q = detail::without_time(x);
        auto const v = evaluated(detail::without_time(w) / detail::rate_at(rate, q));
        using S = scalar_of<V>;
        S const t = x(q.size()), e = x(q.size() + 1);
        return detail::with_time(x, momentum_of(detail::at_time{lagrangian, t}, q, v), S(-e), S(0));
    }
    /// (q', g, 0): L^ does not depend on e'.
    template <class V>
    [[nodiscard]] V velocity(V const& x, V const& p) const {
        auto const q = detail::without_time(x);
        using S = scalar_of<V>;
        S const t = x(q.size()), g = detail::rate_at(rate, q);
        auto const v = velocity_of(detail::at_time{lagrangian, t}, q, detail::without_time(p));
        return detail::with_time(x, evaluated(v * g), g, S(0));
    }
};
/// The force g f(t, q, q'/g) beside dL/dq, and its power, by which e' = g f.v - g dL/dt.
template <class Force, class G>
struct force_with_time {
    [[no_unique_address]] Force force;
    [[no_unique_address]] G rate;

    template <class X, class Y>
    constexpr auto operator()(X const& x, Y const& y) const {
        auto const q = detail::without_time(x);
        auto const w = detail::without_time(y);
        auto const g = evaluated(rate(q));
        auto const t = x(q.size());
        auto const f = evaluated(detail::at_time{force, t}(q, evaluated(w / g)));
        using J = plain_t<decltype(g * f(0) * w(0))>;
        typename detail::shape<plain_t<X>>::template with<J> all = plain_t<decltype(all)>::Zero(x.size());
        J power(0);
        for (index_type k = 0; k < q.size(); ++k) {
            all(k) = J(g * f(k));
            power = J(power - f(k) * w(k));
        }
        all(q.size()) = power;
        return all;
    }
};

/// L, or L with a force, in the time tau with dt = g(q) dtau and with t and the energy e as coordinates: states are (q, t, e), momenta (p,
/// -e, 0). L(t, q, v) and f(t, q, v) take a time of any number type.
template <class L, class G>
constexpr auto transform_time(L const& l, G rate) {
    static_assert(
        not requires { L::has_derivatives_alone; },
        "the time and the energy are coordinates of a Lagrangian that is a formula, and that of a Hamiltonian is none: "
        "transform_time(lagrangian_of(H), g, E) has neither");
    if constexpr (requires { detail::is_problem(l); }) {
        using Force = std::remove_cvref_t<decltype(l.force)>;
        return with_force(transform_time(l.lagrangian, rate), force_with_time<Force, G>{l.force, rate});
    } else if constexpr (requires { l.function; })
        return transform_time(l.function, std::move(rate));
    else
        return transformed_with_time<L, G>{l, std::move(rate)};
}

} // namespace hilger
