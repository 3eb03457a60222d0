// SPDX-License-Identifier: BSL-1.0
// The step whose equation needs no iteration: one node at an end of the step, a formula L = v.Mv/2 + a.v - U(q), and possibly a force f(q,
// v). With w and b of the tableau, w b = 1, and F = dL/dq + f,
//   at q_i, for f affine in v:  (M - w df/dv) v = p_i - a + w F(q_i, 0),   q_{i+1} = q_i + w v,   p_{i+1} = p_i + w F(q_i, v);
//   at q_{i+1}:                 M v = p_i - a,                             q_{i+1} = q_i + w v,   p_{i+1} = p_i + w F(q_{i+1}, v),
// which are p_i = -d_1 L_h and p_{i+1} = d_2 L_h in this case (step/equation.hpp).
#pragma once

#include "hilger/linear/patterned_matrix.hpp"
#include "hilger/step/separable.hpp"
#include "hilger/step/tableau.hpp"

namespace hilger::detail {

struct no_explicit_node {
    template <class V>
    explicit no_explicit_node(V const&) {}
};

template <class S, class V>
class explicit_node {
    enum class place { inside, start, end };

public:
    explicit explicit_node(V const& like) : parts_(like), v_(zero_like(like)) {}
    void prepare(tableau<S> const& t, bool reproduces_constants) {
        place_ = place::inside;
        if (not reproduces_constants or t.nodes != 1 or not(magnitude(S(t.w(0) * t.b(0, 1) - S(1))) <= S(4) * epsilon<S>())) return;
        place_ = t.a(0, 1) == S(0) ? place::start : t.a(0, 0) == S(0) ? place::end : place::inside;
        w_ = t.w(0);
        resisted_ = {};
    }
    /// Sets moved = q_{i+1} - q_i and gained = p_{i+1} - p_i from x. @returns false, with neither valid, if the equation has to be solved
    template <class Gained>
    bool steps(given_problem<V> const& what, state<S, V> const& x, V& moved, Gained& gained) {
        if (place_ == place::inside) return false;
        if (not parts_.inspect(what, x.q)) return false;
        if (place_ == place::end) {
            parts_.way(x.p, w_, v_, moved);
            parts_.force(what, x.q + moved, v_, w_, gained);
            return true;
        }
        if (parts_.reads_velocity()) return steps_with_friction(what, x, moved, gained);
        if (shape<V>::size != Eigen::Dynamic and parts_.is_diagonal()) {
            // Short vectors in one loop: a vector load right after scalar stores would stall.
            parts_.force(what, x.q, [&](int c, S const& f) {
                S const more = w_ * f;
                gained(c) = more;
                moved(c) = w_ * parts_.velocity(c, x.p(c) + more);
            });
            return true;
        }
        parts_.force(what, x.q, w_, gained);
        parts_.way(x.p + gained, w_, v_, moved);
        return true;
    }

private:
    /// From q_i, with a force that depends on the velocity.
    template <class Gained>
    bool steps_with_friction(given_problem<V> const& what, state<S, V> const& x, V& moved, Gained& gained) {
        if (not parts_.has_constant_friction()) return false;
        if (not resisted_.is_factorized() and not parts_.factorize(resisted_, S(-w_))) return false;
        parts_.force(what, x.q, w_, gained);
        v_ = x.p + gained - parts_.at_rest();
        resisted_.solve(v_);
        moved = w_ * v_;
        for (auto const& e : parts_.frictions()) gained(e.row) = gained(e.row) + parts_.value(e) * moved(e.column);
        return true;
    }
    separable_formula<S, V> parts_;
    place place_ = place::inside;
    S w_{0};
    patterned_matrix<S, shape<V>::size> resisted_; ///< M - w df/dv
    V v_;                                          ///< workspace
};

} // namespace hilger::detail
