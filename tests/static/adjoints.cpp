// SPDX-License-Identifier: BSL-1.0
// Integration by parts as statements about types: the adjoint of every operator, and that taking it twice gives the operator back.
#include "hilger/calculus.hpp"

using namespace hilger;

namespace {

// Shifts and derivatives, on T, T_half and T_o: whatever the steps are (Cresson-Safi (9), and section 1 of S for T_o).
static_assert(adjoint(Delta_plus) == -Delta_minus and adjoint(Delta_minus) == -Delta_plus);
static_assert(adjoint(Delta_h_plus) == -Delta_h_minus and adjoint(Delta_h_minus) == -Delta_h_plus);
static_assert(adjoint(Delta_o_plus) == -Delta_o_minus and adjoint(Delta_o_minus) == -Delta_o_plus);
static_assert(adjoint(sigma) == rho and adjoint(rho) == sigma);
static_assert(adjoint(sigma_h) == rho_h and adjoint(rho_h) == sigma_h);
static_assert(adjoint(sigma_o) == rho_o and adjoint(rho_o) == sigma_o);
static_assert(adjoint(identity_T) == identity_T and adjoint(identity_h) == identity_h and adjoint(identity_o) == identity_o);

// Multiples, sums and compositions: (c A)* = c A*, (A + B)* = A* + B*, (A B)* = B* A*.
static_assert(adjoint(-sigma) == -rho and adjoint(fraction<2, 3>{} * Delta_plus) == fraction<-2, 3>{} * Delta_minus);
static_assert(adjoint(sigma + Delta_plus) == rho - Delta_minus);
// The discrete Laplacian is self-adjoint; Delta_plus Delta_minus is the same on uniform scales only.
static_assert(adjoint(Delta_minus * Delta_plus) == Delta_minus * Delta_plus);
static_assert(adjoint(Delta_minus * Delta_plus) != Delta_plus * Delta_minus);
static_assert(uniformly(adjoint(Delta_minus * Delta_plus)) == Delta_plus * Delta_minus);
static_assert(adjoint(rho * sigma) == rho * sigma and adjoint(rho * Delta_plus) == -Delta_minus * sigma);

// Between the two sums of a composition the weights may change, and the adjoint says where: Delta_plus ends in the Delta sum and starts in
// the nabla sum, so between two of them stands nu -> mu.
static_assert(adjoint(Delta_plus * Delta_plus) == Delta_minus * reweight<nodes, nabla_weight, delta_weight>{} * Delta_minus);
static_assert(uniformly(adjoint(Delta_plus * Delta_plus)) ==
              uniformly(Delta_minus * reweight<nodes, nabla_weight, delta_weight>{} * Delta_minus));
static_assert(adjoint(Delta_plus * Delta_plus) != Delta_minus * Delta_minus);

// The extension and the means. Lemma 3 of Cresson-Safi is a statement about uniform scales; on any scale the adjoint is step_mean.
static_assert(adjoint(on_half * extend) == step_mean and adjoint(step_mean) == on_half * extend);
static_assert(uniformly(adjoint(on_half * extend)) == pi_half * mean_h_minus);
static_assert(adjoint(on_half * extend) != pi_half * mean_h_minus);
static_assert(uniformly(adjoint(on_half * sigma_o * extend)) != adjoint(on_half * extend)); // sigma_o is not the identity
static_assert(adjoint(extend) == fraction<1, 2>{} * (on_T + step_mean * on_half));
static_assert(adjoint(on_T * extend) == pi_half * pi_inverse * rho * sigma); // the identity, on the inner points

// What puts values on T_half back on T, and the integral with its tail.
static_assert(adjoint(pi_half) == pi_inverse and adjoint(pi_inverse) == pi_half);
static_assert(adjoint(antiderivative_h) == tail_integral_at<fraction<1, 2>>{} and
              adjoint(tail_integral_at<fraction<1, 2>>{}) == antiderivative_h);

// The velocity of the mid-point embedding, and its adjoint: the difference of neighbouring mid-points.
static_assert(uniformly(adjoint(on_half * Delta_o_plus * extend)) == -(pi_half * Delta_h_minus));
static_assert(adjoint(pi_inverse * Delta_plus) == -(Delta_minus * pi_half));
static_assert(adjoint(pi_inverse * Delta_plus) != -(pi_half * Delta_h_minus)); // on any scale nu is the step of T, not that of T_half

// A** = A: for the operators themselves,
template <class... As>
constexpr bool adjoint_is_an_involution(As const&... a) {
    return ((adjoint(adjoint(a)) == a) and ...);
}
static_assert(adjoint_is_an_involution(sigma, rho, sigma_h, rho_h, sigma_o, rho_o));
static_assert(adjoint_is_an_involution(Delta_plus, Delta_minus, Delta_h_plus, Delta_h_minus, Delta_o_plus, Delta_o_minus));
static_assert(adjoint_is_an_involution(identity_T, identity_h, identity_o, extend, on_T, on_half, pi_half, pi_inverse, step_mean));
static_assert(adjoint_is_an_involution(mean_h_minus, mean_h_plus, mean_o, antiderivative_h, antiderivative, antiderivative_nabla));
static_assert(adjoint_is_an_involution(insertion<fraction<1, 2>, true>{}, insertion<fraction<1, 2>, false>{},
                                       reweight<nodes, delta_weight, nabla_weight>{}));
// for what is made of them, composed by brackets,
static_assert(adjoint_is_an_involution(-Delta_plus, fraction<2, 7>{} * sigma, sigma + Delta_plus, Delta_minus - rho, pi_half[pi_inverse]));
static_assert(adjoint_is_an_involution(Delta_minus[Delta_plus], Delta_plus[Delta_minus], rho[sigma], sigma[rho], Delta_plus[rho]));
static_assert(adjoint_is_an_involution(on_half[extend], on_half[Delta_o_plus[extend]], on_T[Delta_o_minus[extend]], mean_o[extend]));
static_assert(adjoint_is_an_involution(pi_half[mean_h_minus[on_half[extend]]], Delta_plus[step_mean],
                                       pi_inverse[Delta_plus[antiderivative_h]]));
// and where the weights change on the way.
static_assert(adjoint_is_an_involution(Delta_plus[Delta_plus], sigma[sigma], Delta_plus[Delta_plus[Delta_plus]], sigma[Delta_plus[rho]]));
static_assert(adjoint_is_an_involution(sigma_o[extend], Delta_o_plus[Delta_o_plus[extend]], extend[Delta_plus], sigma + identity_T));

} // namespace
