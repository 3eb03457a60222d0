// SPDX-License-Identifier: BSL-1.0
// The reach of an operator: the points of f that the value A[f](t) depends on. It is a constant of the operator's type,
//   local(l, r)     the points from l steps before t to r steps after it
//   causal(r)       every point from the first one to r steps after t      (antiderivatives, Delta_-^alpha)
//   anticausal(l)   every point from l steps before t to the last one      (their adjoints)
//   everywhere()    all of them
// and it obeys: composition adds, a sum takes the hull, the adjoint mirrors. An equation that reads the two ends of one step can be stepped
// from initial values; one that is not local cannot. A point of T_lambda counts as half a step from both ends of its step.
#pragma once

#include "hilger/scale/base.hpp"

namespace hilger {

/// See above; `|` is the hull.
class reach {
    static constexpr int unlimited = 1 << 28;
    static constexpr int halves(double steps) { return static_cast<int>(2 * steps); }

public:
    /// Distances from t in half steps, negative before it; nothing is read where first > last.
    struct span {
        int first = 1, last = 0;

        [[nodiscard]] constexpr bool is_empty() const { return last < first; }
        [[nodiscard]] constexpr bool from_start() const { return first == -unlimited; }
        [[nodiscard]] constexpr bool to_end() const { return last == unlimited; }
        friend constexpr bool operator==(span, span) = default;
    };
    span on_T{}, between{}; ///< for values at points of T, and at points between two of them

    static constexpr reach nothing() { return {}; }
    /// In steps; halves of them are exact.
    static constexpr reach local(double before, double after) {
        span const s{-halves(before), halves(after)};
        return {s, s};
    }
    static constexpr reach causal(double after = 0) { return {{-unlimited, halves(after)}, {-unlimited, halves(after)}}; }
    static constexpr reach anticausal(double before = 0) { return {{-halves(before), unlimited}, {-halves(before), unlimited}}; }
    static constexpr reach everywhere() { return {{-unlimited, unlimited}, {-unlimited, unlimited}}; }
    /// The same for values at the points of Base alone.
    template <class Base>
    [[nodiscard]] constexpr reach at() const {
        return {has_nodes<Base> ? on_T : span{}, has_between<Base> ? between : span{}};
    }

    [[nodiscard]] constexpr span whole() const { return hull(on_T, between); }
    [[nodiscard]] constexpr bool is_local() const { return not whole().from_start() and not whole().to_end(); }
    /// The number of steps that one value depends on, for a local reach.
    [[nodiscard]] constexpr int steps() const { return std::max({0, width(on_T), width(between)}); }

    friend constexpr bool operator==(reach, reach) = default;
    /// The hull: the reach of a sum.
    friend constexpr reach operator|(reach a, reach b) { return {hull(a.on_T, b.on_T), hull(a.between, b.between)}; }
    /// The reach of A B, where B makes functions on Middle.
    template <class Middle>
    static constexpr reach composed(reach a, reach b) {
        return {through<Middle>(a.on_T, 0, b), through<Middle>(a.between, 1, b)};
    }
    /// The reach of the adjoint of an operator with reach a from From to To.
    template <class From, class To>
    static constexpr reach mirrored(reach a) {
        auto const at = [&](int parity) {
            span s{};
            for (int to : {0, 1})
                if (to == 0 ? has_nodes<To> : has_between<To>) {
                    span const read = to == 0 ? a.on_T : a.between;
                    if (read.is_empty()) continue;
                    // only distances that lead from points of one kind to the other
                    int first = read.first, last = read.last;
                    if (not read.from_start() and odd(first + to) != odd(parity)) ++first;
                    if (not read.to_end() and odd(last + to) != odd(parity)) --last;
                    if (first <= last) s = hull(s, {-last, -first});
                }
            return s;
        };
        return reach{at(0), at(1)}.at<From>();
    }

    constexpr reach() = default;
    constexpr reach(span nodes, span others) : on_T(nodes), between(others) {}

private:
    template <class Base>
    static constexpr bool has_nodes = Base::last(2) != 1;
    template <class Base>
    static constexpr bool has_between = Base::last(2) != 2;

    static constexpr bool odd(int n) { return n % 2 != 0; }
    static constexpr int width(span s) { return s.is_empty() ? 0 : (s.last - s.first + 1) / 2; }
    static constexpr span hull(span a, span b) {
        if (a.is_empty()) return b;
        if (b.is_empty()) return a;
        return {std::min(a.first, b.first), std::max(a.last, b.last)};
    }
    static constexpr int added(int a, int b) {
        if (a == -unlimited or b == -unlimited) return -unlimited;
        return a == unlimited or b == unlimited ? unlimited : a + b;
    }
    /// The reach of b at the points of Middle that a reads at a point of the given parity; the two outermost ones at each end decide.
    template <class Middle>
    static constexpr span through(span a, int parity, reach b) {
        span s{};
        for (int k : {a.first, a.first + 1, a.last - 1, a.last}) {
            if (a.is_empty() or k < a.first or k > a.last) continue;
            for (bool const between : {false, true}) {
                bool const unlimited_end = (k <= -unlimited + 1) or (k >= unlimited - 1);
                if (not(between ? has_between<Middle> : has_nodes<Middle>) or (not unlimited_end and odd(k + parity) != between)) continue;
                span const read = between ? b.between : b.on_T;
                if (not read.is_empty()) s = hull(s, {added(k, read.first), added(k, read.last)});
            }
        }
        if (not s.is_empty() and a.from_start()) s.first = -unlimited;
        if (not s.is_empty() and a.to_end()) s.last = unlimited;
        return s;
    }
};

} // namespace hilger
