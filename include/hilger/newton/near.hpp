// SPDX-License-Identifier: BSL-1.0
// A root near a first guess, of equations with several. Whole corrections of Newton's method may leap to a far one, where the derivative is
// nearly singular on the way: between the ends of T, behind the time at which neighbouring motions meet again. Corrections that are
// shortened do not leap, but need not arrive. Where they do not, or arrive far away, their path is followed behind the places where it
// turns (arc.hpp), the equation is also changed into an easier one and back in steps, each of which starts from the root of the one before
// (continuation; Allgower and Georg, Introduction to Numerical Continuation Methods, 2003), and of what is found the nearest to the guess
// is taken. The judge of all of them is the relative residual (variational/relative_residual.hpp): nothing is a root that does not solve
// its rows to the rounding of their terms.
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
/// The residual at the iterate that the system was evaluated at last -> how many roundings of its terms it has.
template <class V>
using relative_measure = function_view<scalar_of<V>(V const&)>;
/// A row is a sum of some tens of terms and of what the formulas of L are made of: each rounds, and none does more often with more points.
inline constexpr int most_roundings = 256;

/// x after corrections as long as they halve its roundings: where the derivative is nearly singular, as that of a wall between two states
/// that may be anywhere, a small correction does not prove that the equation is solved; and elimination is as exact in each row after one
/// more correction as in the largest (Skeel 1980).
template <class V, class Jacobian>
V polished(newton_function<V, Jacobian> const& system, relative_measure<V> const& relative, V x, scalar_of<V>& rest) {
    using S = scalar_of<V>;
    auto at = system(x);
    rest = relative(at.residual);
    for (int k = 0; k < 6 and all_finite(at.residual) and S(1) < rest; ++k) {
        V correction = zero_like(x);
        if (not solve_linear(at.jacobian, at.residual, correction)) break;
        V const y = x - correction;
        auto next = system(y);
        S const now = relative(next.residual);
        if (not all_finite(next.residual) or not(now < rest)) break;
        bool const halved = S(2) * now < rest;
        x = y;
        rest = now;
        at = std::move(next);
        if (not halved) break;
    }
    return x;
}
/// What one or two corrections lead to, as they do where the system is linear or x next to its root. @throws error::singular where it is
/// linear and has none, or many
template <class V, class Jacobian>
std::optional<V> newton_at_once(newton_function<V, Jacobian> const& system, relative_measure<V> const& relative, V x, V const& given,
                                char const* what, solvability const& by) {
    using S = scalar_of<V>;
    unwatched const inside;
    for (int k = 0; k < 3; ++k) {
        auto at = system(x);
        if (inside.before.saw_any() or not all_finite(at.residual)) return {};
        if (k > 0 and relative(at.residual) <= S(most_roundings)) return x;
        V correction = zero_like(x);
        if (k < 2 and solve_linear(at.jacobian, at.residual, correction)) {
            x = x - correction;
            continue;
        }
        if (k > 0) return {};
        V const second_difference = system(V(x * S(2))).residual - at.residual * S(2) + system(zero_like(x)).residual;
        if (magnitude(second_difference) <= S(1024) * epsilon<S>() * magnitude(given)) refuse_singular(what, by);
        return {};
    }
    return {};
}
template <class V>
[[noreturn]] void give_up_on_rounding(char const* what, scalar_of<V> const& rest, V const& iterate, V const& residual,
                                      solvability const& by) {
    std::ostringstream message;
    message << what << " did not converge: what is nearest to a solution leaves " << rest
            << " times the rounding of the terms of a row, and a solution less than " << most_roundings << ". " << by.advice;
    throw newton_failure<V>(message.str(), iterate, residual);
}
/// The root for part 1 near `guess`, or next to it where there is no `straight_line`: the motion in no time, which continuation begins
/// with. `given`, `what` and `by` are those of newton(). @throws as newton() does, and where `stop` is asked to
template <class V, class Jacobian>
V newton_near(newton_family<V, Jacobian> const& system, relative_measure<V> const& relative, V const& guess, V const* straight_line,
              V const& given, char const* what, solvability const& by, std::stop_token const& stop) {
    using S = scalar_of<V>;
    S part(1), step = S(1) / S(4);
    auto const in_part = [&](V const& x) { return system(x, part); };
    if (std::numeric_limits<S>::is_exact or not straight_line)
        return newton_of<V, Jacobian>(in_part, guess, given, most_whole_corrections<S>, what, by);
    if (auto x = newton_at_once<V, Jacobian>(in_part, relative, guess, given, what, by)) {
        S rest(0);
        return polished<V, Jacobian>(in_part, relative, *std::move(x), rest);
    }
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
    S const reach = magnitude(guess);
    auto const attempt = [&](auto const& way, V const& from) {
        part = S(1);
        try {
            V x = way(from);
            part = S(1);
            S rest(0);
            x = polished<V, Jacobian>(in_part, relative, std::move(x), rest);
            if (not(rest <= S(most_roundings))) give_up_on_rounding(what, rest, x, in_part(x).residual, by);
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
    return *std::move(found);
}

} // namespace hilger::detail
