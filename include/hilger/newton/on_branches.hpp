// SPDX-License-Identifier: BSL-1.0
// Newton's method for an equation r(x) = 0 that is made of branches (differentiation/branches.hpp). On one branch a small correction proves
// that the equation is solved; across branches nothing does but the equation itself. So an iterate is returned where Newton's last
// correction did not leave the branch, or where r is rounding at the iterate itself. Full steps first; they can go round between branches,
// and are then shortened until r shrinks (the method is then Newton's for semismooth equations, Qi and Sun 1993, with a line search). Where
// r jumps over zero there is no solution, and no step, however short, makes it smaller. An equation of one branch that whole
// corrections do not solve, from where they were made to start, has the root that Newton's path leads to from somewhere near, or none.
#pragma once

#include <algorithm>
#include <type_traits>

#include "hilger/differentiation/branches.hpp"
#include "hilger/function_view.hpp"
#include "hilger/newton/stop.hpp"

namespace hilger::detail {

/// How a search on branches ends.
enum class branch_search { found, singular, not_finite, between, lost, lost_on_one };

/// What evaluating r gives: r, the size of what it is the difference of, which says how it rounds, and the branches taken.
template <class X>
struct branch_point {
    X r;
    scalar_of<X> size;
    branch_path path;
};

/// Erased, since a search is long and there is one in every step that has an implicit equation: it is compiled once for all of them.
template <class X>
using equation_on_branches = std::type_identity_t<function_view<scalar_of<X>(X const& x, X& r)>>;
/// The size of what r is the difference of. One that is no number says nothing: r then has to be zero.
template <class X>
scalar_of<X> evaluated_size(equation_on_branches<X> const& evaluate, X const& x, X& r) {
    using S = scalar_of<X>;
    S const size = evaluate(x, r);
    return is_finite(size) ? size : S(0);
}
template <class X>
using correction_on_branches = std::type_identity_t<function_view<bool(X const& r, X& d)>>;

/// x in r(x) = 0. `evaluate(x, r)` puts r(x) into r and returns the size that its rounding is measured by; `correct(r, d)` puts Newton's
/// correction at the last x evaluated into d, false where the derivative is singular there. `small` is the relative size below which a
/// correction is the last. Found or not, x is the last one evaluated, and `residual` is r there.
template <class X>
branch_search search_branches(X& x, X& residual, equation_on_branches<X> const& evaluate, correction_on_branches<X> const& correct,
                              scalar_of<X> const& small) {
    using S = scalar_of<X>;
    constexpr bool exact = std::numeric_limits<S>::is_exact;
    constexpr int full_steps = exact ? 6 : 12, rounds = exact ? 12 : 80, halvings = exact ? 6 : 40;
    auto const at = [&](X const& y) {
        branch_point<X> p{y, S(0), {}};
        branch_watch const watch;
        p.size = evaluated_size<X>(evaluate, y, p.r);
        p.path = watch.path();
        return p;
    };
    auto const is_solved = [](branch_point<X> const& p, int times) { return magnitude(p.r) <= S(times) * epsilon<S>() * p.size; };
    branch_point<X> here = at(x);
    auto const lost = [&] { return here.path.made > 0 ? branch_search::lost : branch_search::lost_on_one; };
    if (not all_finite(here.r)) return branch_search::not_finite;
    X best = x, d = x, y = x;
    S smallest = magnitude(here.r);
    for (int round = 0; round < rounds; ++round) {
        residual = here.r;
        if (round == full_steps and smallest < magnitude(here.r)) {
            x = best;
            residual = (here = at(x)).r;
        }
        if (not correct(here.r, d)) return branch_search::singular; // of such an equation a root is one of many
        if (is_solved(here, 4) or magnitude(d) <= S(4) * epsilon<S>() * magnitude(x)) return branch_search::found;
        S part(1);
        branch_path first;
        bool better = false;
        for (int cut = 0; cut < halvings and not better; ++cut, part = part / S(2)) {
            y = x + d * part;
            branch_point<X> there = at(y);
            if (cut == 0) first = there.path;
            if (not all_finite(there.r)) continue;
            if (is_solved(there, 4) or (cut == 0 and there.path == here.path and magnitude(d) <= small * magnitude(y))) {
                x = y;
                residual = there.r;
                return branch_search::found;
            }
            better = round < full_steps or magnitude(there.r) <= (S(1) - part / S(4)) * magnitude(here.r);
            if (better) {
                x = y;
                here = std::move(there);
            }
        }
        if (not better) { // only rounding errors are left, or there is a jump
            branch_path const before = here.path;
            here = at(x);
            residual = here.r;
            if (first == before) return is_solved(here, 64) ? branch_search::found : lost();
            return branch_search::between;
        }
        if (S const size = magnitude(here.r); size < smallest) {
            smallest = size;
            best = x;
        }
    }
    residual = here.r;
    return lost();
}

/// The same, and where it ends without a root once more, from `nearer`: an extrapolated x may lie where r is not defined.
template <class X>
branch_search search_branches_twice(X& x, X const& nearer, X& residual, equation_on_branches<X> const& evaluate,
                                    correction_on_branches<X> const& correct, scalar_of<X> const& small) {
    branch_search const how = search_branches(x, residual, evaluate, correct, small);
    if (how == branch_search::found) return how;
    x = nearer;
    return search_branches(x, residual, evaluate, correct, small);
}

/// x in r(x) = 0 of one branch, by corrections so short that each is nearly what the one before it left to do, and half of it too: as long
/// as they are, the derivative is regular on the way, and the root is none of those behind a place where it is not. The arguments are those
/// of search_branches, `small` in units of each component. (Newton's path; Deuflhard, Newton Methods for Nonlinear Problems, 2004, section
/// 3.1.4.)
template <class X>
branch_search follow_newton(X& x, X& residual, equation_on_branches<X> const& evaluate, correction_on_branches<X> const& correct,
                            scalar_of<X> const& small) {
    using S = scalar_of<X>;
    using s = shape<X>;
    constexpr int rounds = 80, halvings = 12;
    X const start = x;
    S const least = S(1) / S(1 << halvings);
    X d = x, left = x, y = x;
    S part(1), size(0), before(0), size_before(0); // before: of r(x)
    // Corrections are small everywhere where the derivative grows without bound, as near the speed of light: r has to be no larger too, or
    // not by much, where the path turns.
    auto const is_at_most = [&](S const& bound) {
        return magnitude(residual) <= std::max(S(bound * before), S(S(64) * epsilon<S>() * std::min(size, size_before)));
    };
    auto const leads_on = [&](S const& share) {
        y = x + d * share;
        size = evaluated_size<X>(evaluate, y, residual);
        return all_finite(residual) and is_at_most(S(16)) and correct(residual, left) and
               magnitude(X(left - d * S(S(1) - share))) <= magnitude(d) / S(4);
    };
    auto const is_small = [&] {
        S const rounding = S(64) * epsilon<S>() * magnitude(x);
        for (int k = 0; k < s::dimension(x); ++k) {
            S const reach = std::max(S(magnitude(S(s::component(x, k)))), S(magnitude(S(s::component(start, k)))));
            if (not(magnitude(S(s::component(d, k))) <= small * reach + rounding)) return false;
        }
        return true;
    };
    size_before = evaluated_size<X>(evaluate, x, residual);
    before = magnitude(residual);
    if (not all_finite(residual)) return branch_search::not_finite;
    if (not correct(residual, d)) return branch_search::singular;
    for (int round = 0; round < rounds; ++round, part = std::min(S(1), S(2) * part)) {
        if (is_small()) {
            y = x + d;
            size = evaluated_size<X>(evaluate, y, residual);
            if (is_at_most(S(1) / S(2))) {
                x = y;
                return branch_search::found;
            }
        }
        bool good = false, meets_nan = false;
        for (int cut = 0; cut < halvings and not good; ++cut) {
            good = leads_on(S(part / S(2))) and leads_on(part);
            meets_nan = not all_finite(residual);
            if (not good) part = part / S(2);
        }
        if (not good and meets_nan) return branch_search::not_finite;
        if (not good or part < least) break;
        x = y;
        d = left;
        before = magnitude(residual);
        size_before = size;
    }
    // Beside large numbers corrections shrink no more where the residual is rounding.
    x = x + d;
    size = evaluated_size<X>(evaluate, x, residual);
    return magnitude(residual) <= S(4) * epsilon<S>() * size ? branch_search::found : branch_search::lost_on_one;
}

/// The root of a step's equation near `last`, what the step before was solved for, once whole corrections from the guess x do not do. Where
/// the equation is not defined at `last`, as behind a wall, there is the guess; and what is shorter than `last` may not reach the wall.
template <class X>
branch_search search_near(bool has_branches, X& x, X const& last, X& residual, equation_on_branches<X> const& evaluate,
                          correction_on_branches<X> const& correct, scalar_of<X> const& small) {
    if (has_branches) return search_branches_twice(x, last, residual, evaluate, correct, small);
    (void)evaluate(last, residual);
    if (all_finite(residual)) {
        x = last;
        return follow_newton(x, residual, evaluate, correct, small);
    }
    branch_search const how = search_branches(x, residual, evaluate, correct, small);
    if (how == branch_search::found or std::numeric_limits<scalar_of<X>>::is_exact) return how;
    X const iterate = x, rest = residual;
    scalar_of<X> part(1);
    for (int halvings = 0; halvings < 20 and not all_finite(residual); ++halvings) {
        part = part / scalar_of<X>(2);
        x = last * part;
        (void)evaluate(x, residual);
    }
    if (all_finite(residual) and follow_newton(x, residual, evaluate, correct, small) == branch_search::found) return branch_search::found;
    x = iterate;
    residual = rest;
    return how;
}

/// Says that a search on branches has failed. @throws newton_failure<V> or, at a jump, newton_failure<V, error::no_branch>;
/// error::singular, error::not_finite
template <class V>
[[noreturn, gnu::noinline, gnu::cold]] void give_up_on_branches(std::string const& what, branch_search how, V const& iterate,
                                                                V const& residual, solvability const& by = by_the_velocity) {
    if (how == branch_search::singular) refuse_singular(what, by);
    if (how == branch_search::not_finite or not all_finite(residual))
        error::raise<error::not_finite>(what, " meets NaN or infinity", by.around);
    if (how == branch_search::between)
        throw newton_failure<V, error::no_branch>(
            what +
                " has no solution on any branch of L that was met: where L compares its arguments its derivatives jump, and the branches "
                "on both sides of the jump lead across it. A step that does not meet the jump has one, and so has an L whose "
                "derivatives do not jump",
            iterate, residual);
    char const* const where = how == branch_search::lost ? " between the branches of L" : "";
    throw newton_failure<V>(what + " did not converge" + where + ". " + by.advice, iterate, residual);
}

} // namespace hilger::detail
