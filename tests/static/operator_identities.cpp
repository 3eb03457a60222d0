// SPDX-License-Identifier: BSL-1.0
// Identities between operators that hold on every scale, and those that hold on uniform ones only.
#include "hilger/calculus.hpp"

using namespace hilger;

namespace {

// sigma and rho are inverse to each other where both shifts exist: sigma rho lives on T^+, rho sigma on T^-, so neither is the
// identity of T. The identity of T^+ is what is left of a function after T_half and back.
static_assert(sigma * rho == pi_half * pi_inverse and sigma * rho != identity_T and rho * sigma != identity_T);
static_assert(sigma * rho != rho * sigma);                             // they live on different points,
static_assert(sigma * rho * rho * sigma == rho * sigma * sigma * rho); // and agree where both live
static_assert(pi_inverse * pi_half == identity_h and pi_inverse * sigma * rho == pi_inverse);
static_assert(sigma * rho * sigma == sigma and rho * sigma * rho == rho and rho * rho * sigma * sigma != rho * sigma);

// Delta_plus at rho(t) is Delta_minus at t, on every scale.
static_assert(rho * Delta_plus == Delta_minus and sigma * Delta_minus == Delta_plus);
static_assert(rho_h * Delta_h_plus == Delta_h_minus and sigma_o * Delta_o_minus == Delta_o_plus);
// In the other order the step is that of the wrong point, which a uniform scale forgives.
static_assert(Delta_minus * sigma != Delta_plus and uniformly(Delta_minus * sigma) != Delta_plus);
static_assert(Delta_minus * sigma != Delta_plus * rho * sigma and uniformly(Delta_minus * sigma) == Delta_plus * rho * sigma);
static_assert(Delta_plus * rho != rho * Delta_plus and uniformly(Delta_plus * rho) == Delta_minus * sigma * rho);
static_assert(Delta_plus * sigma != sigma * Delta_plus and uniformly(Delta_plus * sigma) == sigma * Delta_plus);
static_assert(Delta_plus * Delta_minus != Delta_minus * Delta_plus and uniformly(Delta_plus * Delta_minus) == Delta_minus * Delta_plus);

// Lemma 1 of Cresson-Safi: the derivative on T_o of the extension is the derivative on T, at both kinds of points.
static_assert(on_half * Delta_o_plus * extend == pi_inverse * Delta_plus);
static_assert(on_T * Delta_o_plus * extend == Delta_plus and on_T * Delta_o_minus * extend == Delta_minus);
static_assert(on_half * Delta_o_minus * extend == pi_inverse * Delta_plus);
static_assert(on_T * extend == identity_T and on_T * sigma_o * extend == fraction<1, 2>{} * (sigma * rho + sigma));

// The means (25), (26): mean_o at t_i is the mean of the two neighbouring mid-points.
static_assert(mean_o == pi_half * mean_h_minus * on_half and mean_o != step_mean * on_half);
static_assert(uniformly(mean_o) == step_mean * on_half and uniformly(step_mean) == pi_half * mean_h_minus and
              step_mean != pi_half * mean_h_minus);
// step_mean is the mean of the two with the steps as weights, (mu g + nu g^rho) / (mu + nu).
using mean = mean_weight<fraction<1, 2>>;
static_assert(step_mean ==
              fraction<1, 2>{} * (reweight<nodes, delta_weight, mean>{} * pi_half + reweight<nodes, nabla_weight, mean>{} * rho * pi_half));
static_assert(mean_h_minus == rho_h * mean_h_plus and mean_h_plus == sigma_h * mean_h_minus and mean_h_minus != mean_h_plus);
static_assert(mean_h_minus * pi_inverse == fraction<1, 2>{} * (pi_inverse * (rho * sigma + rho) * pi_half * pi_inverse));
static_assert(on_half * extend == fraction<1, 2>{} * (pi_inverse + pi_inverse * sigma));

// The fundamental theorem. Delta_plus is a left inverse of the integral, and the integral of nabla goes with Delta_minus.
static_assert(pi_inverse * Delta_plus * antiderivative_h == identity_h and Delta_plus * antiderivative_h == pi_half);
static_assert(Delta_plus * antiderivative == sigma * rho and Delta_minus * antiderivative_nabla == rho * sigma);
static_assert(antiderivative_h * pi_inverse == antiderivative and antiderivative * sigma == antiderivative_nabla);
static_assert(antiderivative != antiderivative_nabla and uniformly(antiderivative) != antiderivative_nabla);
// In the other order the value at a is lost: a constant has the derivative 0.
static_assert(antiderivative * Delta_plus != identity_T and Delta_plus * antiderivative * Delta_plus == Delta_plus);
static_assert(Delta_minus * adjoint(antiderivative_h * pi_inverse) == -(pi_half * pi_inverse * rho * sigma)); // d/dt int_t^b = -1

// Linear: operators form a vector space, and composition distributes over it.
constexpr fraction<1, 2> half_of;
constexpr fraction<2, 3> c;
static_assert(sigma + Delta_plus == Delta_plus + sigma and (sigma + rho) + Delta_plus == sigma + (rho + Delta_plus));
static_assert(c * (sigma + rho) == c * sigma + c * rho and half_of * (c * sigma) == fraction<1, 3>{} * sigma);
static_assert(sigma - sigma == fraction<0>{} * sigma and sigma + sigma == fraction<2>{} * sigma and -(-sigma) == sigma);
static_assert(Delta_plus * (sigma + rho) == Delta_plus * sigma + Delta_plus * rho);
static_assert((sigma + rho) * Delta_plus == sigma * Delta_plus + rho * Delta_plus);
static_assert(Delta_plus * (c * rho) == c * (Delta_plus * rho) and (c * Delta_plus) * rho == c * (Delta_plus * rho));
static_assert((Delta_plus * sigma) * rho == Delta_plus * (sigma * rho) and extend * (sigma + rho) == extend * sigma + extend * rho);
static_assert(identity_T * sigma == sigma and sigma * identity_T == sigma and extend * identity_T == extend and
              identity_o * extend == extend);
static_assert(Delta_minus[Delta_plus] == Delta_minus * Delta_plus and on_half[Delta_o_plus[extend]] == on_half * Delta_o_plus * extend);

// Equality is an equivalence, and != its negation, for the restricted equality too.
static_assert(uniformly(step_mean) == uniformly(pi_half * mean_h_minus) and pi_half * mean_h_minus == uniformly(step_mean));
static_assert(uniformly(step_mean) != mean_o * extend * step_mean and uniformly(sigma) == sigma);

} // namespace
