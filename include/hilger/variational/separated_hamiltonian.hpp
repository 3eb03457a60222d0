// SPDX-License-Identifier: BSL-1.0
// H(p, q) = A(p) + B(q) with its parts: compositions of order-one steps and their adjoints, as Stoermer-Verlet, are kicks p - w dB/dq and
// drifts q + w dA/dp, explicit for every A.
//   stoermer_verlet(lagrangian_of(separated{A, B})).along(T, q0, p0)
// Of H = K(p) + U(q), U < 0, the logarithmic Hamiltonian
//   log(K(p) + p_t) - log(-U(q)),   with t as a coordinate and its momentum p_t = -E,
// is 0 along motions of energy E, and there it has Hamilton's equations in the time tau with dt = -dtau / U (Preto and Tremaine 1999,
// Mikkola and Tanikawa 1999). position_verlet follows the orbits of Kepler's problem to rounding; only the time has its error.
#pragma once

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
    constexpr int size = plain_t<X>::SizeAtCompileTime;
    return evaluated(x.template head < size == Eigen::Dynamic ? size : size - 1 > (x.size() - 1));
}
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

} // namespace hilger
