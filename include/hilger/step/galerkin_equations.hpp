// SPDX-License-Identifier: BSL-1.0
// The equations of a Galerkin step (step/galerkin_table.hpp) of any Lagrangian, for the velocities V_j:
//   r_j = p_0 + h sum_k momentum_jk dL/dq(A_k, B_k) - 1/gamma_j sum_k w_k beta_kj dL/dv(A_k, B_k) = 0.
// By iteration V_j += M_j^-1 r_j with M_j the derivative of the last sum by V_j alone, which costs first derivatives and gains a factor of
// the size of h a round; where that is too little, or numbers are exact, by Newton with dense factorizations.
#pragma once

#include <Eigen/LU>

#include "hilger/inlining.hpp"
#include "hilger/linear/elimination.hpp"
#include "hilger/newton/contraction.hpp"
#include "hilger/newton/on_branches.hpp"
#include "hilger/newton/stop.hpp"
#include "hilger/step/force.hpp"
#include "hilger/step/galerkin_table.hpp"
#include "hilger/step/state.hpp"
#include "hilger/variational/gradients.hpp"
#include "hilger/variational/node_derivatives.hpp"

namespace hilger::detail {

/// to = sum_j c_j x_j
template <class V, class Row, class List>
HILGER_ALWAYS_INLINE inline void combine(Row const& c, List const& x, V& to) {
    if constexpr (shape<V>::size == Eigen::Dynamic) {
        to = x[0] * c[0];
        for (std::size_t j = 1; j < x.size(); ++j) to += x[j] * c[j];
    } else { // in registers
        V sum = x[0] * c[0];
        for (std::size_t j = 1; j < x.size(); ++j) sum = sum + x[j] * c[j];
        to = sum;
    }
}

template <class Problem, class Table, class S, class V, class Extra = no_step_force>
class galerkin_equations {
    using s = shape<V>;
    static constexpr std::size_t N = Table::N, R = Table::R;
    using vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;
    using matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;

public:
    explicit galerkin_equations(V const& like, Extra extra_force = {})
        : extra(std::move(extra_force)), d_(s::dimension(like)), zero_(s::zero(d_)), room_(zero_) {
        velocity.fill(zero_);
        force.fill(zero_);
        D_.fill(zero_);
        B_.fill(zero_);
        m_.fill(zero_);
    }
    Extra extra;               ///< beside dL/dq at every node
    std::array<V, R> velocity; ///< the unknown
    std::array<V, N> force;    ///< dL/dq at the nodes, of the velocities that solve the equations

    /// False where it converges too slowly to be worth it.
    bool iterate(Problem const& what, state<S, V> const& x, S const& h, S const& small) {
        if (not invert_masses(what, x, h)) return false;
        V const start = times(0, x.p);
        S reach = magnitude(start);
        for (V const& v : velocity) reach = std::max(reach, S(magnitude(v)));
        contraction<S> convergence(epsilon<S>() * reach, small);
        branch_watch const watch;
        for (;;) {
            place(h);
            evaluate(what, x, h);
            S size(0);
            for (std::size_t j = 0; j < R; ++j) {
                residual(x, h, j);
                room_ = times(j, room_);
                velocity[j] = velocity[j] + room_;
                size = std::max(size, S(magnitude(room_)));
            }
            switch (convergence.after(size)) {
            case progress::going:
                break;
            case progress::lost:
                return false;
            case progress::done:
                evaluate_at_last(what, x, h);
                return not(has_force<Problem> or watch.saw_any()) or convergence.is_rounding(last_correction(x, h));
            }
        }
    }
    /// @throws newton_failure, with error::no_branch where an L with branches has no solution; error::singular, error::not_finite
    void newton(Problem const& what, state<S, V> const& x, S const& h, S const& small) {
        prepare_newton();
        bool singular = false;
        S size(0);
        branch_watch const watch;
        for (int round = 0; round < most_iterations<S>; ++round) {
            S const forces = assemble(what, x, h);
            if (watch.saw_any()) {
                search(what, x, h, small);
                return;
            }
            for (work const each : {work::newton_round, work::factorization, work::solve}) tally<S>::add(each);
            for (int k = 0; k < r_.size(); ++k)
                if (not is_finite(r_(k))) give_up(name, false, x.q, constant(r_(k)), size);
            lu_.compute(J_);
            singular = not is_regular(lu_);
            if (singular) break;
            correction_ = lu_.solve(r_);
            S reach(0);
            for (std::size_t j = 0; j < R; ++j) {
                for (int c = 0; c < d_; ++c) s::component(velocity[j], c) = s::component(velocity[j], c) + correction_(row(j, c));
                reach = std::max(reach, S(magnitude(velocity[j])));
            }
            size = magnitude(correction_);
            bool const floor = round > 0 and magnitude(r_) <= S(8) * epsilon<S>() * (magnitude(x.p) + forces);
            if (not(size <= square_root_of_epsilon<S>() * small * reach) and not floor) continue;
            evaluate_at_last(what, x, h);
            return;
        }
        room_ = x.q;
        for (std::size_t j = 0; j < R; ++j) room_ = room_ + velocity[j] * S(h * table().gamma[j]);
        V rest = zero_;
        for (int c = 0; c < d_; ++c) s::component(rest, c) = r_(c);
        give_up(name, singular, room_, rest, size);
    }

    static constexpr char const* name = "the step p = -d_1 L_h(q, y)";

private:
    /// The same for an L with branches.
    void search(Problem const& what, state<S, V> const& x, S const& h, S const& small) {
        vector y(r_.size()), rest = r_;
        for (std::size_t j = 0; j < R; ++j)
            for (int c = 0; c < d_; ++c) y(row(j, c)) = s::component(velocity[j], c);
        auto const evaluate_at = [&](vector const& v, vector& r) {
            for (std::size_t j = 0; j < R; ++j)
                for (int c = 0; c < d_; ++c) s::component(velocity[j], c) = v(row(j, c));
            S const forces = assemble(what, x, h);
            r = r_;
            return S(magnitude(x.p) + forces + S(static_cast<int>(r_.size())) * magnitude(J_) * magnitude(v) +
                     S(d_) * bends_ * (magnitude(x.q) + magnitude(h) * magnitude(v)));
        };
        auto const correct = [&](vector const& r, vector& d) {
            for (work const each : {work::newton_round, work::factorization, work::solve}) tally<S>::add(each);
            lu_.compute(J_);
            if (not is_regular(lu_)) return false;
            d = lu_.solve(r);
            return true;
        };
        branch_search const how = search_branches(y, rest, evaluate_at, correct, S(square_root_of_epsilon<S>() * small));
        if (how != branch_search::found) {
            V residual = zero_;
            for (int c = 0; c < d_; ++c) s::component(residual, c) = rest(c);
            give_up_on_branches(name, how, V(x.q + velocity[0] * h), residual);
        }
        evaluate_at_last(what, x, h);
    }
    /// The correction that would be next.
    S last_correction(state<S, V> const& x, S const& h) {
        S size(0);
        for (std::size_t j = 0; j < R; ++j) {
            residual(x, h, j);
            size = std::max(size, S(magnitude(times(j, room_))));
        }
        return size;
    }
    static Table const& table() { return Table::here(); }
    [[nodiscard]] int row(std::size_t j, int c) const { return static_cast<int>(j) * d_ + c; }
    [[nodiscard]] S time(state<S, V> const& x, S const& h, std::size_t k) const { return x.t + table().node[k] * h; }
    [[nodiscard]] V constant(S const& y) const {
        V v = zero_;
        for (int c = 0; c < d_; ++c) s::component(v, c) = y;
        return v;
    }
    [[nodiscard]] V times(std::size_t j, V const& r) const { return V(inverse_[j] * r); }

    /// A_k - q_0 and B_k
    void place(S const& h) {
        Table const& T = table();
        for (std::size_t k = 0; k < N; ++k) {
            combine(T.alpha[k], velocity, D_[k]);
            D_[k] = D_[k] * h;
            if constexpr (not Table::collocated) combine(T.beta[k], velocity, B_[k]);
        }
    }
    [[nodiscard]] V const& at_node(std::size_t k) const {
        if constexpr (Table::collocated)
            return velocity[k];
        else
            return B_[k];
    }
    // Flattened for the processor's own numbers, as flat_jets_of is and for its reasons.
    void evaluate(Problem const& what, state<S, V> const& x, S const& h) {
        if constexpr (std::is_floating_point_v<S> and not is_traced_state<V>)
            flat_evaluate(what, x, h);
        else
            evaluate_all(what, x, h);
    }
    HILGER_FLATTEN void flat_evaluate(Problem const& what, state<S, V> const& x, S const& h) { evaluate_all(what, x, h); }
    HILGER_ALWAYS_INLINE void evaluate_all(Problem const& what, state<S, V> const& x, S const& h) {
        for (std::size_t k = 0; k < N; ++k) {
            V const A = x.q + D_[k];
            if constexpr (is_traced_state<V>) {
                (void)derivatives_[k].compute(what, time(x, h, k), A, at_node(k), derivatives_[k].first_order);
                for (int c = 0; c < d_; ++c) {
                    s::component(force[k], c) = derivatives_[k].by_q(c);
                    s::component(m_[k], c) = derivatives_[k].by_v(c);
                }
            } else
                gradients_at(what, time(x, h, k), A, at_node(k), force[k], m_[k]);
        }
        if constexpr (has_step_force<Extra>) {
            put_extra(h);
            for (V& f : force) f = f + room_;
        }
    }
    /// The extra force, into room_.
    void put_extra(S const& h) {
        combine(table().gamma, velocity, room_);
        for (int c = 0; c < d_; ++c) s::component(room_, c) = extra.at(S(h * s::component(room_, c)), c);
    }
    void evaluate_at_last(Problem const& what, state<S, V> const& x, S const& h) {
        place(h);
        evaluate(what, x, h);
    }
    /// r_j, into room_.
    void residual(state<S, V> const& x, S const& h, std::size_t j) {
        Table const& T = table();
        combine(T.momentum[j], force, room_);
        room_ = x.p + room_ * h;
        if constexpr (Table::collocated)
            room_ = room_ - m_[j];
        else
            for (std::size_t k = 0; k < N; ++k) room_ = room_ - m_[k] * S(T.weight[k] * T.beta[k][j] / T.gamma[j]);
    }
    /// M_j = 1/gamma_j sum_k w_k beta_kj^2 d2L/dv2
    bool invert_masses(Problem const& what, state<S, V> const& x, S const& h) {
        Table const& T = table();
        inverse_.fill(s::zero_block(d_));
        place(h);
        for (std::size_t k = 0; k < N; ++k) {
            auto const e = hilger::expand(at_time{what.lagrangian, time(x, h, k)}, V(x.q + D_[k]), at_node(k));
            for (std::size_t j = 0; j < R; ++j) {
                if (Table::collocated and j != k) continue;
                inverse_[j] = inverse_[j] + e.vv * S(T.weight[k] * T.beta[k][j] * T.beta[k][j] / T.gamma[j]);
            }
        }
        for (auto& M : inverse_)
            if constexpr (s::is_scalar) {
                if (M == S(0)) return false;
                M = S(1) / M;
            } else {
                if (not invert(M)) return false;
            }
        return true;
    }

    node_table<V> table_at(Problem const& what, state<S, V> const& x, S const& h, std::size_t k) {
        V const A = x.q + D_[k];
        if constexpr (is_traced_state<V>) {
            (void)derivatives_[k].compute(what, time(x, h, k), A, at_node(k), derivatives_[k].with_seconds);
            return derivatives_[k].table(d_);
        } else
            return expand_at(what, time(x, h, k), A, at_node(k));
    }
    void prepare_newton() {
        if (r_.size() > 0) return;
        int const n = static_cast<int>(R) * d_;
        r_ = correction_ = vector::Zero(n);
        J_ = matrix::Zero(n, n);
    }
    /// r_ and J_ = - its derivative; the size of what r_ is the difference of.
    S assemble(Problem const& what, state<S, V> const& x, S const& h) {
        Table const& T = table();
        place(h);
        J_.setZero();
        for (std::size_t j = 0; j < R; ++j)
            for (int c = 0; c < d_; ++c) r_(row(j, c)) = s::component(x.p, c);
        if constexpr (has_step_force<Extra>) put_extra(h);
        S forces(0);
        bends_ = S(0);
        for (std::size_t k = 0; k < N; ++k) {
            node_table<V> e = table_at(what, x, h, k);
            if constexpr (has_step_force<Extra>) e.e.by_q = e.e.by_q + room_;
            S const w = magnitude(S(h * T.weight[k]));
            forces = forces + w * magnitude(e.e.by_q) + magnitude(e.e.by_v);
            bends_ = bends_ + w * magnitude(e.e.qq);
            for (std::size_t j = 0; j < R; ++j) {
                S const by_q = h * T.momentum[j][k], by_v = T.weight[k] * T.beta[k][j] / T.gamma[j];
                if constexpr (has_step_force<Extra>)
                    for (std::size_t l = 0; l < R; ++l)
                        for (int c = 0; c < d_; ++c) {
                            S& to = J_(row(j, c), row(l, c));
                            to = to + by_q * s::component(extra.slope, c) * (h * T.gamma[l]);
                        }
                for (int c = 0; c < d_; ++c) {
                    S& r = r_(row(j, c));
                    r = r + (by_q * s::component(e.e.by_q, c) - by_v * s::component(e.e.by_v, c));
                    for (std::size_t l = 0; l < R; ++l) {
                        S const a = h * T.alpha[k][l];
                        S const& b = T.beta[k][l];
                        for (int f = 0; f < d_; ++f) {
                            S& to = J_(row(j, c), row(l, f));
                            to = to + by_v * (s::entry(e.vq_, c, f) * a + s::entry(e.e.vv, c, f) * b) -
                                 by_q * (s::entry(e.e.qq, c, f) * a + s::entry(e.e.qv, c, f) * b);
                        }
                    }
                }
            }
        }
        return forces;
    }

    int d_;
    S bends_{0}; ///< sum_k |h w_k| |d2L/dq2|: what rounding of a position does
    V zero_, room_;
    std::array<V, N> D_, B_, m_;
    std::array<block_of<V>, R> inverse_;
    struct not_traced {};
    [[no_unique_address]] std::array<std::conditional_t<is_traced_state<V>, node_derivatives<Problem, V>, not_traced>, N> derivatives_;
    vector r_, correction_;
    matrix J_;
    Eigen::PartialPivLU<matrix> lu_;
};

} // namespace hilger::detail
