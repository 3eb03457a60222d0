// SPDX-License-Identifier: BSL-1.0
// H(p, q) = A(p) + B(q) with its parts: compositions of order-one steps and their adjoints, as Stoermer-Verlet, are kicks p - w dB/dq and
// drifts q + w dA/dp, explicit for every A.
//   stoermer_verlet(lagrangian_of(separated{A, B})).along(T, q0, p0)
// Of H = K(p) + U(q), U < 0, the logarithmic Hamiltonian
//   log(K(p) + p_t) - log(-U(q)),   with t as a coordinate and its momentum p_t = -E,
// is 0 along motions of energy E, and there it has Hamilton's equations in the time tau with dt = -dtau / U (Preto and Tremaine 1999,
// Mikkola and Tanikawa 1999). position_verlet follows the orbits of Kepler's problem to rounding; only the time has its error.
#pragma once

#include <Eigen/LU>

#include "hilger/models/mechanical.hpp"
#include "hilger/variational/legendre_transform.hpp"

namespace hilger {

/// H(p, q) = A(p) + B(q)
template <class A, class B>
struct separated {
    [[no_unique_address]] A of_momentum;
    [[no_unique_address]] B of_position;

    constexpr separated(A a, B b) : of_momentum(std::move(a)), of_position(std::move(b)) {}
    template <class P, class Q>
    constexpr auto operator()(P const& p, Q const& q) const {
        return evaluated(of_momentum(p)) + evaluated(of_position(q));
    }
};

namespace detail {
/// All components but the last.
template <class X>
constexpr auto without_last(X const& x) {
    constexpr int size = plain_t<X>::SizeAtCompileTime, rest = size == Eigen::Dynamic ? size : size - 1;
    return evaluated(x.template head<rest>(x.size() - 1));
}
/// p.M^-1 p / 2
template <class Mass>
struct kinetic_of_momentum {
    static constexpr bool is_matrix = requires { requires Mass::ColsAtCompileTime != 1; };
    Mass inverse;
    explicit kinetic_of_momentum(Mass const& mass) : inverse(inverse_of(mass)) {}
    template <class P>
    auto operator()(P const& p) const {
        if constexpr (is_matrix)
            return evaluated(p.dot(inverse * p) / 2);
        else if constexpr (requires { inverse.size(); })
            return evaluated(p.dot(inverse.cwiseProduct(p)) / 2);
        else
            return evaluated(p.dot(p) * inverse / 2);
    }

private:
    static Mass inverse_of(Mass const& mass) {
        if constexpr (is_matrix)
            return mass.inverse();
        else if constexpr (requires { mass.size(); })
            return mass.cwiseInverse();
        else
            return Mass(1) / mass;
    }
};
} // namespace detail

/// log(K(p) + p_t) of (p, p_t)
template <class Kinetic>
struct logarithm_of_kinetic {
    [[no_unique_address]] Kinetic kinetic;
    template <class P>
    constexpr auto operator()(P const& p) const {
        using std::log;
        return log(kinetic(detail::without_last(p)) + p(p.size() - 1));
    }
};
/// -log(-U(q)) of (q, t)
template <class Potential>
struct logarithm_of_potential {
    [[no_unique_address]] Potential potential;
    template <class Q>
    constexpr auto operator()(Q const& q) const {
        using std::log;
        return -log(-potential(detail::without_last(q)));
    }
};
/// The logarithmic Hamiltonian of K(p) and U(q) < 0, callables of vectors: states are (q, t), momenta (p, -E), E = K(p0) + U(q0).
template <class Kinetic, class Potential>
constexpr auto logarithmic(Kinetic kinetic, Potential potential) {
    return separated(logarithm_of_kinetic<Kinetic>{std::move(kinetic)}, logarithm_of_potential<Potential>{std::move(potential)});
}
/// The same of L = v.Mv/2 - U(q): logarithmic(mechanical{mass, U}).
template <class Mass, class Potential>
auto logarithmic(mechanical<Mass, Potential> const& L) {
    return logarithmic(detail::kinetic_of_momentum<Mass>(L.mass()), L.potential());
}

} // namespace hilger
