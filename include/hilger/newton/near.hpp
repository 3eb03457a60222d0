// SPDX-License-Identifier: BSL-1.0
// A root near a first guess, of equations with several. Whole corrections of Newton's method may leap to a far one, where the derivative is
// nearly singular on the way: between the ends of T, behind the time at which neighbouring motions meet again. Corrections that are
// shortened do not leap, but need not arrive. Where they do not, or arrive far away, their path is followed behind the places where it
// turns (arc.hpp), the equation is also changed into an easier one and back in steps, each of which starts from the root of the one before
// (continuation; Allgower and Georg, Introduction to Numerical Continuation Methods, 2003), and of what is found the nearest to the guess
// is taken.
#pragma once

#include <algorithm>
#include <exception>
#include <optional>

#include "hilger/newton/arc.hpp"
#include "hilger/newton/newton.hpp"

namespace hilger::detail {

/// Iterate, part of the time -> newton_system; part 1 is the equation, and the smaller it is, the nearer a straight line is to its root.
template <class V, class Jacobian>
using newton_family = function_view<newton_system<V, Jacobian>(V const&, scalar_of<V> const&)>;

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
            if (inside.before.saw_any()) return newton_search<true>(system, y, given, small, what, by);
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
/// x after corrections as long as they halve the residual: where the derivative is nearly singular, as that of a wall between two states
/// that may be anywhere, a small correction does not prove that the equation is solved.
template <class V, class Jacobian>
V polished(newton_function<V, Jacobian> const& system, V x) {
    using S = scalar_of<V>;
    auto at = system(x);
    for (int k = 0; k < 6; ++k) {
        V correction = zero_like(x);
        if (not solve_linear(at.jacobian, at.residual, correction)) break;
        V const y = x - correction;
        auto next = system(y);
        S const before = magnitude(at.residual);
        if (not all_finite(next.residual) or not(magnitude(next.residual) < before)) break;
        bool const halved = S(2) * magnitude(next.residual) < before;
        x = y;
        at = std::move(next);
        if (not halved) break;
    }
    return x;
}
/// The root for part 1 near `guess`, or next to it where there is no `straight_line`: the motion in no time, which continuation begins
/// with. `given`, `what` and `by` are those of newton(). @throws as newton() does, and where `stop` is asked to
template <class V, class Jacobian>
V newton_near(newton_family<V, Jacobian> const& system, V const& guess, V const* straight_line, V const& given, char const* what,
              solvability const& by, std::stop_token const& stop) {
    using S = scalar_of<V>;
    S part(1), step = S(1) / S(4);
    auto const in_part = [&](V const& x) { return system(x, part); };
    if (std::numeric_limits<S>::is_exact or not straight_line)
        return newton_of<V, Jacobian>(in_part, guess, given, most_whole_corrections<S>, what, by);
    // What is given stands in differences over the time, which are larger where there is less of it.
    auto const by_whole_corrections = [&](V const& x) {
        if (auto y = newton_whole<V, Jacobian>(in_part, x, V(given / part), most_whole_corrections<S>, what, by)) return *std::move(y);
        give_up_on_branches(what, branch_search::lost_on_one, x, in_part(x).residual, by);
    };
    auto const by_shortened_ones = [&](V const& x) { // which end near the root, and whole ones at it
        return by_whole_corrections(newton_damped<V, Jacobian>(in_part, x, V(given / part), small_correction<S>(), what, by));
    };
    auto const by_continuation = [&](V x) {
        for (S done(0); done < S(1);) {
            part = std::min(S(1), S(done + step));
            try {
                x = by_shortened_ones(x);
            } catch (error::exception const&) {
                if (stop.stop_requested()) throw;
                if (S(1) < S(32) * step) {
                    step = step / S(2);
                    continue;
                }
                x = by_whole_corrections(x);
            }
            done = part;
        }
        return x;
    };

    std::optional<V> found;
    std::exception_ptr failure;
    auto const distance = [&](V const& x) { return S(magnitude(V(x - guess))); };
    // Far away, where L and its derivatives tend to nothing, corrections are small beside x, and go on without end.
    S const reach = magnitude(guess);
    auto const solves = [&](V const& x) {
        part = S(1);
        auto at = in_part(x);
        if (magnitude(at.residual) <= S(1024) * epsilon<S>() * magnitude(given)) return true;
        V correction = zero_like(x);
        return not solve_linear(at.jacobian, at.residual, correction) or
               magnitude(correction) <= square_root_of_epsilon<S>() * (reach == S(0) ? S(magnitude(x)) : reach);
    };
    auto const attempt = [&](auto const& way, V const& from) {
        part = S(1);
        try {
            V x = way(from);
            if (not solves(x)) give_up_on_branches(what, branch_search::lost_on_one, x, in_part(x).residual, by);
            if (not found or distance(x) < distance(*found)) found = std::move(x);
        } catch (error::exception const&) {
            if (stop.stop_requested()) throw;
            failure = std::current_exception();
        }
    };
    auto const along_the_arc = [&](V const& x) -> V {
        if constexpr (not std::numeric_limits<S>::is_exact)
            if (auto y = arc<V, Jacobian>(in_part, x).end()) return by_shortened_ones(*y);
        give_up_on_branches(what, branch_search::lost_on_one, x, in_part(x).residual, by);
    };
    attempt(by_shortened_ones, guess);
    bool const is_far = found and S(4) * reach < distance(*found);
    if (not found or is_far) attempt(along_the_arc, guess);
    if (not found) {
        attempt(by_whole_corrections, guess);
        auto const why = failure;
        attempt(by_continuation, *straight_line);
        if (not found) std::rethrow_exception(why);
    }
    part = S(1);
    return polished<V, Jacobian>(in_part, *std::move(found));
}

} // namespace hilger::detail
