// SPDX-License-Identifier: BSL-1.0
// A step that Newton's method does not reach from the velocity before it, as where the step is long or steps are uneven: the velocity of a
// step of nearly no length, which is the momentum's own, is followed while the step grows to its length. What arrives is the root that the
// steps of all lesser lengths lead to, which is the one meant where there are several. (Continuation; Allgower and Georg, Introduction to
// Numerical Continuation Methods, 2003, chapter 2.)
#pragma once

#include <algorithm>
#include <limits>

#include "hilger/newton/on_branches.hpp"

namespace hilger::detail {

/// search_near, and where that ends without a root, x by growth from `last`: `set_share` makes `evaluate` and `correct` those of a step of
/// that share of the length, from nearly 0 on, and is 1 before, and after where a root is found. x is of the size of a velocity at all of
/// them. Where both end without a root, x, the residual and what is returned are of the search near.
template <class X>
branch_search search_or_grow(bool has_branches, X& x, X const& last, X& residual, equation_on_branches<X> const& evaluate,
                             correction_on_branches<X> const& correct, scalar_of<X> const& small,
                             function_view<void(scalar_of<X> const&)> const& set_share) {
    using S = scalar_of<X>;
    branch_search const how = search_near(has_branches, x, last, residual, evaluate, correct, small);
    if (how == branch_search::found or std::numeric_limits<S>::is_exact) return how;
    // By an eighth at once steps came to other roots; from an extrapolated x few are needed, however the velocity changes.
    S const most = S(1) / S(16), least = S(1) / S(1 << 24);
    S share = least, growth = most;
    X y = last, grown = last, slope = last - last, rest = residual;
    auto const leads_to_root = [&](X& from) {
        return (has_branches ? search_branches(from, rest, evaluate, correct, small)
                             : follow_newton(from, rest, evaluate, correct, small)) == branch_search::found;
    };
    set_share(share);
    if (not leads_to_root(y)) growth = S(0);
    for (int rounds = 0; share < S(1) and least < growth and rounds < 1024; ++rounds) {
        S const next = std::min(S(1), S(share + growth));
        grown = y + slope * S(next - share);
        set_share(next);
        if (leads_to_root(grown)) {
            slope = (grown - y) * S(S(1) / (next - share));
            y = grown;
            share = next;
            growth = std::min(most, S(S(2) * growth));
        } else
            growth = growth / S(4);
    }
    if (share < S(1)) return how;
    x = y;
    residual = rest;
    return branch_search::found;
}

} // namespace hilger::detail
