// SPDX-License-Identifier: BSL-1.0
// What must not be equal: an equality that says yes too often proves nothing. One wrong sign, index, factor, scale or end point each.
#include "hilger/calculus.hpp"

using namespace hilger;

namespace {

// signs and factors
static_assert(Delta_plus != -Delta_plus and adjoint(Delta_plus) != Delta_minus and adjoint(sigma) != -rho);
static_assert(mean_h_minus != identity_h + rho_h and mean_o != on_T * (sigma_o + rho_o));
static_assert(sigma != fraction<999'999, 1'000'000>{} * sigma and uniformly(sigma) != fraction<999'999, 1'000'000>{} * sigma);
static_assert(adjoint(on_T) != insertion<fraction<1, 2>, true>{}); // the weights of T_o are half of T's, so a factor 2 is due
static_assert(adjoint(on_T) == fraction<2>{} * insertion<fraction<1, 2>, true>{});

// indices
static_assert(sigma != rho and sigma * sigma != sigma and Delta_plus != Delta_minus and Delta_plus * sigma != Delta_plus);
static_assert(mean_h_minus != fraction<1, 2>{} * (identity_h + rho_h * rho_h));
static_assert(on_half * sigma_o * extend != on_half * extend and pi_inverse != pi_inverse * sigma and
              pi_inverse * rho != pi_inverse * sigma);
static_assert(antiderivative_h * pi_inverse * sigma != antiderivative_h * pi_inverse);

// steps: the same differences, divided by something else
static_assert(on_half * Delta_o_plus * extend != fraction<2>{} * (pi_inverse * Delta_plus));
static_assert(pi_half * Delta_h_minus != Delta_minus * pi_half);                                      // on any scale mu_{1/2} is not nu
static_assert(uniformly(pi_half * Delta_h_minus * pi_inverse) == Delta_minus * pi_half * pi_inverse); // on a uniform one both are h
static_assert(uniformly(Delta_o_plus * extend * rho * sigma) != extend * Delta_plus * rho * sigma);   // h/2 steps to a mean, not h

// scales: from, to, and the family
static_assert(Delta_plus != Delta_h_plus and Delta_plus != Delta_o_plus and sigma != sigma_h and sigma_h != sigma_o);
static_assert(identity_T != identity_h and identity_h != identity_o and on_T != on_half and pi_half != pi_inverse and extend != on_T);
static_assert(pi_half != identity_h and pi_inverse != identity_T and extend_lambda<1, 3> != extend_lambda<1, 4> and
              extend_lambda<1, 3> != extend);
static_assert(shift<between<fraction<1, 3>>, side::plus>{} != sigma_h and projection<fraction<1, 3>, false>{} != pi_half);
static_assert(extend_lambda<2, 4> == extend and projection<reduced<2, 4>, false>{} == pi_half and
              antiderivative_at<reduced<3, 6>>{} == antiderivative_h);

// domains: the same values, on fewer points
static_assert(sigma * rho != identity_T and pi_half * pi_inverse != identity_T and rho * sigma != pi_half * pi_inverse);
static_assert(reweight<nodes, delta_weight, delta_weight>{} != identity_T); // the Delta weight of the last point is 0
static_assert(Delta_plus * rho * sigma != Delta_plus and uniformly(Delta_plus * rho * sigma) != Delta_plus);
static_assert(insertion<fraction<1, 2>, true>{} * on_T + insertion<fraction<1, 2>, false>{} * on_half == identity_o);
static_assert(insertion<fraction<1, 2>, true>{} * on_T != identity_o);

// reweighting: nothing on uniform scales but the end points, something elsewhere
static_assert(reweight<nodes, delta_weight, nabla_weight>{} != rho * sigma and
              uniformly(reweight<nodes, delta_weight, nabla_weight>{}) != identity_T);
static_assert(reweight<nodes, delta_weight, nabla_weight>{} * reweight<nodes, nabla_weight, delta_weight>{} == rho * sigma * sigma * rho);

// Uniform equality does not leak into equality on every scale.
static_assert(uniformly(Delta_plus * sigma) == sigma * Delta_plus and Delta_plus * sigma != sigma * Delta_plus);
static_assert(uniformly(step_mean) == pi_half * mean_h_minus and step_mean != pi_half * mean_h_minus);

} // namespace
