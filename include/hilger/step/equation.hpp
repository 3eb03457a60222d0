// SPDX-License-Identifier: BSL-1.0
// The equation of one step of an embedding, given by its tableau, in any dimension. With the control values U_0 = q_i, U_1, ..., U_n =
// q_{i+1}, L_h is stationary in U_1, ..., U_{n-1}, the values inside the step, and p_i = -d_0 L_h:
//   r_j(U) = [j = 0] p_i + sum_k w_k (a_kj dL/dq + b_kj dL/dv)(A_k, B_k) = 0,  j < n,   A_k = sum_m a_km U_m,   B_k = sum_m b_km U_m,
// with its derivative by U_1, ..., U_n in the sparsity pattern of the formula of L, and the momentum after the step,
//   p_{i+1} = d_n L_h = sum_k w_k (a_kn dL/dq + b_kn dL/dv).
// Rows and unknowns of one component are adjacent, so that couplings of neighbours form a band.
#pragma once

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "hilger/linear/patterned_matrix.hpp"
#include "hilger/step/controls.hpp"

namespace hilger::detail {

/// Terms of the last gradients that the last correction still has to update.
enum class corrected { in_nothing, in_constants, in_all };

template <class S, class V, class Extra = no_step_force, int Controls = 2>
class step_equation : public step_controls<S, V, Extra, Controls> {
    using s = shape<V>;
    using controls = step_controls<S, V, Extra, Controls>;
    using controls::at, controls::compute, controls::d_, controls::h_, controls::last, controls::nodes_, controls::place_of, controls::t_,
        controls::U, controls::row_of, controls::factor, controls::share;

public:
    using controls::adds_up, controls::dimension, controls::end, controls::displacement, controls::extra, controls::moved,
        controls::moved_to, controls::put_sizes, controls::table, controls::unknowns;
    using typename controls::unknown, typename controls::vector;
    using matrix = patterned_matrix<S, s::size == Eigen::Dynamic ? s::size : s::size * U>;
    using of_state = Eigen::Matrix<S, s::size, 1>;

    step_equation(V const& like, Extra extra_force)
        : controls(like, std::move(extra_force)), residual(vector::Zero(s::dimension(like) * U)),
          increment(of_state::Zero(s::dimension(like))), whole(increment), sizes_(residual) {}
    void prepare(tableau<S> const& t, S const& h) {
        if (controls::prepare(t, h)) is_prepared = false;
    }

    vector residual;           ///< r(U)
    of_state increment, whole; ///< p_{i+1} - p_i; p_{i+1}
    matrix full_matrix;        ///< r'(U)
    matrix constant_part;      ///< its entries that never change
    bool is_prepared = false, is_constant = false, has_constant_mass = false;

    /// Evaluates the gradients, and the second derivatives as `which` asks, at the current displacements. @returns whether the matrices are
    /// new
    bool evaluate(given_problem<V> const& problem, state<S, V> const& x, wanted which) {
        bool is_new = not is_prepared;
        for (int k = 0; k < t_.nodes; ++k) {
            bool const no_force = is_prepared and is_constant and which == wanted::first_order and again_[at(k)] and not enters_by_force(k);
            if (compute(problem, x, k, no_force ? wanted::momenta_only : which)) is_new = true;
        }
        if (is_new) prepare_matrices();
        return is_new;
    }
    void put_residual(state<S, V> const& x) {
        bool const by_change = U > 1 and t_.integrates_slopes;
        for (int c = 0; c < dimension(); ++c) residual(place_of(1, c)) = by_change ? S(0) : s::component(x.p, c);
        for (int j = 1; j < U; ++j)
            for (int c = 0; c < dimension(); ++c) residual(place_of(j + 1, c)) = S(0);
        for (int k = 0; k < t_.nodes; ++k)
            for (int j = 0; j < U; ++j) {
                S const wa = t_.w(k) * t_.a(k, j), wb = t_.w(k) * t_.b(k, j);
                auto&& row = row_of(residual, j);
                if (by_change) { // sum_k w_k b_kj = -[j = 0]: a constant dL/dv = p_i cancels, however b is rounded
                    for (int c = 0; c < dimension(); ++c)
                        row(c) = row(c) + wa * nodes_[at(k)].by_q(c) + wb * (nodes_[at(k)].by_v(c) - s::component(x.p, c));
                    continue;
                }
                if (wa == S(0))
                    nodes_[at(k)].add_by_v(wb, row);
                else
                    nodes_[at(k)].add_both(wa, wb, row);
            }
        if constexpr (is_node_force<Extra>)
            for_each_extra([&](int k, int c, S const& force) {
                for (int j = 0; j < U; ++j) {
                    S& r = residual(place_of(j + 1, c));
                    r = r + t_.w(k) * t_.a(k, j) * force;
                }
            });
        else if constexpr (has_step_force<Extra>)
            for (int j = 0; j < U; ++j)
                for (int c = 0; c < dimension(); ++c) {
                    S& r = residual(place_of(j + 1, c));
                    r = r + share(j) * extra.at(end(c), c);
                }
    }
    /// Factorizes the constant part. @returns false if it is singular
    bool factorize_constant_part() {
        if (constant_part.is_factorized() and factors_are_of_ == h_) return true;
        put_constant_matrix();
        factors_are_of_ = h_;
        return constant_part.factorize();
    }
    /// Assembles the derivative of the residual. `of_slopes_alone`, for searches, omits non-finite slopes of forces, as that of |q|^1.5 at
    /// 0: such a correction still leads on.
    void put_matrix(bool of_slopes_alone = false) {
        full_matrix.set_zero();
        for_each_block([&](int k, int b, int j, int m, S const& c, auto const& entries) {
            auto const& to = places_[at(k)][at(b)][pair_of(j, m)];
            for (std::size_t i = 0; i < to.size(); ++i) {
                S& entry = full_matrix[to[i]];
                S const& slope = nodes_[at(k)].value(entries[i].place);
                if (of_slopes_alone and b != block_vv and not is_finite(slope)) continue;
                entry = entry + c * slope;
            }
        });
        put_resistance(full_matrix);
    }
    /// Whether every component of the residual is within the rounding of its terms.
    [[nodiscard]] bool is_rounding(state<S, V> const& x) {
        put_sizes(x, sizes_);
        for (int c = 0; c < unknowns(); ++c)
            if (not(magnitude(S(residual(c))) <= S(8) * epsilon<S>() * sizes_(c))) return false;
        return true;
    }
    /// Computes the change of the momentum, into increment, and its new value, into whole, for embeddings that do not reproduce constants.
    /// The last correction enters the gradients to first order (`how`: by all second derivatives or the constant ones); gradients that are
    /// not affine beside a constant matrix are evaluated again. With sum_m a_km = 1 and sum_m b_km = 0, p_{i+1} = p_i + sum_k w_k dL/dq,
    /// which rounds better than the definition.
    void gather(given_problem<V> const& problem, state<S, V> const& x, vector const& correction, corrected how) {
        if constexpr (not has_step_force<Extra>)
            if (U == 1 and t_.nodes == 1 and adds_up) {
                auto& e = nodes_[0];
                bool const again = is_constant and again_[0];
                if (again) (void)compute(problem, x, 0, wanted::forces_only);
                auto const moves_force = [&](block_number b, S const& by) {
                    return not(by == S(0)) and not e.places().entries[at(b)].empty() and
                           (how == corrected::in_all or e.places().constant[at(b)]);
                };
                if (again or how == corrected::in_nothing or not(moves_force(block_qq, t_.a(0, 1)) or moves_force(block_qv, t_.b(0, 1)))) {
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
                wanted const which = adds_up ? wanted::forces_only : wanted::first_order;
                (void)compute(problem, x, k, which);
            }
            S const &w = t_.w(k), &a = t_.a(k, last), &b = t_.b(k, last);
            e.add_by_q(w, increment);
            if (not adds_up) {
                e.add_by_q(S(w * a), whole);
                e.add_by_v(S(w * b), whole);
            }
            if (again) continue;
            for (int block = 0; block < blocks; ++block) {
                if (how == corrected::in_constants and not e.places().constant[at(block)]) continue;
                for (int m = 1; m <= U; ++m) {
                    S const& by = block == block_qq or block == block_vq ? t_.a(k, m) : t_.b(k, m);
                    if (by == S(0)) continue;
                    bool const of_force = block == block_qq or block == block_qv;
                    for (auto const& entry : e.places().entries[at(block)]) {
                        S const change = w * (e.value(entry.place) * (by * correction(place_of(m, entry.column))));
                        if (of_force) increment(entry.row) = increment(entry.row) - change;
                        if (not adds_up) whole(entry.row) = whole(entry.row) - (of_force ? a : b) * change;
                    }
                }
            }
        }
        if constexpr (is_node_force<Extra>) {
            extra.moved.assign(at(t_.nodes), zero_like(x.q));
            for_each_extra([&](int k, int c, S const& force) {
                s::component(extra.moved[at(k)], c) = controls::moved_at(k, c);
                increment(c) = increment(c) + t_.w(k) * force;
                whole(c) = whole(c) + t_.w(k) * t_.a(k, last) * force;
            });
        } else if constexpr (has_step_force<Extra>)
            for (int c = 0; c < dimension(); ++c) {
                S const force = extra.at(end(c), c);
                increment(c) = increment(c) + h_ * force;
                whole(c) = whole(c) + share(last) * force;
            }
    }

private:
    static constexpr std::size_t pair_of(int j, int m) { return at(j * U + m - 1); }
    /// Calls each(node, block, row, control, factor, entries) for all blocks of the matrix.
    template <class Each>
    void for_each_block(Each const& each) const {
        for (int k = 0; k < t_.nodes; ++k)
            for (int b = 0; b < blocks; ++b)
                if (auto const& entries = nodes_[at(k)].places().entries[at(b)]; not entries.empty())
                    for (int j = 0; j < U; ++j)
                        for (int m = 1; m <= U; ++m)
                            if (S const c = factor(k, b, j, m); not(c == S(0))) each(k, b, j, m, c, entries);
    }
    /// Calls each(node, component, force) for the extra forces at the nodes.
    template <class Each>
    void for_each_extra(Each const& each) const {
        for (int k = 0; k < t_.nodes; ++k)
            for (int c = 0; c < dimension(); ++c) each(k, c, controls::extra_at(k, c));
    }
    /// Whether dL/dq at node k is in the equation.
    [[nodiscard]] bool enters_by_force(int k) const {
        for (int j = 0; j < U; ++j)
            if (not(t_.w(k) * t_.a(k, j) == S(0))) return true;
        return false;
    }
    /// Whether the gradients at node k are affine in the unknowns, so that a first-order correction is exact.
    [[nodiscard]] bool is_affine(int k) const {
        auto const& places = nodes_[at(k)].places();
        auto const block = [&](block_number b) { return places.constant[at(b)] or places.entries[at(b)].empty(); };
        for (int m = 1; m <= U; ++m)
            if (not((t_.a(k, m) == S(0) or (block(block_qq) and block(block_vq))) and
                    (t_.b(k, m) == S(0) or (block(block_qv) and block(block_vv)))))
                return false;
        return true;
    }
    /// Builds the patterns of the matrix and of its constant part: the latter is all of it, at least the masses, or unused.
    void prepare_matrices() {
        std::vector<std::pair<int, int>> entries, constant;
        is_constant = has_constant_mass = true;
        again_.assign(at(t_.nodes), false);
        for (int k = 0; k < t_.nodes; ++k) {
            again_[at(k)] = not is_affine(k);
            auto const& places = nodes_[at(k)].places();
            if (nodes_[at(k)].has_branches()) is_constant = false; // the next branch may be another formula
            if (places.entries[block_vv].empty() or not places.constant[block_vv]) has_constant_mass = false;
        }
        for_each_block([&](int k, int b, int j, int m, S const&, auto const& block) {
            for (auto const& e : block) entries.emplace_back(place_of(j + 1, e.row), place_of(m, e.column));
            if (nodes_[at(k)].places().constant[at(b)])
                for (auto const& e : block) constant.emplace_back(place_of(j + 1, e.row), place_of(m, e.column));
            else
                is_constant = false;
        });
        if (std::numeric_limits<S>::is_exact) has_constant_mass = false; // an iteration converges, and is never exact
        constant_part.prepare(unknowns(), constant);
        factors_are_of_ = S(0);
        full_matrix.prepare(unknowns(), entries);
        places_.assign(at(t_.nodes), {});
        for_each_block([&](int k, int b, int j, int m, S const&, auto const& block) {
            for (auto const& e : block)
                places_[at(k)][at(b)][pair_of(j, m)].push_back(full_matrix.place(place_of(j + 1, e.row), place_of(m, e.column)));
        });
        is_prepared = true;
    }
    void put_constant_matrix() {
        constant_part.set_zero();
        for_each_block([&](int k, int b, int j, int m, S const& c, auto const& entries) {
            if (not nodes_[at(k)].places().constant[at(b)]) return;
            for (auto const& e : entries) {
                S& entry = constant_part[constant_part.place(place_of(j + 1, e.row), place_of(m, e.column))];
                entry = entry + c * nodes_[at(k)].value(e.place);
            }
        });
        put_resistance(constant_part);
    }
    void put_resistance(matrix& K) {
        if constexpr (is_node_force<Extra>) {
            for (auto const& term : extra.terms)
                for (int k = 0; k < t_.nodes; ++k)
                    for (int m = 1; m <= U; ++m) {
                        S slope(0); // of the derivative at node k by U_m
                        for (int l = 0; l < t_.nodes; ++l) slope = slope + term.slope(k, l) * t_.a(l, m);
                        for (int j = 0; j < U; ++j)
                            for (int c = 0; c < dimension(); ++c) {
                                S& entry = K[K.place(place_of(j + 1, c), place_of(m, c))];
                                entry = entry - s::component(term.factor, c) * (t_.w(k) * t_.a(k, j) * slope);
                            }
                    }
        } else if constexpr (has_step_force<Extra>)
            for (int c = 0; c < dimension(); ++c)
                for (int j = 0; j < U; ++j) {
                    S& entry = K[K.place(place_of(j + 1, c), place_of(last, c))];
                    entry = entry - share(j) * s::component(extra.slope, c);
                }
    }
    S factors_are_of_{0};                                                         ///< step length of the factors of the constant part
    std::vector<std::array<std::array<std::vector<int>, U * U>, blocks>> places_; ///< of each node's block entries in the matrix
    std::vector<bool> again_;                                                     ///< nodes whose gradients are not affine in the unknowns
    vector sizes_;                                                                ///< workspace
};

} // namespace hilger::detail
