// SPDX-License-Identifier: BSL-1.0
// The parts of a Lagrangian L = v.Mv/2 + a.v - U(q) with a constant mass: v = M^-1 (p - a), and dL/dq = -U'(q) whatever the velocity is.
#pragma once

#include "hilger/inlining.hpp"
#include "hilger/linear/elimination.hpp"
#include "hilger/newton/stop.hpp"
#include "hilger/step/mass_solver.hpp"
#include "hilger/step/state.hpp"
#include "hilger/variational/gradients.hpp"

namespace hilger::detail {

/// Of any Lagrangian: its jets say whether it has these parts. What they say of one branch does not hold on others, so that a Lagrangian
/// with branches has none.
template <class Problem, class S, class V>
class separable {
    using s = shape<V>;

public:
    separable(Problem const&, V const& like)
        : inverse_(s::zero_block(s::dimension(like))), at_rest_(s::zero(s::dimension(like))), room_(at_rest_), unused_(at_rest_) {}

    /// Whether L has these parts, as seen from x.
    bool inspect(Problem const& what, state<S, V> const& x) { return inspected(what, x); }
    template <class R>
    HILGER_ALWAYS_INLINE void velocity(R const& p, V& v) {
        room_ = p - at_rest_;
        times_inverse(room_, v);
    }
    /// M^-1 f, for f other than v.
    HILGER_ALWAYS_INLINE void solve(V const& f, V& v) const { times_inverse(f, v); }
    /// f = dL/dq at q. False where L turns out to have other parts there.
    HILGER_ALWAYS_INLINE bool force(Problem const& what, S const& t, V const& q, V& f) {
        std::uint64_t const compared = comparisons_made();
        dependence const on = gradients_at(what, t, q, at_rest_, f, unused_);
        return is_separable(on) and comparisons_made() == compared;
    }

private:
    static bool is_separable(dependence on) { return not on.coupled and on.v <= 2; }
    HILGER_ALWAYS_INLINE void times_inverse(V const& f, V& v) const {
        if constexpr (s::is_scalar)
            v = inverse_ * f;
        else
            v.noalias() = inverse_ * f;
    }
    template <class F>
    bool inspected(problem<F, no_force> const& what, state<S, V> const& x) {
        if constexpr (is_timed<F, no_force, S, V>)
            return false; // the mass might change with time
        else {
            branch_watch const watch;
            auto const e = hilger::expand(at_time{what.lagrangian, x.t}, x.q, zero_like(x.q));
            if (not is_separable(e.on) or watch.saw_any()) return false;
            at_rest_ = e.by_v;
            if constexpr (s::is_scalar) {
                if (e.vv == S(0)) return false;
                inverse_ = S(1) / e.vv;
            } else {
                inverse_ = e.vv;
                if (not invert(inverse_)) return false;
            }
            return true;
        }
    }
    template <class F, class Force>
    bool inspected(problem<F, Force> const&, state<S, V> const&) {
        return false;
    }
    block_of<V> inverse_;
    V at_rest_; ///< a; and a velocity as good as any
    V room_, unused_;
};

/// Of a system that says so, of any size.
template <class Mass, class Potential, class S, class V>
class separable<problem<mechanical<Mass, Potential>, no_force>, S, V> {
    using what_type = problem<mechanical<Mass, Potential>, no_force>;

public:
    separable(what_type const& what, V const& like) : mass_(what.lagrangian.mass(), like.size()), room_(like.size() + 1) {
        what.lagrangian.potential().check(like.size());
    }
    bool inspect(what_type const&, state<S, V> const&) { return true; }
    template <class R>
    void velocity(R const& p, V& v) const {
        mass_.solve(p, v);
    }
    void solve(V const& f, V& v) const { mass_.solve(f, v); }
    bool force(what_type const& what, S const&, V const& q, V& f) {
        tally<S>::add(work::force);
        what.lagrangian.potential().gradient(q, f, room_);
        f = -f;
        return true;
    }

private:
    mass_solver<Mass, V> mass_;
    Eigen::Matrix<S, Eigen::Dynamic, 1> room_;
};

} // namespace hilger::detail
