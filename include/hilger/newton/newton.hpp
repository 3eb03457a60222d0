// SPDX-License-Identifier: BSL-1.0
// Newton's method for r(x) = 0, with one stop, and its continuation. A correction is d = -r'(x)^-1 r(x), and is whole where it contracts,
// else shortened.
//   Contraction: with the derivative at x, the residual at x + s d asks for another correction, which should be (1 - s) d; it is followed
// where it differs by less than a quarter of d (Deuflhard, Newton Methods for Nonlinear Problems, 2004, sections 3.1.4 and 3.3). That does
// not depend on the units of the rows, and keeps to the path that leads to the root nearby.
//   Stop: where that other correction, of a whole one, is a few roundings of x in each component, which is what is left. Where corrections
// no longer contract, the residual has to be rounding.
//   Branches (differentiation/branches.hpp): across them a small correction proves nothing, and the residual itself has to fall (Newton's
// method for semismooth equations, Qi and Sun 1993). Full corrections come first; they can go round between branches. Where r jumps over
// zero no correction, however short, makes it smaller, and there is no solution.
//   Continuation: an equation that depends on a share, such as of the length of a step or of a time, is solved for a small share, and its
// root is followed to the whole (Allgower and Georg, Introduction to Numerical Continuation Methods, 2003, chapter 2). Of several roots it
// leads to the one that all lesser shares lead to.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "hilger/differentiation/branches.hpp"
#include "hilger/function_view.hpp"
#include "hilger/newton/stop.hpp"

namespace hilger::detail {

/// An equation as Newton's method asks for it: erased, so that the iteration is compiled once for all equations in the same vectors.
template <class X>
struct newton_equation {
    function_view<scalar_of<X>(X const& x, X& r)> evaluate; ///< r(x); returns the size of the terms of which r is the difference
    function_view<bool()> linearize;                        ///< the derivative where r was evaluated last; false where it is singular
    function_view<void(X const& r, X& d)> correct;          ///< d = -J^-1 r for the derivative J that was made last
    bool has_one_unit = false;                              ///< components are measured by the largest, not each by itself
};

/// What a share s of a correction d has to leave: anything; less than d; (1 - s) d, to a quarter of d, which keeps to the path that leads
/// to the root nearby; or that half-way too, so that it leaps over nothing. In the first two cases the root is known to half of the digits.
enum class corrections { any, smaller, on_the_path, followed };

/// One search for a root from x. At the end x is where r was evaluated last, and `residual` is r there.
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
    /// A size that is not a number says nothing: r then has to be zero.
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
    /// x a correction further, shortened where it has to be. @returns how the search ends, if it does
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
    /// Whether nothing can be leapt over.
    [[nodiscard]] bool is_small(X const& d) const { return size_of(d) <= square_root_of_epsilon<S>() / S(16); }
    [[nodiscard]] bool is_last() const { return how_ <= corrections::smaller ? is_small(d_) : size_of(left_) <= S(4) * epsilon<S>(); }
    /// Whether a share of d leaves what it should.
    bool contracts_by(S const& share) {
        equation_.correct(rest_, left_);
        if (how_ == corrections::any) return true;
        if (how_ == corrections::smaller) return size_of(left_) <= (S(1) - share / S(4)) * size_of(d_);
        return size_of(X(left_ - d_ * S(S(1) - share))) <= size_of(d_) / S(4);
    }
    /// The same of half of the share.
    bool contracts_half_way() {
        X const y = y_, rest = rest_;
        y_ = x_ + d_ * S(share_ / S(2));
        point const there = at(y_, rest_);
        bool const contracts = all_finite(rest_) and there.path == here_.path and contracts_by(share_ / S(2));
        y_ = y;
        rest_ = rest;
        return contracts;
    }
    /// The largest component, each in units of what it is; one that stands still is in units of the rounding of the others.
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
    bool meets_nan_ = false; ///< the last correction had to be shortened for numbers that are not finite
    corrections how_;
    point here_{};
};
/// The root from x on. @returns how the search ends; x is where r was evaluated last
template <class X>
newton_outcome newton(newton_equation<X> const& equation, X& x, X& residual, corrections how) {
    return newton_search<X>(equation, x, residual, how).run();
}

/// The shares of a continuation: the first one, of 0 the start is the root, the largest increase, and the smallest one that it is given up
/// with.
template <class S>
struct continuation_shares {
    S first, most, least;
};
/// Follows a root from a share of nearly nothing, near `start`, to the whole: `set_share` changes the equation. x, `residual` and the
/// derivatives of the equation are those of the whole where that arrives, and x and `residual` are as they were where it does not; the
/// equation is then that of some share.
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
/// The root of the equation of a step by continuation in its share from `last`, the velocity of the step before: the one that all shorter
/// steps lead to, or none. Across branches, and in exact scalars, from x, and by continuation only where there is none. x is of the size of
/// a velocity for all shares.
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
