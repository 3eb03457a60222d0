// SPDX-License-Identifier: BSL-1.0
// Newton's iteration for the small systems of a Legendre map or a step. It stops when the next correction would be below the
// scalar's rounding, and gives up, saying where, when corrections stop shrinking.
#pragma once

#include <string>
#include <utility>

#include "hilger/linear/patterned_matrix.hpp"
#include "hilger/newton/on_branches.hpp"
#include "hilger/newton/stop.hpp"

namespace hilger {

/// The residual of a system and its derivative at one iterate: a matrix, or one whose pattern is known.
template <class V, class Jacobian = block_of<V>>
struct newton_system {
    V residual;
    Jacobian jacobian;
};

namespace detail {
/// x = J^-1 r; false where J is singular to rounding.
template <class V, class Jacobian>
bool solve_linear(Jacobian& J, V const& r, V& x) {
    using S = scalar_of<V>;
    for (work const each : {work::newton_round, work::factorization, work::solve}) tally<S>::add(each);
    x = r;
    if constexpr (shape<V>::is_scalar) {
        if (J == V(0)) return false;
        x = r / J;
    } else if constexpr (requires { J.is_factorized(); }) {
        if (not J.is_factorized() and not J.factorize()) return false;
        J.solve(x);
    } else {
        auto e = elimination_of<S>(J);
        if (not e.factorize()) return false;
        e.solve(x);
    }
    return true;
}
/// The same. @throws error::singular
template <class V, class Jacobian>
V solve(Jacobian& J, V const& r, char const* what, solvability const& by) {
    V x = zero_like(r);
    if (not solve_linear(J, r, x)) refuse_singular(what, by);
    return x;
}
template <class Jacobian>
auto largest_entry(Jacobian& J) {
    if constexpr (requires { J.largest(); })
        return J.largest();
    else
        return magnitude(J);
}
/// The magnitudes of the components.
template <class V>
V sizes(V const& x) {
    if constexpr (requires { x.size(); })
        return x.cwiseAbs();
    else
        return magnitude(x);
}
/// Iterate -> newton_system. Erased, so that one iteration is compiled for all systems of the same vectors and matrices.
template <class V, class Jacobian>
using newton_function = function_view<newton_system<V, Jacobian>(V const&)>;

/// The root of a system with branches.
template <class V, class Jacobian>
V newton_on_branches(newton_function<V, Jacobian> const& system, V x, V const& given, scalar_of<V> const& small, char const* what,
                     solvability const& by) {
    using S = scalar_of<V>;
    Jacobian J;
    auto const evaluate_at = [&](V const& y, V& r) {
        auto const at = system(y);
        r = at.residual;
        J = at.jacobian;
        return S(magnitude(given) + S(shape<V>::dimension(y)) * largest_entry(J) * magnitude(y));
    };
    auto const correct = [&](V const& r, V& d) {
        if (not solve_linear(J, r, d)) return false;
        d = -d;
        return true;
    };
    V residual = x;
    branch_search const how = search_branches(x, residual, evaluate_at, correct, small);
    if (how != branch_search::found) give_up_on_branches(what, how, x, residual, by);
    return x;
}
/// The root of a system that whole corrections do not lead to from x: each is shortened until the next one, with the same derivative, is
/// smaller (Deuflhard, Newton Methods for Nonlinear Problems, 2004, section 3.3). Unlike the residual, that does not depend on the units of
/// rows.
template <class V, class Jacobian>
V newton_damped(newton_function<V, Jacobian> const& system, V x, V const& given, scalar_of<V> const& small, char const* what,
                solvability const& by) {
    using S = scalar_of<V>;
    constexpr int most = 100, halvings = 14;
    S part(1), size(0);
    unwatched const inside;
    auto at = system(x);
    int iteration = 0;
    for (; iteration < most; ++iteration) {
        V const correction = solve(at.jacobian, at.residual, what, by);
        size = magnitude(correction);
        part = std::min(S(1), S(4) * part);
        bool better = false;
        for (int cut = 0; cut < halvings and not better; ++cut) {
            V const y = x - correction * part;
            auto there = system(y);
            if (inside.before.saw_any()) return newton_on_branches(system, y, given, small, what, by);
            if (all_finite(there.residual)) {
                V const next = solve(at.jacobian, there.residual, what, by);
                S const left = magnitude(next);
                if (part == S(1) and left <= small * magnitude(y)) return y - next;
                better = left <= (S(1) - part / S(4)) * size;
            }
            if (better) {
                x = y;
                at = std::move(there);
            } else
                part = part / S(2);
        }
        if (not better) break;
    }
    give_up(what, false, x, at.residual, size, iteration, by);
}
/// newton(), below.
template <class V, class Jacobian>
V newton_of(newton_function<V, Jacobian> const& system, V guess, V const& given, char const* what, solvability const& by) {
    using S = scalar_of<V>;
    constexpr bool exact = std::numeric_limits<S>::is_exact;
    constexpr int most = exact ? 4 : 50;
    // Convergence is quadratic: after a correction of size sqrt(eps) the error is of size eps.
    S const small = square_root_of_epsilon<S>() / S(16);
    V x = guess;
    S previous(-1), size(0);
    V residual = zero_like(x), last = residual;
    unwatched const inside;
    for (int iteration = 0; iteration < most; ++iteration) {
        auto at = system(x);
        // A correction may lead to where there are no numbers, as beyond the speed of light: half of it, then, and half of that.
        for (int halved = 0; halved < 20 and iteration > 0 and not all_finite(at.residual); ++halved) {
            last = last * (S(1) / S(2));
            x = x + last;
            at = system(x);
        }
        if (inside.before.saw_any()) return newton_on_branches(system, std::move(x), given, small, what, by);
        bool const is_first = exact or iteration == 0; // later ones may have been led astray
        if (not all_finite(at.residual)) {
            if (not is_first) break;
            error::raise<error::not_finite>(what, " meets NaN or infinity in its Newton iteration", by.around);
        }
        residual = at.residual;
        // A guess that happens to solve a singular system is one of many solutions.
        if (magnitude(residual) == S(0) and iteration > 0) return x;
        V correction = zero_like(x);
        if (not solve_linear(at.jacobian, residual, correction)) {
            if (not is_first) break;
            refuse_singular(what, by);
        }
        if (magnitude(residual) == S(0)) return x;
        S const before = magnitude(x);
        x = x - correction;
        last = correction;
        size = magnitude(correction);
        if constexpr (not exact) {
            if (size <= small * magnitude(x)) return x;
            // Near x = 0 relative accuracy is out of reach; the floor is where corrections no longer shrink, and are rounding of the
            // iterate before (one that runs away is no measure of itself) and of what is given.
            bool const stalled = not(previous < S(0)) and not(size < previous);
            if (stalled and size <= S(64) * epsilon<S>() * std::max(before, S(magnitude(solve(at.jacobian, sizes(given), what, by)))))
                return x;
        }
        previous = size;
    }
    if constexpr (exact)
        give_up(what, false, x, residual, size, most, by);
    else
        return newton_damped(system, std::move(guess), given, small, what, by);
}
} // namespace detail

/// The root of `system` (iterate -> newton_system) near `guess`; the residual is something less `given`, and rounds like it; `what` names
/// the equation in messages, and `by` says when its derivative is regular. In an exact scalar the root must be reached exactly, which
/// linear equations do in one iteration. A system with branches (differentiation/branches.hpp) is solved at what is returned; inside of a
/// callable none of its branches count.
/// @throws newton_failure, with error::no_branch where a system with branches has no solution; error::singular, error::not_finite
template <class V, class System>
V newton(System const& system, V guess, V const& given, char const* what, detail::solvability const& by = detail::by_the_velocity) {
    using jacobian = decltype(system(guess).jacobian);
    return detail::newton_of<V, jacobian>(system, std::move(guess), given, what, by);
}

} // namespace hilger
