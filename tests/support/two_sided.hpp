// SPDX-License-Identifier: BSL-1.0
// The equation of the fractional embedding of a Lagrangian (hilger/boundary/convolved.hpp), for tests of many Lagrangians.
#pragma once

#include "hilger/operator/fractional.hpp"
#include "hilger/scale/uniform.hpp"
#include "hilger/variational/lagrangian.hpp"
#include "hilger/variational/variation.hpp"

namespace hilger::testing {

/// Of L(q, Delta_minus(alpha)[q]) on T; alpha is a number, or a fraction.
template <class F, class Order, class Root>
auto two_sided(F L, Order const& alpha, Root const& T) {
    constexpr unknown q;
    if constexpr (scalar<Order>)
        return variation(nabla_integral(lagrangian{std::move(L)}(q, Delta_minus(alpha)[q]), T));
    else
        return variation(nabla_integral(lagrangian{std::move(L)}(q, Delta_minus_alpha<Order::numerator, Order::denominator>[q]), T));
}

} // namespace hilger::testing
