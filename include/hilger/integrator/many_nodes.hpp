// SPDX-License-Identifier: BSL-1.0
// The step of any embedding, given by its tableau: control values U_0 = q_i, U_1, ..., U_s with
//   p_i + sum_k w_k (a_k0 dL/dq + b_k0 dL/dv)(A_k, B_k) = 0,   sum_k w_k (a_kj dL/dq + b_kj dL/dv)(A_k, B_k) = 0 for 0 < j < s,
// and then q_{i+1} = U_s, p_{i+1} = sum_k w_k (a_ks dL/dq + b_ks dL/dv). With s = 1 that is p_i = -d_1 L_h, p_{i+1} = d_2 L_h; with s > 1
// the inner control values make L_h stationary (Marsden-West; Cresson-Safi, section 5). Solved by Newton with dense factorizations.
#pragma once

#include <optional>

#include <Eigen/LU>

#include "hilger/integrator/state.hpp"
#include "hilger/integrator/summation.hpp"
#include "hilger/integrator/tableau.hpp"
#include "hilger/mechanics/newton_stop.hpp"
#include "hilger/mechanics/problem.hpp"

namespace hilger::detail {

/// Unknown control values: s of them, of dimension d each. Their number is a run-time one: this code is compiled once for all embeddings.
template <class Problem, bool Compensated, class S, class V>
class many_nodes {
    using s = shape<V>;
    using vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;
    using matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;

public:
    many_nodes(tableau<S> const& t, S const& h, V const& like)
        : d_(s::dimension(like)), controls_(t.controls), U_(static_cast<std::size_t>(controls_), s::zero(d_)), last_(U_),
          r_(vector::Zero((controls_ - 1) * d_)), correction_(r_), J_(matrix::Zero(r_.size(), r_.size())), lu_(r_.size()), sum_q_(d_),
          sum_p_(d_) {
        prepare(t, h);
    }
    void prepare(tableau<S> const& t, S const& h) {
        t_ = t;
        h_ = h;
        steps_ = 0;
        constants_ = reproduces_constants();
        nodes_.assign(
            static_cast<std::size_t>(t.nodes),
            node_table<V>{{s::zero(d_), s::zero(d_), s::zero_block(d_), s::zero_block(d_), s::zero_block(d_), {}}, s::zero_block(d_)});
    }
    [[nodiscard]] S const& h() const { return h_; }
    void guess(V const& v) { velocity_ = v; }
    [[nodiscard]] bool needs_guess() const { return not velocity_; }
    /// Everything that later steps depend on and h does not determine, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        each("steps", steps_);
        int known = velocity_ ? 1 : 0;
        each("known", known);
        if (known == 0) velocity_.reset();
        if (known != 0 and not velocity_) velocity_ = s::zero(d_);
        for (int c = 0; velocity_ and c < d_; ++c) each("velocity", s::component(*velocity_, c));
        for (V& x : last_)
            for (int c = 0; c < d_; ++c) each("control", s::component(x, c));
        sum_q_.visit(each);
        sum_p_.visit(each);
    }

    void advance(Problem const& problem, state<S, V>& x) {
        // Control values move along the last step's shape, or along the velocity where there is none.
        for (int j = 1; j < controls_; ++j) {
            V const moved = steps_ > 0 ? V(last_[at(j)]) : V(*velocity_ * S(t_.fraction_of_step[at(j)] * h_));
            U_[at(j)] = x.q + moved;
        }
        bool singular = false;
        S size(0);
        S const small = square_root_of_epsilon<S>() / S(Compensated ? 1024 : 4);
        for (int iteration = 0; iteration < most_iterations<S>; ++iteration) {
            assemble(problem, x);
            for (int k = 0; k < r_.size(); ++k)
                if (not is_finite(r_(k))) give_up(name, false, x.q, value_of_nan(x.q, r_(k)), size);
            lu_.compute(J_);
            singular = not is_regular(lu_);
            if (singular) break;
            correction_ = lu_.solve(r_);
            S reach(0);
            for (int j = 1; j < controls_; ++j) {
                for (int c = 0; c < d_; ++c) s::component(U_[at(j)], c) = s::component(U_[at(j)], c) - correction_((j - 1) * d_ + c);
                reach = std::max(reach, S(magnitude(V(U_[at(j)] - x.q))));
            }
            size = magnitude(correction_);
            bool const floor = iteration > 0 and magnitude(r_) <= S(8) * epsilon<S>() * (magnitude(x.p) + forces());
            if (not(size <= small * reach) and not floor) continue;
            finish(x);
            return;
        }
        give_up(name, singular, V(U_.back()), residual_of_start(), size);
    }

private:
    static constexpr char const* name = "the step p = -d_1 L_h(q, y)";
    static constexpr std::size_t at(int j) { return static_cast<std::size_t>(j); }
    /// The rows of the residual that belong to p_i.
    [[nodiscard]] V residual_of_start() const {
        V r = s::zero(d_);
        for (int c = 0; c < d_; ++c) s::component(r, c) = r_(c);
        return r;
    }
    static V value_of_nan(V x, S const& bad) {
        s::component(x, 0) = bad;
        return x;
    }
    /// A sum of control values with the coefficients of node k.
    template <class Coefficient>
    V combined(Coefficient const& coefficient, V const& start) const {
        V sum = start * coefficient(0);
        for (int j = 1; j < controls_; ++j) sum = sum + U_[at(j)] * coefficient(j);
        return sum;
    }
    void assemble(Problem const& problem, state<S, V> const& x) {
        for (int c = 0; c < r_.size(); ++c) r_(c) = c < d_ ? s::component(x.p, c) : S(0);
        J_.setZero();
        for (int k = 0; k < t_.nodes; ++k) {
            V const A = combined([&](int j) -> S const& { return t_.a(k, j); }, x.q);
            V const B = combined([&](int j) -> S const& { return t_.b(k, j); }, x.q);
            auto& e = nodes_[at(k)];
            e = expand_at(problem, t_.time(k, x.t, h_), A, B);
            for (int j = 0; j + 1 < controls_; ++j) {
                S const wa = t_.w(k) * t_.a(k, j), wb = t_.w(k) * t_.b(k, j);
                for (int c = 0; c < d_; ++c) {
                    r_(j * d_ + c) = r_(j * d_ + c) + wa * s::component(e.e.by_q, c) + wb * s::component(e.e.by_v, c);
                    for (int l = 1; l < controls_; ++l) {
                        S const& a = t_.a(k, l);
                        S const& b = t_.b(k, l);
                        for (int f = 0; f < d_; ++f) {
                            S& to = J_(j * d_ + c, (l - 1) * d_ + f);
                            to = to + wa * (s::entry(e.e.qq, c, f) * a + s::entry(e.e.qv, c, f) * b) +
                                 wb * (s::entry(e.vq_, c, f) * a + s::entry(e.e.vv, c, f) * b);
                        }
                    }
                }
            }
        }
    }
    /// sum_j a_kj = 1 and sum_j b_kj = 0 at every node, to rounding.
    [[nodiscard]] bool reproduces_constants() const {
        S const rounding = S(64) * epsilon<S>();
        for (int k = 0; k < t_.nodes; ++k) {
            S sum_a(0), sum_b(0), size_b(0);
            for (int j = 0; j < controls_; ++j) {
                sum_a = sum_a + t_.a(k, j);
                sum_b = sum_b + t_.b(k, j);
                size_b = size_b + magnitude(t_.b(k, j));
            }
            if (not(magnitude(S(sum_a - S(1))) <= rounding) or not(magnitude(sum_b) <= rounding * size_b)) return false;
        }
        return true;
    }
    [[nodiscard]] S forces() const {
        S sum(0);
        for (int k = 0; k < t_.nodes; ++k)
            sum = sum + magnitude(t_.w(k)) * magnitude(nodes_[at(k)].e.by_q) + magnitude(nodes_[at(k)].e.by_v);
        return sum;
    }
    /// The last correction is applied to the gradients to first order. As sum_j a_kj = 1 and sum_j b_kj = 0 the equations add up to
    /// p_{i+1} = p_i + sum_k w_k dL/dq, which rounds better than the definition; embeddings that do not reproduce constants use the latter.
    void finish(state<S, V>& x) {
        V increment = s::zero(d_);
        V whole = s::zero(d_);
        for (int k = 0; k < t_.nodes; ++k) {
            auto const& e = nodes_[at(k)];
            for (int c = 0; c < d_; ++c) {
                S g = s::component(e.e.by_q, c), m = s::component(e.e.by_v, c);
                for (int l = 1; l < controls_; ++l)
                    for (int f = 0; f < d_; ++f) {
                        S const da = t_.a(k, l) * correction_((l - 1) * d_ + f), db = t_.b(k, l) * correction_((l - 1) * d_ + f);
                        g = g - (s::entry(e.e.qq, c, f) * da + s::entry(e.e.qv, c, f) * db);
                        m = m - (s::entry(e.vq_, c, f) * da + s::entry(e.e.vv, c, f) * db);
                    }
                s::component(increment, c) = s::component(increment, c) + t_.w(k) * g;
                s::component(whole, c) = s::component(whole, c) + t_.w(k) * (t_.a(k, controls_ - 1) * g + t_.b(k, controls_ - 1) * m);
            }
        }
        for (int j = 1; j < controls_; ++j) last_[at(j)] = U_[at(j)] - x.q;
        if (not all_finite(U_.back()) or not all_finite(whole)) give_up(name, false, x.q, value_of_nan(x.q, S(whole_sum(whole))), S(0));
        for (int c = 0; c < d_; ++c) {
            sum_q_.add(s::component(x.q, c), s::component(last_.back(), c), c);
            if (constants_)
                sum_p_.add(s::component(x.p, c), s::component(increment, c), c);
            else
                s::component(x.p, c) = s::component(whole, c);
        }
        x.t = x.t + h_;
        ++steps_;
    }
    static S whole_sum(V const& x) {
        S sum(0);
        for (int c = 0; c < s::dimension(x); ++c) sum = sum + s::component(x, c);
        return sum;
    }

    int d_;
    int controls_;
    tableau<S> t_;
    S h_{0};
    long long steps_ = 0;
    bool constants_ = true;
    std::optional<V> velocity_;
    std::vector<V> U_, last_;
    std::vector<node_table<V>> nodes_;
    vector r_, correction_;
    matrix J_;
    Eigen::PartialPivLU<matrix> lu_;
    [[no_unique_address]] summation<Compensated, S, s::size> sum_q_;
    [[no_unique_address]] summation<Compensated, S, s::size> sum_p_;
};

} // namespace hilger::detail
