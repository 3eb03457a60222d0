// SPDX-License-Identifier: BSL-1.0
// Newton's iteration for the small systems of a Legendre map or a step. It stops when the next correction would be below the
// scalar's rounding, and gives up, saying where, when corrections stop shrinking.
#pragma once

#include <string>

#include <Eigen/LU>

#include "hilger/error.hpp"
#include "hilger/mechanics/derivatives.hpp"

namespace hilger {

/// The residual of a system and its derivative at one iterate.
template <class V>
struct newton_system {
    V residual;
    block_of<V> jacobian;
};

/// A Newton iteration that failed: how far it came.
template <class V>
struct newton_failure : error::no_convergence {
    newton_failure(std::string const& what, V last, V rest) : no_convergence(what), iterate(std::move(last)), residual(std::move(rest)) {}
    V iterate;
    V residual;
};

namespace detail {
/// J^-1 r. @throws error::singular
template <class V>
V solve(block_of<V> const& J, V const& r, char const* what) {
    auto const refuse = [&] {
        error::raise<error::singular>(what,
                                      " has a singular derivative here: the second derivative of L by the velocity must be invertible");
    };
    if constexpr (requires { r.size(); }) {
        Eigen::PartialPivLU<block_of<V>> const lu(J);
        V const x = lu.solve(r);
        // A pivot at rounding level of the largest one means that no digit of the solution is right.
        auto const pivots = lu.matrixLU().diagonal().cwiseAbs().eval();
        using S = scalar_of<V>;
        if (not(pivots.maxCoeff() * S(static_cast<int>(r.size())) * epsilon<S>() < pivots.minCoeff())) refuse();
        return x;
    } else {
        if (J == V(0)) refuse();
        return r / J;
    }
}
template <class V>
bool all_finite(V const& x) {
    using s = shape<V>;
    for (int k = 0; k < s::size; ++k)
        if (not is_finite(s::component(x, k))) return false;
    return true;
}
} // namespace detail

/// The root of `system` (iterate -> newton_system) near `guess`; `what` names the equation in messages. In an exact scalar the
/// root must be reached exactly, which linear equations do in one iteration.
/// @throws newton_failure, error::singular, error::not_finite
template <class V, class System>
V newton(System const& system, V guess, char const* what) {
    using S = scalar_of<V>;
    constexpr bool exact = std::numeric_limits<S>::is_exact;
    constexpr int most = exact ? 4 : 50;
    // Convergence is quadratic: after a correction of size sqrt(eps) the error is of size eps.
    S const small = [] {
        using std::sqrt;
        if constexpr (exact)
            return S(0);
        else
            return S(sqrt(epsilon<S>()) / S(16));
    }();
    V x = std::move(guess);
    S previous(-1), size(0);
    V residual = zero_like(x);
    for (int iteration = 0; iteration < most; ++iteration) {
        auto const at = system(x);
        if (not detail::all_finite(at.residual)) error::raise<error::not_finite>(what, " meets NaN or infinity in its Newton iteration");
        residual = at.residual;
        if (magnitude(residual) == S(0)) return x;
        V const correction = detail::solve(at.jacobian, residual, what);
        x = x - correction;
        size = magnitude(correction);
        if constexpr (not exact) {
            S const scale = magnitude(x);
            if (size <= small * scale) return x;
            // Near x = 0 relative accuracy is out of reach; the floor is where corrections no longer shrink.
            bool const stalled = not(previous < S(0)) and not(size < previous);
            if (stalled and previous <= S(64) * epsilon<S>() * (S(1) + scale)) return x;
        }
        previous = size;
    }
    std::ostringstream message;
    message << what << " did not converge in " << most << " Newton iterations; the last correction was " << size;
    message << (exact ? ". An exact scalar needs an equation that is linear in the unknown" : ". A smaller step h brings the guess closer");
    throw newton_failure<V>(message.str(), x, residual);
}

} // namespace hilger
