// SPDX-License-Identifier: BSL-1.0
// Two-sided problems of the fractional embedding: x in C(T) with x(t_0) and x(t_N) given that solves (EL_h^alpha) of Bourdin, Cresson,
// Greff, Inizan (2013),  F_k + (A^T p)_k = 0 for k = 1..N-1,  F = dL/dx, p = dL/dv, v = A Q, A = Delta_-^alpha. A is a triangle whose
// inverse is known, the Toeplitz matrix of h^alpha omega(z)^-alpha, omega(z) = 1 - z there. Multiplied by its transpose, with a multiplier
// for the row N, which is no equation, the problem is
//   p(Q, v) + A^-T F(Q, v) = lambda g,  Q = A^-1 v,  Q_N = x(t_N);  g = A^-T e_N,  g_k = h^alpha beta_{N-k},
// an integral equation of the second kind for v. For L = v.M v / 2 its solution is v = c g, one convolution. In general the derivative,
// divided by dL/dv dv, is a compact perturbation of the identity, and takes two convolutions to apply. For L = v^2 / 2 and alpha <= 1/2 the
// continuous problem has no solution: the functional does not depend on values at points. Each of the discrete problems has one, and their
// solutions tend to the free one, away from t_N, as h^(1 - 2 alpha).
#pragma once

#include "hilger/boundary/convolved.hpp"
#include "hilger/linear/elimination.hpp"
#include "hilger/newton/krylov.hpp"
#include "hilger/newton/stop.hpp"

namespace hilger::detail {

/// The integral equation, its derivative, and the solution for L = v.M v / 2.
template <class Action, class V>
class boundary_equation;
template <class F, generating_function G, class Order, class Root, class V>
class boundary_equation<fractional_action<F, G, Order, Root>, V> {
    using action_type = fractional_action<F, G, Order, Root>;
    using S = scalar_of<V>;
    using s = shape<V>;

public:
    using values = std::vector<V>; ///< one for each of t_1 ... t_N

    /// An iterate, the derivatives there, and -P(p + A^-T F), the correction if nothing depended on the position.
    struct point {
        values v, q;
        std::vector<expansion<V>> at{};
        branch_path path{};   ///< the branches of L taken
        bool coupled = false; ///< some second derivative by the position is not zero
        block_of<V> stiffness{};
        values forces{}; ///< -(p + A^-T F)
        values rest{};
        S merit{0};
    };

    boundary_equation(action_type const& action, V const& first, V const& last)
        : L_(action.function), T_(action.T), first_(first), last_(last), count_(static_cast<std::size_t>(T_.steps())),
          scale_(S(1) / leading_factor<G>(T_, action.velocity.order)),
          beta_(first_weights<G>(S(-action.velocity.order.template as<S>()), T_.steps() + 1)),
          inverse_(std::vector<S>(beta_.begin(), beta_.end() - 1)) {}

    /// One value for each point of T, with the given ones at the ends.
    [[nodiscard]] values whole(point const& at) const {
        values all{first_};
        all.insert(all.end(), at.q.begin(), at.q.end());
        all.back() = last_;
        return all;
    }
    static bool all_finite(values const& x) {
        for (auto const& value : x)
            if (not detail::all_finite(value)) return false;
        return true;
    }
    /// The solution for L = v.M v / 2, whatever M: v = c g.
    [[nodiscard]] point start() const {
        std::vector<S> reversed(beta_.rbegin() + 1, beta_.rend());
        auto const u = inverse_(reversed);
        V const c = (last_ - beta_.back() * first_) / u.back();
        point at{values(count_, c), values(count_, c)};
        for (std::size_t i = 0; i < count_; ++i) {
            at.v[i] = c * S(reversed[i] / scale_);
            at.q[i] = beta_[i + 1] * first_ + u[i] * c;
        }
        return at;
    }
    /// Changes the equation to that of (1 - s) v.M v / 2 + s L, whose solution is start() for s = 0, with the M of L at its first point
    /// `at` start().
    void set_mass(point const& at) { mass_ = expand(at_time{L_, T_.element(1)}, at.q[0], at.v[0]).vv; }
    void set_share(S const& share) { share_ = share; }
    /// Computes the positions of `next`. Its velocities are corrected along g, with the derivatives at `at`, so that the condition at t_N
    /// holds in spite of rounding times the condition number.
    void place(point const& at, point& next) const {
        next.q = position(next.v);
        V const missing = last_ - next.q.back();
        if (magnitude(missing) == S(0)) return;
        V const back = at.stiffness * missing;
        for (std::size_t i = 0; i < count_; ++i) next.v[i] = next.v[i] + at.at[i].vv * V(g(i) * back);
        next.q = position(next.v);
    }
    /// Everything at (v, q); at.at[i].vv becomes its own inverse.
    void evaluate(point& at) const {
        branch_watch const watch;
        at.at.clear();
        at.at.reserve(count_);
        values force;
        bool forced = false, finite = true;
        at.coupled = false;
        for (std::size_t i = 0; i < count_; ++i) {
            S const t = T_.element(static_cast<index_type>(i) + 1);
            at.at.push_back(expand(at_time{L_, t}, at.q[i], at.v[i]));
            auto& e = at.at.back();
            if (not(share_ == S(1))) take_share(e, at.v[i]);
            force.push_back(e.by_q); // that of row N, which is no equation, is a multiple of g, absorbed by lambda
            forced = forced or magnitude(force.back()) != S(0);
            at.coupled = at.coupled or largest_entry(e.qq) != S(0) or largest_entry(e.qv) != S(0);
            finite =
                finite and detail::all_finite(e.by_q) and detail::all_finite(e.by_v) and largest_entry(e.vv) - largest_entry(e.vv) == S(0);
        }
        at.path = watch.path();
        at.rest.assign(count_, zero_like(first_));
        if (not finite) {
            at.rest[0] = at.at[0].by_v / S(0);
            return;
        }
        if (forced) at.rest = integrated_back(force);
        for (std::size_t i = 0; i < count_; ++i) {
            at.rest[i] = -(at.rest[i] + at.at[i].by_v);
            at.at[i].vv = inverted(at.at[i].vv);
        }
        at.stiffness = inverted(pairwise_sum(0, count_, [&](std::size_t i) { return block_of<V>(S(g(i) * g(i)) * at.at[i].vv); }));
        at.forces = at.rest;
        at.rest = projected(at, std::move(at.rest));
        at.merit = euclidean_norm(at.rest);
    }
    /// The derivative of P(p + A^-T F) = y + P C y by v in the direction y.
    [[nodiscard]] values derivative(point const& at, values const& y) const {
        values const q = integrated(y);
        values force = y, c = y;
        for (std::size_t i = 0; i < count_; ++i) {
            auto const& e = at.at[i];
            if constexpr (s::is_scalar)
                c[i] = e.qv * q[i];
            else
                c[i] = e.qv.transpose() * q[i];
            force[i] = e.qq * q[i] + e.qv * y[i];
        }
        force = integrated_back(force);
        for (std::size_t i = 0; i < count_; ++i) c[i] = c[i] + force[i];
        c = projected(at, std::move(c));
        for (std::size_t i = 0; i < count_; ++i) c[i] = c[i] + y[i];
        return c;
    }
    /// The size of the rest at a later point, measured as at the earlier one: a norm that changed with the point would not be monotone.
    [[nodiscard]] S natural(point const& earlier, point const& later) const { return euclidean_norm(projected(earlier, later.forces)); }

private:
    void take_share(expansion<V>& e, V const& v) const {
        S const rest = S(1) - share_;
        e.by_q = share_ * e.by_q;
        e.by_v = share_ * e.by_v + rest * V(mass_ * v);
        e.qq = share_ * e.qq;
        e.qv = share_ * e.qv;
        e.vv = share_ * e.vv + rest * mass_;
    }
    [[nodiscard]] S g(std::size_t i) const { return scale_ * beta_[count_ - 1 - i]; }
    [[nodiscard]] values position(values const& v) const {
        values q = integrated(v);
        for (std::size_t i = 0; i < count_; ++i) q[i] = q[i] + beta_[i + 1] * first_;
        return q;
    }
    [[nodiscard]] values integrated(values const& v) const { return apply_triangle(inverse_, v, scale_, direction::forward); }
    [[nodiscard]] values integrated_back(values const& p) const { return apply_triangle(inverse_, p, scale_, direction::backward); }
    template <class Block>
    static S largest_entry(Block const& b) {
        if constexpr (s::is_scalar)
            return S(magnitude(b));
        else
            return S(b.cwiseAbs().maxCoeff());
    }
    static block_of<V> inverted(block_of<V> const& H) {
        char const* const what = "a boundary value problem";
        if constexpr (s::is_scalar) {
            if (H == S(0)) refuse_singular(what);
            return S(1) / H;
        } else {
            block_of<V> inverse = H;
            if (not invert(inverse)) refuse_singular(what);
            return inverse;
        }
    }
    /// P r = H^-1 (r + g lambda) with lambda such that the position at t_N does not move.
    [[nodiscard]] values projected(point const& at, values r) const {
        for (std::size_t i = 0; i < count_; ++i) r[i] = at.at[i].vv * r[i];
        V const lambda = -(at.stiffness * pairwise_sum(0, count_, [&](std::size_t i) { return V(g(i) * r[i]); }));
        for (std::size_t i = 0; i < count_; ++i) r[i] = r[i] + at.at[i].vv * V(g(i) * lambda);
        return r;
    }
    F const& L_;
    Root const& T_;
    V first_, last_;
    std::size_t count_;
    S scale_; ///< h^alpha omega(0)^-alpha
    std::vector<S> beta_;
    toeplitz_triangle<S> inverse_;
    S share_{1};
    block_of<V> mass_{};
};

} // namespace hilger::detail
