// SPDX-License-Identifier: BSL-1.0
// The equation of a step of any embedding without control values inside the step, given by its tableau, in any dimension:
//   r(y) = p_i + sum_k w_k (a_k0 dL/dq + b_k0 dL/dv)(A_k, B_k) = 0,   A_k = a_k0 q_i + a_k1 y,   B_k = b_k0 q_i + b_k1 y,
// which is p_i = -d_1 L_h, with its derivative by y in the pattern that the formula of L leaves; and the momentum after the step,
//   p_{i+1} = d_2 L_h = sum_k w_k (a_k1 dL/dq + b_k1 dL/dv).
#pragma once

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "hilger/linear/patterned_matrix.hpp"
#include "hilger/step/force.hpp"
#include "hilger/step/state.hpp"
#include "hilger/step/tableau.hpp"
#include "hilger/variational/node_derivatives.hpp"
#include "hilger/variational/problem.hpp"

namespace hilger::detail {

template <class Problem, class S, class V, class Extra = no_step_force>
class step_equation {
    using s = shape<V>;

public:
    using matrix = patterned_matrix<S>;
    using vector = Eigen::Matrix<S, s::size, 1>;
    using derivatives = node_derivatives<Problem, V>;

    step_equation(V const& like, Extra extra_force)
        : extra(std::move(extra_force)), moved(zero_like(like)), residual(vector::Zero(s::dimension(like))), increment(residual),
          whole(residual), d_(s::dimension(like)), A_(moved), B_(moved) {}
    void prepare(tableau<S> const& t, S const& h) {
        if (nodes_.size() != static_cast<std::size_t>(t.nodes)) {
            nodes_.clear();
            nodes_.resize(static_cast<std::size_t>(t.nodes));
            is_prepared = false;
        }
        t_ = t;
        h_ = h;
        adds_up = reproduces_constants();
    }
    [[nodiscard]] S const& h() const { return h_; }
    [[nodiscard]] int dimension() const {
        if constexpr (s::size == Eigen::Dynamic)
            return d_;
        else
            return s::size;
    }

    [[no_unique_address]] Extra extra;
    V moved;                 ///< y - q_i
    vector residual;         ///< r(y)
    vector increment, whole; ///< what the momentum gains; what it becomes
    matrix full_matrix;      ///< r'(y)
    matrix constant_part;    ///< what of it never changes
    bool is_prepared = false, is_constant = false, has_constant_mass = false;
    bool adds_up = true; ///< constants have themselves as position and no velocity

    /// The gradients at y, and the second derivatives; and which matrices there are, where the formulas are new.
    void evaluate(Problem const& problem, state<S, V> const& x, int which) {
        bool is_new = not is_prepared;
        for (int k = 0; k < t_.nodes; ++k) {
            bool const no_force =
                is_prepared and is_constant and which == derivatives::first_order and again_[at(k)] and t_.w(k) * t_.a(k, 0) == S(0);
            if (compute(problem, x, k, no_force ? derivatives::momenta_only : which)) is_new = true;
        }
        if (is_new) prepare_matrices();
    }
    void put_residual(state<S, V> const& x) {
        for (int c = 0; c < dimension(); ++c) residual(c) = s::component(x.p, c);
        for (int k = 0; k < t_.nodes; ++k) {
            S const wa = t_.w(k) * t_.a(k, 0), wb = t_.w(k) * t_.b(k, 0);
            if (wa == S(0))
                nodes_[at(k)].add_by_v(wb, residual);
            else
                nodes_[at(k)].add_both(wa, wb, residual);
        }
        if constexpr (has_step_force<Extra>) { // h/2 F
            S const half = h_ / S(2);
            for (int c = 0; c < dimension(); ++c) residual(c) = residual(c) + half * extra.at(s::component(moved, c), c);
        }
    }
    /// The constant part, factorized; false where it is singular.
    bool factorize_constant_part() {
        if (constant_part.is_factorized() and factors_are_of_ == h_) return true;
        put_constant_matrix();
        factors_are_of_ = h_;
        return constant_part.factorize();
    }
    /// The derivative of the residual.
    void put_matrix() {
        full_matrix.set_zero();
        for (int k = 0; k < t_.nodes; ++k)
            for (int b = 0; b < blocks; ++b) {
                auto const& block = nodes_[at(k)].places().entries[at(b)];
                auto const& to = places_[at(k)][at(b)];
                if (to.empty()) continue;
                S const c = factor(k, b);
                for (std::size_t i = 0; i < to.size(); ++i) {
                    S& entry = full_matrix[to[i]];
                    entry = entry + c * tally<S>::second(nodes_[at(k)].value(block[i].place));
                }
            }
        put_resistance(full_matrix);
    }
    /// The size of what the residual is a sum of.
    [[nodiscard]] S forces() const {
        S sum(0);
        for (int k = 0; k < t_.nodes; ++k) {
            S f(0), m(0);
            for (int c = 0; c < dimension(); ++c) {
                f = std::max(f, S(magnitude(nodes_[at(k)].by_q(c))));
                m = std::max(m, S(magnitude(nodes_[at(k)].by_v(c))));
            }
            sum = sum + magnitude(t_.w(k)) * f + m;
        }
        if constexpr (has_step_force<Extra>) sum = sum + magnitude(h_) * magnitude(extra.constant);
        return sum;
    }
    /// What each component of the residual is a sum of, in magnitudes.
    void put_sizes(state<S, V> const& x, vector& sizes) const {
        for (int c = 0; c < dimension(); ++c) sizes(c) = magnitude(s::component(x.p, c));
        for (int k = 0; k < t_.nodes; ++k) {
            S const wa = magnitude(S(t_.w(k) * t_.a(k, 0)));
            if (wa == S(0)) continue;
            for (int c = 0; c < dimension(); ++c) sizes(c) = sizes(c) + wa * magnitude(nodes_[at(k)].by_q(c));
        }
        if constexpr (has_step_force<Extra>)
            for (int c = 0; c < dimension(); ++c) sizes(c) = sizes(c) + magnitude(S(h_ * s::component(extra.constant, c)));
    }
    /// Whether no component of the residual is more than the rounding of what it is a sum of.
    [[nodiscard]] bool is_rounding(state<S, V> const& x) {
        put_sizes(x, increment); // room until the momentum is known
        for (int c = 0; c < dimension(); ++c)
            if (not(magnitude(S(residual(c))) <= S(8) * epsilon<S>() * increment(c))) return false;
        return true;
    }
    /// What rounding of a position does to the residual, at most.
    [[nodiscard]] S bends() const {
        S most(0);
        for (int k = 0; k < t_.nodes; ++k)
            for (auto const& e : nodes_[at(k)].places().entries[block_qq])
                if (S const size = magnitude(S(t_.w(k) * nodes_[at(k)].value(e.place))); most < size) most = size;
        return most;
    }
    /// What the momenta gain, into increment, and what they become, into whole where they are not found in that way. The last correction is
    /// applied to the gradients to first order, or they are evaluated again where that is not enough. As a_k0 + a_k1 = 1 and b_k0 + b_k1 =
    /// 0 the equations add up to p_{i+1} = p_i + sum_k w_k dL/dq, which rounds better than the definition; embeddings that do not reproduce
    /// constants use the latter.
    void gather(Problem const& problem, state<S, V> const& x, vector const& correction, bool is_corrected) {
        if constexpr (not has_step_force<Extra>)
            if (t_.nodes == 1 and adds_up) {
                auto& e = nodes_[0];
                bool const again = is_constant and again_[0];
                if (again) (void)compute(problem, x, 0, derivatives::forces_only);
                auto const moves_force = [&](block_number b, S const& by) { return not(by == S(0)) and not e.places().entries[b].empty(); };
                if (again or not is_corrected or not(moves_force(block_qq, t_.a(0, 1)) or moves_force(block_qv, t_.b(0, 1)))) {
                    e.put_by_q(t_.w(0), increment);
                    return;
                }
            }
        increment.setZero();
        if (not adds_up) whole.setZero();
        for (int k = 0; k < t_.nodes; ++k) {
            auto& e = nodes_[at(k)];
            bool const again = is_constant and again_[at(k)];
            if (again) {
                int const which = adds_up ? derivatives::forces_only : derivatives::first_order;
                (void)compute(problem, x, k, which);
            }
            S const &w = t_.w(k), &a = t_.a(k, 1), &b = t_.b(k, 1);
            e.add_by_q(w, increment);
            if (not adds_up) {
                e.add_by_q(S(w * a), whole);
                e.add_by_v(S(w * b), whole);
            }
            if (again) continue;
            for (int block = 0; block < blocks; ++block) {
                S const& by = block == block_qq or block == block_vq ? a : b;
                if (by == S(0)) continue;
                bool const of_force = block == block_qq or block == block_qv;
                for (auto const& entry : e.places().entries[at(block)]) {
                    S const change = w * (e.value(entry.place) * (by * correction(entry.column)));
                    if (of_force) increment(entry.row) = increment(entry.row) - change;
                    if (not adds_up) whole(entry.row) = whole(entry.row) - (of_force ? a : b) * change;
                }
            }
        }
        if constexpr (has_step_force<Extra>)
            for (int c = 0; c < dimension(); ++c) {
                S const impulse = h_ * extra.at(s::component(moved, c), c);
                increment(c) = increment(c) + impulse;
                whole(c) = whole(c) + impulse / S(2);
            }
    }

private:
    static constexpr std::size_t at(int j) { return static_cast<std::size_t>(j); }
    /// What block `b` of node k is multiplied by in the matrix.
    [[nodiscard]] S factor(int k, int b) const {
        S const w = t_.w(k) * (b == block_qq or b == block_qv ? t_.a(k, 0) : t_.b(k, 0));
        return w * (b == block_qq or b == block_vq ? t_.a(k, 1) : t_.b(k, 1));
    }
    /// Whether the gradients at node k are affine in y: then a correction to first order is the whole of it.
    [[nodiscard]] bool is_affine(int k) const {
        auto const& places = nodes_[at(k)].places();
        auto const block = [&](block_number b) { return places.constant[b] or places.entries[b].empty(); };
        return (t_.a(k, 1) == S(0) or (block(block_qq) and block(block_vq))) and
               (t_.b(k, 1) == S(0) or (block(block_qv) and block(block_vv)));
    }
    /// A_k and B_k, into A_ and B_.
    void place(state<S, V> const& x, int k) {
        S const &a = t_.a(k, 1), &b = t_.b(k, 1);
        if (adds_up) {
            A_ = x.q + moved * a;
            B_ = moved * b;
        } else {
            A_ = x.q * S(t_.a(k, 0) + a) + moved * a;
            B_ = x.q * S(t_.b(k, 0) + b) + moved * b;
        }
    }
    bool compute(Problem const& problem, state<S, V> const& x, int k, int which) {
        if constexpr (not derivatives::own)
            if (auto& e = nodes_[at(k)]; e.has_arguments() and adds_up) {
                S const a = t_.a(k, 1), b = t_.b(k, 1);
                S* const to = e.arguments();
                int const d = dimension();
                for (int c = 0; c < d; ++c) to[c] = s::component(x.q, c) + a * s::component(moved, c);
                for (int c = 0; c < d; ++c) to[d + c] = b * s::component(moved, c);
                return e.compute_here(problem, t_.time(k, x.t, h_), d, which);
            }
        place(x, k);
        return nodes_[at(k)].compute(problem, t_.time(k, x.t, h_), A_, B_, which);
    }
    /// For the formulas that there are now: the matrix of the equation, and what of it never changes, which is all of it, or the masses at
    /// least, or is not used.
    void prepare_matrices() {
        std::vector<std::pair<int, int>> entries, constant;
        is_constant = has_constant_mass = true;
        again_.assign(at(t_.nodes), false);
        for (int k = 0; k < t_.nodes; ++k) {
            again_[at(k)] = not is_affine(k);
            auto const& places = nodes_[at(k)].places();
            if (nodes_[at(k)].has_branches()) is_constant = false; // the next branch may be another formula
            if (places.entries[block_vv].empty() or not places.constant[block_vv]) has_constant_mass = false;
            for (int b = 0; b < blocks; ++b) {
                auto const& block = places.entries[at(b)];
                if (block.empty() or factor(k, b) == S(0)) continue;
                for (auto const& e : block) entries.emplace_back(e.row, e.column);
                if (places.constant[at(b)])
                    for (auto const& e : block) constant.emplace_back(e.row, e.column);
                else
                    is_constant = false;
            }
        }
        if (std::numeric_limits<S>::is_exact) has_constant_mass = false; // an iteration converges, and is never exact
        constant_part.prepare(d_, constant);
        factors_are_of_ = S(0);
        full_matrix.prepare(d_, entries);
        places_.assign(at(t_.nodes), {});
        for (int k = 0; k < t_.nodes; ++k)
            for (int b = 0; b < blocks; ++b)
                if (not(factor(k, b) == S(0)))
                    for (auto const& e : nodes_[at(k)].places().entries[at(b)])
                        places_[at(k)][at(b)].push_back(full_matrix.place(e.row, e.column));
        is_prepared = true;
    }
    void put_constant_matrix() {
        constant_part.set_zero();
        for (int k = 0; k < t_.nodes; ++k)
            for (int b = 0; b < blocks; ++b) {
                S const c = factor(k, b);
                if (c == S(0) or not nodes_[at(k)].places().constant[at(b)]) continue;
                for (auto const& e : nodes_[at(k)].places().entries[at(b)]) {
                    S& entry = constant_part[constant_part.place(e.row, e.column)];
                    entry = entry + c * tally<S>::second(nodes_[at(k)].value(e.place));
                }
            }
        put_resistance(constant_part);
    }
    void put_resistance(matrix& K) {
        if constexpr (has_step_force<Extra>)
            for (int c = 0; c < dimension(); ++c) {
                S& entry = K[K.place(c, c)];
                entry = entry - h_ / S(2) * s::component(extra.slope, c);
            }
    }
    /// a_k0 + a_k1 = 1 and b_k0 + b_k1 = 0 at every node, to rounding.
    [[nodiscard]] bool reproduces_constants() const {
        S const rounding = S(64) * epsilon<S>();
        for (int k = 0; k < t_.nodes; ++k) {
            S const size_b = magnitude(t_.b(k, 0)) + magnitude(t_.b(k, 1));
            if (not(magnitude(S(t_.a(k, 0) + t_.a(k, 1) - S(1))) <= rounding) or
                not(magnitude(S(t_.b(k, 0) + t_.b(k, 1))) <= rounding * size_b))
                return false;
        }
        return true;
    }

    int d_;
    tableau<S> t_;
    S h_{0}, factors_are_of_{0}; ///< the step, and that of the factors of the constant part
    std::vector<derivatives> nodes_;
    std::vector<std::array<std::vector<int>, blocks>> places_; ///< of the entries of each node's blocks in the matrix
    std::vector<bool> again_;                                  ///< where gradients are not affine in y
    V A_, B_;
};

} // namespace hilger::detail
