// SPDX-License-Identifier: BSL-1.0
// The exponential e_p(t, s) of a time scale (Bohner and Peterson, chapter 2): the solution of Delta_plus y = p y with y(s) = 1. On a
// discrete scale it is the product of 1 + mu p over the points from s to t, and its inverse when t lies before s.
#pragma once

#include "hilger/function/concept.hpp"

namespace hilger {

/// e_p(t, s) for p on T or T^+. @throws error::outside_domain when s or t is not in T; error::invalid_parameter when 1 + mu p
/// vanishes between them, because p is then not regressive.
template <discrete_function P>
constexpr auto exponential(P const& p, typename P::root_type::scalar_type const& t, typename P::root_type::scalar_type const& s) {
    auto const T = derived_scale(p.root(), domain<base_of<P>>{p.domain().base});
    index_type const from = T.number_of(s), to = T.number_of(t);
    value_of<P> product(1);
    for (index_type i = std::min(from, to); i < std::max(from, to); ++i) {
        value_of<P> const factor = value_of<P>(1) + T.domain().base.step(T.root(), i) * p[i];
        if (factor == value_of<P>(0))
            error::raise<error::invalid_parameter>("e_p needs a regressive p, and 1 + mu p is zero at ", T.element(i));
        product = product * factor;
    }
    return from <= to ? product : value_of<P>(value_of<P>(1) / product);
}

} // namespace hilger
