// SPDX-License-Identifier: BSL-1.0
// All identities, as one Hana tuple: boost::hana::for_each(identities::calculus, ...) runs them on any scale and in any scalar.
#pragma once

#include <boost/hana/for_each.hpp>
#include <boost/hana/tuple.hpp>

#include "identities/by_parts.hpp"
#include "identities/calculus.hpp"
#include "identities/diagrams.hpp"

namespace hilger::identities {

namespace detail {
using half_ = fraction<1, 2>;
using third = fraction<1, 3>;
} // namespace detail

/// Identities of the calculus, for every family of points they are stated on.
inline constexpr auto calculus = boost::hana::make_tuple(
    fundamental_theorem<nodes>{}, fundamental_theorem<between<detail::half_>>{}, fundamental_theorem<joined<detail::half_>>{},
    fundamental_theorem<joined<detail::third>>{}, derivative_of_integral{}, derivative_of_lambda_integral<fraction<0>>{},
    derivative_of_lambda_integral<detail::third>{}, derivative_of_lambda_integral<detail::half_>{}, leibniz<nodes>{},
    leibniz<between<detail::half_>>{}, leibniz<joined<detail::half_>>{}, leibniz_shifted{}, shift_and_graininess<nodes>{},
    shift_and_graininess<between<detail::half_>>{}, shift_and_graininess<joined<detail::third>>{}, shifts_are_inverse<nodes>{},
    shifts_are_inverse<between<detail::half_>>{}, shifts_are_inverse<joined<detail::half_>>{}, t_kappa<nodes>{},
    t_kappa<between<detail::half_>>{}, t_kappa<joined<detail::half_>>{});

/// The formulae of Cresson-Safi, section 2.
inline constexpr auto formulae = boost::hana::make_tuple(
    by_parts_order_one<nodes>{}, by_parts_order_one<between<detail::half_>>{}, by_parts_order_one<joined<detail::half_>>{},
    lemma_1<detail::half_>{}, lemma_1<detail::third>{}, lemma_2{}, lemma_3{}, step_mean_is_adjoint<detail::half_>{},
    step_mean_is_adjoint<detail::third>{}, step_mean_is_adjoint<fraction<0>>{}, lemma_4{}, derivative_diagram<nodes>{},
    derivative_diagram<between<detail::half_>>{}, derivative_diagram<joined<detail::half_>>{}, integral_diagram<fraction<0>>{},
    integral_diagram<detail::third>{}, integral_diagram<detail::half_>{}, extension_is_interpolation<detail::half_>{},
    extension_is_interpolation<detail::third>{}, midpoint_quadrature{});

/// Operators, primitive and composed, for the tests of adjoint laws.
inline constexpr auto operators =
    boost::hana::make_tuple(sigma, rho_o, Delta_plus, Delta_minus, Delta_h_minus, Delta_o_plus, extend, extend_lambda<1, 3>, on_T, on_half,
                            pi_half, pi_inverse, step_mean, mean_h_minus, mean_o, antiderivative, antiderivative_h, antiderivative_nabla,
                            Delta_plus* Delta_minus, Delta_plus* Delta_plus, on_half* extend, on_half* Delta_o_plus* extend,
                            identity_T + rho, fraction<3, 2>{} * Delta_minus - sigma, Delta_minus* antiderivative_h);

} // namespace hilger::identities
