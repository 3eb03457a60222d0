// SPDX-License-Identifier: BSL-1.0
// The parts of a Lagrangian L = v.Mv/2 + a.v - U(q) with a constant mass: v = M^-1 (p - a), and dL/dq = -U'(q) whatever the velocity is.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "hilger/inlining.hpp"
#include "hilger/linear/elimination.hpp"
#include "hilger/linear/patterned_matrix.hpp"
#include "hilger/newton/stop.hpp"
#include "hilger/step/state.hpp"
#include "hilger/variational/nodes/gradients.hpp"
#include "hilger/variational/nodes/node_derivatives.hpp"

namespace hilger::detail {

/// For any Lagrangian: its jets tell whether it has these parts. They tell so for one branch only: a Lagrangian with branches has none.
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
    /// f = dL/dq at q. @returns false if L has other parts there
    HILGER_ALWAYS_INLINE bool force(Problem const& what, S const& t, V const& q, V& f) {
        if constexpr (has_forces)
            return forces(what, t, &q, &f, 1);
        else {
            std::uint64_t const compared = comparisons_made();
            dependence const on = gradients_at(what, t, q, at_rest_, f, unused_);
            return is_separable(on) and comparisons_made() == compared;
        }
    }
    /// The same at n positions, for a callable with a function for that.
    static constexpr bool has_forces = requires(Problem const& p, S const& t, V const* q, V* f) { p.lagrangian.forces(t, q, f, 1); };
    bool forces(Problem const& what, S const& t, V const* q, V* f, std::size_t n) {
        std::uint64_t const compared = comparisons_made();
        return is_separable(what.lagrangian.forces(t, q, f, n)) and comparisons_made() == compared;
    }

private:
    static bool is_separable(dependence on) { return not on.coupled and on.v <= 2; }
    HILGER_ALWAYS_INLINE void times_inverse(V const& f, V& v) const {
        if constexpr (s::is_scalar)
            v = inverse_ * f;
        else if (is_diagonal_)
            v = diagonal_.cwiseProduct(f);
        else
            v.noalias() = inverse_ * f;
    }
    template <class F>
    bool inspected(problem<F, no_force> const& what, state<S, V> const& x) {
        if constexpr (always_reads_time<F, S, V>)
            return false; // the mass might change with time
        else {
            if (reads_time_in<S, V>(what.lagrangian)) return false;
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
                diagonal_ = inverse_.diagonal();
                is_diagonal_ = inverse_.isDiagonal(S(0));
            }
            return true;
        }
    }
    template <class F, class Force>
    bool inspected(problem<F, Force> const&, state<S, V> const&) {
        return false;
    }
    block_of<V> inverse_;
    bool is_diagonal_ = false;
    V diagonal_; ///< of the inverse
    V at_rest_;  ///< a; also an arbitrary velocity
    V room_, unused_;
};

/// For a traced Lagrangian, which has these parts if its formula has no second derivatives by q and v, constant ones by v twice, no
/// branches and no time.
template <class S, class V>
class separable_formula {
    using s = shape<V>;

public:
    explicit separable_formula(V const& like) : at_rest_(zero_like(like)) {}
    bool inspect(given_problem<V> const& what, V const& q) {
        if (not is_known_) learn(what, q);
        return has_parts_;
    }
    template <class R>
    void velocity(R const& p, V& v) {
        solve(p - at_rest_, v);
    }
    /// M^-1 f, for f other than v.
    template <class F>
    void solve(F const& f, V& v) {
        if (is_diagonal_)
            v = inverse_.cwiseProduct(f);
        else {
            v = f;
            mass_.solve(v);
        }
    }
    /// f = dL/dq at q
    void force(given_problem<V> const& what, V const& q, V& f) {
        Eigen::Map<V>(node_.arguments(), q.size()) = q;
        (void)node_.evaluate_here(what, S(0), s::dimension(q), wanted::forces_only);
        node_.put_by_q(S(1), f);
    }

private:
    /// Traces the formula at v = 0, which remains its argument.
    void learn(given_problem<V> const& what, V const& q) {
        is_known_ = true;
        if (not what.is_traced or what.reads_time()) return;
        (void)node_.evaluate(what, S(0), q, zero_like(q), wanted::with_seconds);
        auto const& at = node_.places();
        if (node_.has_branches() or not at.entries[block_vq].empty() or not at.constant[block_vv]) return;
        for (int k = 0; k < s::dimension(q); ++k) at_rest_(k) = node_.by_v(k);
        has_parts_ = weigh(at.entries[block_vv], s::dimension(q));
    }
    /// Computes M^-1, or the factors of M. @returns false if M is singular
    template <class Entries>
    bool weigh(Entries const& entries, int d) {
        is_diagonal_ = std::all_of(entries.begin(), entries.end(), [](auto const& e) { return e.row == e.column; });
        if (is_diagonal_) {
            inverse_ = zero_like(at_rest_);
            for (auto const& e : entries) {
                if (node_.value(e.place) == S(0)) return false;
                inverse_(e.row) = S(1) / node_.value(e.place);
            }
            return static_cast<int>(entries.size()) == d;
        }
        std::vector<std::pair<int, int>> pattern;
        for (auto const& e : entries) pattern.emplace_back(e.row, e.column);
        mass_.prepare(d, pattern);
        mass_.set_zero();
        for (auto const& e : entries) mass_[mass_.place(e.row, e.column)] = node_.value(e.place);
        return mass_.factorize();
    }
    traced_node<V> node_;
    bool is_known_ = false, has_parts_ = false, is_diagonal_ = false;
    V at_rest_, inverse_; ///< a; M^-1 for a diagonal M
    patterned_matrix<S, shape<V>::size> mass_;
};
template <class F, class S, class V>
    requires(is_traced_at<problem<F, no_force>, V> and not is_mechanical<F>)
class separable<problem<F, no_force>, S, V> : public separable_formula<S, V> {
    using what_type = problem<F, no_force>;
    using formula = separable_formula<S, V>;

public:
    separable(what_type const&, V const& like) : formula(like) {}
    static constexpr bool has_forces = false;
    bool inspect(what_type const& what, state<S, V> const& x) { return formula::inspect(given<what_type, V>(what), x.q); }
    bool force(what_type const& what, S const&, V const& q, V& f) {
        formula::force(given<what_type, V>(what), q, f);
        return true;
    }
};

/// For mechanical systems of any size.
template <class Mass, class Potential, class S, class V>
class separable<problem<mechanical<Mass, Potential>, no_force>, S, V> {
    using what_type = problem<mechanical<Mass, Potential>, no_force>;

public:
    separable(what_type const& what, V const& like) : mass_(what.lagrangian.mass(), like.size()), room_(like.size() + 1) {
        what.lagrangian.potential().check(like.size());
    }
    static constexpr bool has_forces = false;
    bool inspect(what_type const&, state<S, V> const&) { return true; }
    template <class R>
    void velocity(R const& p, V& v) const {
        mass_.solve(p, v);
    }
    void solve(V const& f, V& v) const { mass_.solve(f, v); }
    bool force(what_type const& what, S const&, V const& q, V& f) {
        what.lagrangian.potential().gradient(q, f, room_);
        f = -f;
        return true;
    }

private:
    mass_solver<Mass, V> mass_;
    Eigen::Matrix<S, Eigen::Dynamic, 1> room_;
};

} // namespace hilger::detail
