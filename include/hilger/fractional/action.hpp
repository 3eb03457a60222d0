// SPDX-License-Identifier: BSL-1.0
// The fractional embedding of a Lagrangian (Bourdin, Cresson, Greff, Inizan 2013, section 3): on a uniform T the functional (12)
//   h sum_{k=1..N} L(Q_k, (Delta_-^alpha Q)_k, t_k),   (Delta_-^alpha Q)_k = h^-alpha sum_{r=0..k} alpha_r Q_{k-r},
// is nabla_integral(L(q, Delta_minus(alpha)[q]), T). Its critical points for variations that vanish at both ends solve (EL_h^alpha),
//   dL/dx_k + (Delta_+^alpha dL/dv)_k = 0,  k = 1..N-1.
// Velocities and momenta count for k = 1..N only: the sums of Delta_+^alpha end at N, and k = 0 is never asked for. alpha = 1 is the
// order-one embedding with Delta_-.
#pragma once

#include "hilger/operator/fractional.hpp"
#include "hilger/scale/uniform.hpp"
#include "hilger/variational/variation.hpp"

namespace hilger {

/// The functional (12), with the weights of any generating function.
template <class F, generating_function G, class Order, class Root>
using fractional_action = action<F, identity_on<nodes, delta_weight>, fractional_difference<G, Order, side::minus>, nabla_weight, Root>;

} // namespace hilger
