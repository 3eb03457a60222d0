// SPDX-License-Identifier: BSL-1.0
// Newton's method for r(x) = 0, with one stopping rule, and its continuation. A correction d = -r'(x)^-1 r(x) is shortened unless it
// contracts.
//   Contraction: the derivative at x and the residual at x + s d give a simplified correction, ideally (1 - s) d; s is accepted if they
// differ by less than a quarter of d (Deuflhard, Newton Methods for Nonlinear Problems, 2004, sections 3.1.4 and 3.3). This test does not
// depend on the units of the rows, and keeps to the path that leads to the root nearby.
//   Stop: the simplified correction after a whole one, which is the error that is left, is a few roundings of x in each component. If
// corrections do not contract, the residual has to be rounding.
//   Branches (differentiation/branches.hpp): across them a small correction proves nothing, and the residual itself has to fall (Newton's
// method for semismooth equations, Qi and Sun 1993). Full corrections come first; they can cycle between branches. If r jumps over zero, no
// correction reduces it, and there is no solution.
//   Continuation: an equation that depends on a share, as of the length of a step or of a time, is solved for a small share, and its root
// is followed to the whole (Allgower and Georg, Introduction to Numerical Continuation Methods, 2003, chapter 2). Of several roots it finds
// the one connected to those of all lesser shares.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "hilger/differentiation/branches.hpp"
#include "hilger/function_view.hpp"
#include "hilger/newton/stop.hpp"

namespace hilger::detail {

/// The interface of an equation to Newton's method, type-erased: the iteration is compiled once for all equations in the same vectors.
template <class X>
struct newton_equation {
    function_view<scalar_of<X>(X const& x, X& r)> evaluate; ///< r(x); returns the magnitude of the terms of r
    function_view<bool()> linearize;                        ///< the derivative at the last argument of evaluate; false if it is singular
    function_view<void(X const& r, X& d)> correct;          ///< d = -J^-1 r for the last derivative J
    bool has_one_unit = false;                              ///< components are measured by the largest, not each by itself
};

/// Requirement on the correction that is left by a share s of a correction d: none; less than d; (1 - s) d to a quarter of d, which keeps
/// to the path that leads to the root nearby; the same half-way too, which leaps over nothing. The first two give half of the digits.
enum class corrections { any, smaller, on_the_path, followed };

/// One search for a root from x. At its end x is the last argument of r, and `residual` is r(x).
template <class X>
class newton_search {
    using S = scalar_of<X>;
    using s = shape<X>;
    static constexpr bool exact = std::numeric_limits<S>::is_exact;
    static constexpr int rounds = exact ? 6 : 80, whole_rounds = exact ? 6 : 12, halvings = exact ? 6 : 40;
    struct point {
        S size{0};
        branch_path path{};
    };

public:
    newton_search(newton_equation<X> const& equation, X& x, X& residual, corrections how)
        : equation_(equation), x_(x), r_(residual), best_(x), d_(x), left_(x), y_(x), rest_(x), how_(how) {}

    newton_outcome run() {
        here_ = at(x_, r_);
        if (not all_finite(r_)) return newton_outcome::not_finite;
        S smallest = magnitude(r_);
        for (int round = 0; round < rounds; ++round) {
            if (round == whole_rounds and here_.path.made > 0 and smallest < magnitude(r_)) return_to_best();
            if (not equation_.linearize()) // a root there is one of many
                return round == 0 or here_.path.made > 0 ? newton_outcome::singular : newton_outcome::lost;
            equation_.correct(r_, d_);
            if (magnitude(d_) == S(0) or (here_.path.made > 0 and is_rounding(r_, here_, 4))) return newton_outcome::found;
            if (auto const end = advance(round < whole_rounds)) return *end;
            if (S const size = magnitude(r_); size < smallest) {
                smallest = size;
                best_ = x_;
            }
        }
        return lost();
    }

private:
    /// A magnitude that is not finite counts as 0: r then has to be zero.
    point at(X const& y, X& r) const {
        branch_watch const watch;
        S const size = equation_.evaluate(y, r);
        return {is_finite(size) ? size : S(0), watch.path()};
    }
    [[nodiscard]] bool is_rounding(X const& r, point const& p, int times) const { return magnitude(r) <= S(times) * epsilon<S>() * p.size; }
    void return_to_best() {
        x_ = best_;
        here_ = at(x_, r_);
    }
    [[nodiscard]] newton_outcome lost() const {
        if (meets_nan_) return newton_outcome::not_finite;
        return here_.path.made > 0 ? newton_outcome::lost_between : newton_outcome::lost;
    }
    /// Advances x by a correction, shortened if necessary. @returns how the search ends, if it does
    std::optional<newton_outcome> advance(bool any_across) {
        branch_path whole_path;
        bool is_nan = meets_nan_ = false;
        share_ = here_.path.made > 0 ? S(1) : std::min(S(1), S(2) * share_);
        for (int made = 0; made < halvings; share_ = share_ / S(2), ++made) {
            y_ = x_ + d_ * share_;
            bool const half_way = how_ != corrections::followed or here_.path.made > 0 or is_small(d_) or contracts_half_way();
            point const there = at(y_, rest_);
            if (made == 0) whole_path = there.path;
            is_nan = not all_finite(rest_);
            meets_nan_ = meets_nan_ or is_nan;
            if (is_nan) continue;
            bool const contracts_there = there.path == here_.path and contracts_by(share_), contracts = contracts_there and half_way;
            if (contracts and share_ == S(1) and is_last()) return accept(there);
            if (is_rounding(rest_, there, 4) and (not contracts_there or here_.path.made > 0 or how_ <= corrections::smaller))
                return accept(there);
            if (contracts or (here_.path.made > 0 and (any_across or magnitude(rest_) <= (S(1) - share_ / S(4)) * magnitude(r_)))) {
                (void)accept(there);
                return std::nullopt;
            }
        }
        here_ = at(x_, r_); // only rounding errors are left, or there is a jump
        if (is_nan) return newton_outcome::not_finite;
        if (whole_path == here_.path) return is_rounding(r_, here_, here_.path.made > 0 ? 64 : 4) ? newton_outcome::found : lost();
        return newton_outcome::between;
    }
    newton_outcome accept(point const& there) {
        x_ = y_;
        r_ = rest_;
        here_ = there;
        return newton_outcome::found;
    }
    /// Whether d is too small to leap over a root.
    [[nodiscard]] bool is_small(X const& d) const { return size_of(d) <= square_root_of_epsilon<S>() / S(16); }
    [[nodiscard]] bool is_last() const { return how_ <= corrections::smaller ? is_small(d_) : size_of(left_) <= S(4) * epsilon<S>(); }
    /// Whether a share of d satisfies the requirement.
    bool contracts_by(S const& share) {
        equation_.correct(rest_, left_);
        if (how_ == corrections::any) return true;
        if (how_ == corrections::smaller) return size_of(left_) <= (S(1) - share / S(4)) * size_of(d_);
        return size_of(X(left_ - d_ * S(S(1) - share))) <= size_of(d_) / S(4);
    }
    /// The same for half of the share.
    bool contracts_half_way() {
        X const y = y_, rest = rest_;
        y_ = x_ + d_ * S(share_ / S(2));
        point const there = at(y_, rest_);
        bool const contracts = all_finite(rest_) and there.path == here_.path and contracts_by(share_ / S(2));
        y_ = y;
        rest_ = rest;
        return contracts;
    }
    /// The largest component, each relative to that of the iterate, but at least to the rounding of its largest one.
    [[nodiscard]] S size_of(X const& d) const {
        S const size_of_y = magnitude(y_), largest = size_of_y == S(0) ? S(magnitude(d_)) : size_of_y;
        if (equation_.has_one_unit) return magnitude(d) / largest;
        S const least = std::numeric_limits<S>::is_exact ? largest : S(epsilon<S>() * largest);
        S most(0);
        for (int k = 0; k < s::dimension(d); ++k) {
            S const reach = std::max(least, S(magnitude(S(s::component(y_, k))))), size = magnitude(S(s::component(d, k)));
            if (not(size <= most * reach)) most = size / reach;
        }
        return most;
    }

    newton_equation<X> const& equation_;
    X &x_, &r_;
    X best_, d_, left_, y_, rest_;
    S share_{1};
    bool meets_nan_ = false; ///< the last correction was shortened because of numbers that are not finite
    corrections how_;
    point here_{};
};
/// Searches for a root from x on. @returns how the search ends; x is then the last argument of r
template <class X>
newton_outcome newton(newton_equation<X> const& equation, X& x, X& residual, corrections how) {
    return newton_search<X>(equation, x, residual, how).run();
}

/// Shares of a continuation: the first one (at 0 the start is the root), the largest increase, and the smallest one before it gives up.
template <class S>
struct continuation_shares {
    S first, most, least;
};
/// Follows a root from a small share, near `start`, to the whole; `set_share` changes the equation. @returns whether it arrives: x,
/// `residual` and the derivatives are then those of the whole; else x and `residual` are unchanged, and the equation is that of some share
template <class X>
bool continued(newton_equation<X> const& equation, X& x, X const& start, X& residual, continuation_shares<scalar_of<X>> const& shares,
               corrections how, function_view<void(scalar_of<X> const&)> const& set_share) {
    using S = scalar_of<X>;
    S share = shares.first, growth = shares.most;
    X y = start, next = start, slope = start - start, rest = residual;
    if (S(0) < share) {
        set_share(share);
        if (newton(equation, y, rest, how) != newton_outcome::found) return false;
    }
    for (int made = 0; share < S(1); ++made) {
        if (growth < shares.least or made == 1024) return false;
        S const further = std::min(S(1), S(share + growth));
        next = how == corrections::smaller ? y : X(y + slope * S(further - share));
        set_share(further);
        bool is_root = newton(equation, next, rest, how) == newton_outcome::found;
        if (not is_root and how == corrections::smaller and growth < S(2) * shares.least) {
            next = y;
            is_root = newton(equation, next, rest, corrections::any) == newton_outcome::found;
        }
        if (is_root) {
            slope = (next - y) * S(S(1) / (further - share));
            y = next;
            share = further;
            growth = std::min(shares.most, S(S(2) * growth));
        } else
            growth = growth / S(how == corrections::smaller ? 2 : 4);
    }
    x = y;
    residual = rest;
    return true;
}
/// The root of the equation of a step. Without branches: by continuation in its share from `last`, the velocity of the previous step, which
/// finds the root connected to those of all shorter steps, or none; exact scalars search from `last`. With branches: from x, and by
/// continuation if there is none. For all shares x has the magnitude of a velocity.
template <class X>
newton_outcome root_of_step(bool has_branches, newton_equation<X> const& equation, X& x, X const& last, X& residual,
                            function_view<void(scalar_of<X> const&)> const& set_share) {
    using S = scalar_of<X>;
    constexpr bool exact = std::numeric_limits<S>::is_exact;
    S const nearly_none = S(1) / S(1 << 24);
    auto const grows = [&] {
        return not exact and
               continued(equation, x, last, residual, {nearly_none, S(1) / S(16), nearly_none}, corrections::followed, set_share);
    };
    if (not has_branches and grows()) return newton_outcome::found;
    if (not has_branches) x = last;
    set_share(S(1));
    newton_outcome const how = newton(equation, x, residual, corrections::followed);
    if (how == newton_outcome::found) return has_branches or exact ? how : newton_outcome::lost;
    return has_branches and grows() ? newton_outcome::found : how;
}

} // namespace hilger::detail
