// SPDX-License-Identifier: BSL-1.0
// Rates g(q) = dt/dtau > 0 of a transformation of time (variational/time_transformation.hpp), by name. Any callable of q that numbers with
// derivatives pass through is one, as [](auto const& q) { return 1 + q * q; }.
//   sundman(gamma)           |q|^gamma (Sundman 1912): with 1 Kepler's steps are equal in the eccentric anomaly, with 2 in the true one
//   sundman(gamma, r)        r(q)^gamma of a distance r, as that of two bodies among several
//   inverse_potential(L)     1 / L(q, 0) = -1 / U(q), for a potential U < 0
#pragma once

#include <cmath>
#include <utility>

#include "hilger/scalar.hpp"

namespace hilger {

/// |q|, of a number or of a vector.
struct distance_from_origin {
    template <class Q>
    constexpr auto operator()(Q const& q) const {
        using std::sqrt;
        return sqrt(dot_product(q, q));
    }
};
/// r(q)^gamma
template <class Gamma, class Distance>
struct power_of_distance {
    Gamma gamma;
    [[no_unique_address]] Distance distance;
    template <class Q>
    constexpr auto operator()(Q const& q) const {
        using std::pow;
        return pow(distance(q), gamma);
    }
};
/// g(q) = r(q)^gamma. gamma is a number: 1, 1.5, or one with more digits.
template <class Gamma, class Distance = distance_from_origin>
constexpr auto sundman(Gamma gamma, Distance distance = {}) {
    return power_of_distance<Gamma, Distance>{gamma, std::move(distance)};
}

/// 1 / L(q, 0)
template <class L>
struct inverse_of_potential {
    [[no_unique_address]] L lagrangian;
    template <class Q>
    constexpr auto operator()(Q const& q) const {
        return 1 / lagrangian(q, at_rest(q));
    }

private:
    template <class Q>
    static constexpr plain_t<Q> at_rest(Q const& q) {
        if constexpr (requires { q.size(); })
            return plain_t<Q>::Zero(q.size());
        else
            return Q(0);
    }
};
/// g(q) = -1 / U(q) with U(q) = -L(q, 0), for an attraction U < 0: along a motion of Kepler's problem it is r.
template <class L>
constexpr auto inverse_potential(L lagrangian) {
    return inverse_of_potential<L>{std::move(lagrangian)};
}

} // namespace hilger
