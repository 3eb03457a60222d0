// SPDX-License-Identifier: BSL-1.0
// Newton's iteration for the small systems of a Legendre map or a step. It stops when the next correction would be below the
// scalar's rounding, and gives up, saying where, when corrections stop shrinking.
#pragma once

#include <optional>
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
        if (not is_divisor(J)) return r == V(0) and J == J and not(J == V(0)); // a slope without bound has one root
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
template <class V>
V ones_like(V x) {
    if constexpr (requires { x.setOnes(); })
        return x.setOnes();
    else
        return V(1);
}
/// Iterate -> newton_system. Erased, so that one iteration is compiled for all systems of the same vectors and matrices.
template <class V, class Jacobian>
using newton_function = function_view<newton_system<V, Jacobian>(V const&)>;

/// Convergence is quadratic: after a correction of this relative size the error is of size epsilon.
template <class S>
S small_correction() {
    return square_root_of_epsilon<S>() / S(16);
}

/// The root of a system by a search (newton/on_branches.hpp): with branches, or without them where Newton's path leads from x.
template <bool HasBranches, class V, class Jacobian>
V newton_search(newton_function<V, Jacobian> const& system, V x, V const& given, scalar_of<V> const& small, char const* what,
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
    branch_search how;
    if constexpr (HasBranches)
        how = search_branches(x, residual, evaluate_at, correct, small);
    else
        how = follow_newton(x, residual, evaluate_at, correct, small);
    if (how != branch_search::found) give_up_on_branches(what, how, x, residual, by);
    return x;
}
/// The root of a system by at most `most` whole corrections, or none: they may have been led astray. @throws where nothing else helps
template <class V, class Jacobian>
std::optional<V> newton_whole(newton_function<V, Jacobian> const& system, V const& guess, V const& given, int most, char const* what,
                              solvability const& by) {
    using S = scalar_of<V>;
    constexpr bool exact = std::numeric_limits<S>::is_exact;
    S const small = small_correction<S>();
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
        if (inside.before.saw_any()) return newton_search<true>(system, std::move(x), given, small, what, by);
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
            if (size <= small * magnitude(x) and magnitude(residual) <= magnitude(given)) return x;
            // Near x = 0 relative accuracy is out of reach; the floor is where corrections no longer shrink, and are rounding of the
            // iterate before (one that runs away is no measure of itself) and of what is given.
            bool const stalled = not(previous < S(0)) and not(size < previous);
            if (stalled and size <= S(64) * epsilon<S>() * std::max(before, S(magnitude(solve(at.jacobian, sizes(given), what, by)))))
                return x;
        }
        previous = size;
    }
    if constexpr (exact) give_up(what, false, x, residual, size, most, by);
    return std::nullopt;
}
template <class S>
constexpr int most_whole_corrections = std::numeric_limits<S>::is_exact ? 4 : 50;

/// newton(), below: by whole corrections or, where these do not arrive, along Newton's path.
template <class V, class Jacobian>
V newton_of(newton_function<V, Jacobian> const& system, V const& guess, V const& given, int most, char const* what, solvability const& by) {
    if (auto x = newton_whole(system, guess, given, most, what, by)) return *std::move(x);
    V x = newton_search<false>(system, guess, given, small_correction<scalar_of<V>>(), what, by);
    if (auto y = newton_whole(system, x, given, most, what, by)) return *std::move(y);
    return x;
}
/// root_from(near); where that leads nowhere, from 0; and where the derivative at 0 is singular or none, as there is no mass at rest with
/// L = v^4 and L = v log v, from what is `given`, or from ones.
template <class V, class From>
V root_near(V const& near, V const& given, From const& root_from) {
    try {
        return root_from(near);
    } catch (error::exception const&) {
        for (V const& guess : {zero_like(given), given, ones_like(given)})
            if (not(guess == near)) try {
                    return root_from(guess);
                } catch (error::exception const&) { // the first one says more
                }
        throw;
    }
}
} // namespace detail

/// The root of `system` (iterate -> newton_system) near `guess`; the residual is something less `given`, and rounds like it; `what` names
/// the equation in messages, and `by` says when its derivative is regular. In an exact scalar the root must be reached exactly, which
/// linear equations do in one iteration. A system with branches (differentiation/branches.hpp) is solved at what is returned; inside of a
/// callable none of its branches count.
/// @throws newton_failure, with error::no_branch where a system with branches has no solution; error::singular, error::not_finite
template <class V, class System>
V newton(System const& system, V const& guess, V const& given, char const* what, detail::solvability const& by = detail::by_the_velocity) {
    using jacobian = decltype(system(guess).jacobian);
    return detail::newton_of<V, jacobian>(system, guess, given, detail::most_whole_corrections<scalar_of<V>>, what, by);
}
/// The same, of a guess so near that a root which more than a few whole corrections lead to is another one: that of Newton's path is taken.
template <class V, class System>
V newton_next_to(System const& system, V const& guess, V const& given, char const* what,
                 detail::solvability const& by = detail::by_the_velocity) {
    using S = scalar_of<V>;
    using jacobian = decltype(system(guess).jacobian);
    constexpr int most = std::numeric_limits<S>::is_exact or std::numeric_limits<S>::digits <= 64 ? 4 : 6; // one more for twice the digits
    return detail::newton_of<V, jacobian>(system, guess, given, most, what, by);
}

} // namespace hilger
