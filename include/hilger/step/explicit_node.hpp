// SPDX-License-Identifier: BSL-1.0
// The step whose equation has nothing to solve: one node at an end of the step, and an L = v.Mv/2 + a.v - U(q) whose formula says so.
// With w and b of the tableau, w b = 1, and f = dL/dq,
//   at q_i:      p_{i+1} = p_i + w f(q_i),                 q_{i+1} = q_i + w M^-1 (p_{i+1} - a);
//   at q_{i+1}:  q_{i+1} = q_i + w M^-1 (p_i - a),         p_{i+1} = p_i + w f(q_{i+1}),
// which is what p_i = -d_1 L_h and p_{i+1} = d_2 L_h are then (step/equation.hpp).
#pragma once

#include <optional>

#include "hilger/step/separable.hpp"
#include "hilger/step/tableau.hpp"

namespace hilger::detail {

/// What says itself that it is mechanical has a step of its own where there is one node.
template <class Problem, class V>
inline constexpr bool may_be_explicit = false;
template <class F, class V>
inline constexpr bool may_be_explicit<problem<F, no_force>, V> = is_traced_at<problem<F, no_force>, V> and not is_mechanical<F>;

struct no_explicit_node {
    template <class V>
    explicit no_explicit_node(V const&) {}
};

template <class Problem, class S, class V>
class explicit_node {
    enum class place { inside, start, end };

public:
    explicit explicit_node(V const& like) : v_(zero_like(like)) {}
    void prepare(tableau<S> const& t, bool reproduces_constants) {
        place_ = place::inside;
        if (not reproduces_constants or t.nodes != 1 or not(magnitude(S(t.w(0) * t.b(0, 1) - S(1))) <= S(4) * epsilon<S>())) return;
        place_ = t.a(0, 1) == S(0) ? place::start : t.a(0, 0) == S(0) ? place::end : place::inside;
        w_ = t.w(0);
    }
    /// moved = q_{i+1} - q_i and gained = p_{i+1} - p_i, from x. False where the equation is to be solved, and nothing is done.
    template <class Gained>
    bool steps(Problem const& what, state<S, V> const& x, V& moved, Gained& gained) {
        if (place_ == place::inside) return false;
        if (not parts_) parts_.emplace(what, x.q);
        if (not parts_->inspect(what, x)) return false;
        auto& of = *parts_;
        if (place_ == place::start) {
            bool const diagonal = of.is_diagonal(); // then in one loop: reading as vectors what was just written one by one takes longer
            of.force(what, x.q, [&](int c, S const& f) {
                S const more = w_ * f;
                gained(c) = more;
                if (diagonal) moved(c) = w_ * of.velocity(c, x.p(c) + more);
            });
            if (diagonal) return true;
            of.velocity(x.p + gained, v_);
            moved = w_ * v_;
        } else {
            of.velocity(x.p, v_);
            moved = w_ * v_;
            v_ = x.q + moved;
            of.force(what, v_, [&](int c, S const& f) { gained(c) = w_ * f; });
        }
        return true;
    }

private:
    std::optional<separable<Problem, S, V>> parts_;
    place place_ = place::inside;
    S w_{0};
    V v_; ///< room
};

} // namespace hilger::detail
