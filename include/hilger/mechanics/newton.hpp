// SPDX-License-Identifier: BSL-1.0
// Newton's iteration for the small systems of a Legendre map or a step. It stops when the next correction would be below the
// scalar's rounding, and gives up, saying where, when corrections stop shrinking.
#pragma once

#include <string>

#include <Eigen/LU>

#include "hilger/mechanics/newton_stop.hpp"

namespace hilger {

/// The residual of a system and its derivative at one iterate.
template <class V>
struct newton_system {
    V residual;
    block_of<V> jacobian;
};

namespace detail {
/// J^-1 r. @throws error::singular
template <class V>
V solve(block_of<V> const& J, V const& r, char const* what) {
    for (work const each : {work::newton_round, work::factorization, work::solve}) tally<scalar_of<V>>::add(each);
    if constexpr (requires { r.size(); }) {
        Eigen::PartialPivLU<block_of<V>> const lu(J);
        if (not is_regular(lu)) refuse_singular(what);
        return lu.solve(r);
    } else {
        if (J == V(0)) refuse_singular(what);
        return r / J;
    }
}
/// The magnitudes of the components.
template <class V>
V sizes(V const& x) {
    if constexpr (requires { x.size(); })
        return x.cwiseAbs();
    else
        return magnitude(x);
}
} // namespace detail

/// The root of `system` (iterate -> newton_system) near `guess`; the residual is something less `given`, and rounds like it; `what` names
/// the equation in messages. In an exact scalar the root must be reached exactly, which linear equations do in one iteration.
/// @throws newton_failure, error::singular, error::not_finite
template <class V, class System>
V newton(System const& system, V guess, V const& given, char const* what) {
    using S = scalar_of<V>;
    constexpr bool exact = std::numeric_limits<S>::is_exact;
    constexpr int most = exact ? 4 : 50;
    // Convergence is quadratic: after a correction of size sqrt(eps) the error is of size eps.
    S const small = detail::square_root_of_epsilon<S>() / S(16);
    V x = std::move(guess);
    S previous(-1), size(0);
    V residual = zero_like(x);
    for (int iteration = 0; iteration < most; ++iteration) {
        auto const at = system(x);
        if (not detail::all_finite(at.residual)) error::raise<error::not_finite>(what, " meets NaN or infinity in its Newton iteration");
        residual = at.residual;
        // A guess that happens to solve a singular system is one of many solutions.
        if (magnitude(residual) == S(0) and iteration > 0) return x;
        V const correction = detail::solve(at.jacobian, residual, what);
        if (magnitude(residual) == S(0)) return x;
        S const before = magnitude(x);
        x = x - correction;
        size = magnitude(correction);
        if constexpr (not exact) {
            if (size <= small * magnitude(x)) return x;
            // Near x = 0 relative accuracy is out of reach; the floor is where corrections no longer shrink, and are rounding of the
            // iterate before (one that runs away is no measure of itself) and of what is given.
            bool const stalled = not(previous < S(0)) and not(size < previous);
            if (stalled and
                size <= S(64) * epsilon<S>() * std::max(before, S(magnitude(detail::solve(at.jacobian, detail::sizes(given), what)))))
                return x;
        }
        previous = size;
    }
    detail::give_up(what, false, x, residual, size, most);
}

} // namespace hilger
