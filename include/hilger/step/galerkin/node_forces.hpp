// SPDX-License-Identifier: BSL-1.0
// The forces at the nodes of a Galerkin step for L = v.Mv/2 + a.v - U(q): most Lagrangians of few degrees of freedom, and systems declared
// as such. They are iterated: A_k = q_0 + h c_k v_0 + h^2 M^-1 sum_m twice_km F_m and F_k = -U'(A_k) (step/galerkin/table.hpp); a round
// costs N forces and gains a factor of order h^2.
#pragma once

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include "hilger/history/component.hpp"
#include "hilger/inlining.hpp"
#include "hilger/newton/small_solve.hpp"
#include "hilger/newton/stop.hpp"
#include "hilger/step/force.hpp"
#include "hilger/step/galerkin/table.hpp"
#include "hilger/step/separable.hpp"

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

/// Fixed-point iteration of the forces at the nodes, from step to step.
template <class Problem, class Table, bool Compensated, class S, class V, class Extra = no_step_force>
class node_forces {
    using s = shape<V>;
    using separable_type = separable<Problem, S, V>;
    static constexpr std::size_t N = Table::N;

public:
    /// The rounding of the table is a bias that repeats in every step: compensated sums use numbers in two parts.
    static constexpr bool in_parts = Compensated and Table::has_parts;

    node_forces(Problem const& what, S const& h, V const& like) : h_(h), d_(s::dimension(like)), separable_(what, like) {
        v_ = next_ = room_ = s::zero(d_);
        if constexpr (in_parts) part_ = v_;
        if constexpr (has_step_force<Extra>) end_ = extra_force_ = v_;
        D_.fill(v_);
        before_.fill(v_);
        F_.fill(v_);
        guess_.fill(v_);
    }
    void prepare(S const& h) { h_ = h; }
    /// Whether L has these parts at x.
    [[nodiscard]] bool inspect(Problem const& what, state<S, V> const& x) { return separable_.inspect(what, x); }
    template <class Visit>
    void visit(Visit& each) {
        for (V& f : F_) memory::visit_components("force", f, each);
    }

    /// Iterates the forces of the step from x, starting from those of the previous step if it `continues` that one. @returns lost if they
    /// converge too slowly, going if L does not have these parts
    progress iterate(Problem const& what, state<S, V> const& x, Extra const& extra, bool continues) {
        if constexpr (std::is_floating_point_v<S>)
            return flat_iteration(what, x, extra, continues);
        else
            return iteration(what, x, extra, continues);
    }
    /// Displacement and impulse of the converged forces, for the functions below.
    void finish() {
        bend();
        add_forces([](auto const& of) -> auto const& { return of.weight; });
        room_ = room_ * h_;
        if constexpr (in_parts) part_ = next_ * h_;
        next_ = (v_ + next_) * h_;
    }
    [[nodiscard]] V const& moved() const { return next_; }     ///< q_1 - q_0
    [[nodiscard]] V const& gained() const { return room_; }    ///< p_1 - p_0
    [[nodiscard]] V const& velocity() const { return v_; }     ///< v_0
    [[nodiscard]] auto const& curved() const { return part_; } ///< q_1 - q_0 - h v_0, in parts
    /// The value at t_0 + s h of the polynomial through q_0 and the positions at the nodes, less q_0.
    [[nodiscard]] V inside(S const& at) const {
        auto const& c = table().whole.node;
        V sum = s::zero(d_);
        for (std::size_t k = 0; k < N; ++k) {
            if (c[k] == S(0)) continue; // that is q_0 itself
            S l = at / c[k];
            for (std::size_t j = 0; j < N; ++j)
                if (j != k and not(c[j] == S(0))) l = l * (at - c[j]) / (c[k] - c[j]);
            sum = sum + D_[k] * l;
        }
        return sum;
    }

private:
    static Table const& table() { return Table::here(); }
    /// With compensated sums the error left by the iteration must not be visible either.
    static S small() { return Compensated ? S(1) / S(256) : S(1) / S(2); }

    // Flattened for built-in floating-point types, for the reasons of flat_jets_of.
    HILGER_FLATTEN progress flat_iteration(Problem const& what, state<S, V> const& x, Extra const& extra, bool continues) {
        return iteration(what, x, extra, continues);
    }
    HILGER_ALWAYS_INLINE progress iteration(Problem const& what, state<S, V> const& x, Extra const& extra, bool continues) {
        separable_.velocity(x.p, v_);
        bool is_separable = true;
        if (continues) { // extrapolated from the last step
            for (std::size_t k = 0; k < N; ++k) combine(table().next_node[k], F_, guess_[k]);
            std::swap(F_, guess_);
        } else {
            is_separable = separable_.force(what, x.t, x.q, F_[0]);
            if constexpr (has_step_force<Extra>) F_[0] = F_[0] + extra.constant;
            for (std::size_t k = 1; k < N; ++k) F_[k] = F_[0];
        }
        (void)move_nodes(extra);
        S reach = magnitude(x.q);
        for (V const& D : D_) reach = std::max(reach, S(magnitude(D)));
        contraction<S> convergence(epsilon<S>() * reach, small());
        progress end = progress::going;
        bool const differ = sizes_differ(x);
        S farthest(-1);
        std::uint64_t const compared = comparisons_made();
        for (;;) {
            if constexpr (separable_type::has_forces) {
                for (std::size_t k = 0; k < N; ++k) before_[k] = x.q + D_[k]; // workspace until it is filled below
                is_separable = separable_.forces(what, x.t, before_.data(), F_.data(), N) and is_separable;
            } else
                for (std::size_t k = 0; k < N; ++k) {
                    room_ = x.q + D_[k];
                    is_separable = separable_.force(what, x.t, room_, F_[k]) and is_separable;
                }
            if constexpr (has_step_force<Extra>)
                for (V& f : F_) f = f + extra_force_;
            if (not is_separable) return progress::going;
            bool const was_done = end == progress::done;
            if (end != progress::going and not(was_done and comparisons_made() != compared)) return end;
            if (differ) before_ = D_;
            S const size = move_nodes(extra);
            // With branches, the forces at the last positions decide whether these are final.
            if (was_done and convergence.is_rounding(size)) return end;
            end = convergence.after(size);
            // All components together have converged; small ones beside large ones continue as long as they gain.
            if (differ and end == progress::done)
                if (S const far = farthest_of_its_size(x); far > S(8) * epsilon<S>() and (farthest < S(0) or S(4) * far < farthest)) {
                    farthest = far;
                    end = progress::going;
                }
        }
    }
    /// Magnitude of component c of the positions in this step.
    [[nodiscard]] S size_of(state<S, V> const& x, int c) const {
        return magnitude(s::component(x.q, c)) + magnitude(S(h_ * s::component(v_, c)));
    }
    /// Whether a component is far smaller than others without being their rounding.
    [[nodiscard]] bool sizes_differ(state<S, V> const& x) {
        if (d_ == 1) return false;
        largest_ = S(0);
        for (int c = 0; c < d_; ++c) largest_ = std::max(largest_, size_of(x, c));
        for (int c = 0; c < d_; ++c)
            if (S const size = size_of(x, c); size < largest_ / S(1024) and S(64) * epsilon<S>() * largest_ < size) return true;
        return false;
    }
    /// Largest last correction of the nodes, each component in units of its size.
    [[nodiscard]] S farthest_of_its_size(state<S, V> const& x) const {
        S far(0);
        for (int c = 0; c < d_; ++c)
            if (S const size = size_of(x, c); S(64) * epsilon<S>() * largest_ < size)
                for (std::size_t k = 0; k < N; ++k)
                    far = std::max(far, S(magnitude(S(s::component(D_[k], c) - s::component(before_[k], c))) / size));
        return far;
    }
    /// Computes A_k - q_0 from the forces. @returns the largest change of a node
    HILGER_ALWAYS_INLINE S move_nodes(Extra const& extra) {
        S size(0);
        for (std::size_t k = 0; k < N; ++k) {
            add_forces([k](auto const& of) -> auto const& { return of.twice[k]; });
            room_ = room_ * h_; // neither h^2 nor an unscaled force over a mass need be representable
            separable_.solve(room_, next_);
            if constexpr (in_parts)
                next_ = (v_ * table().leading.node[k] + (v_ * table().rest.node[k] + next_)) * h_;
            else
                next_ = (v_ * table().whole.node[k] + next_) * h_;
            room_ = next_ - D_[k];
            size = std::max(size, S(magnitude(room_)));
            D_[k] = next_;
        }
        if constexpr (has_step_force<Extra>) size = std::max(size, renew_extra(extra));
        return size;
    }
    /// Combines the forces with a row of the table, into room_.
    template <class Row>
    HILGER_ALWAYS_INLINE void add_forces(Row const& row) {
        if constexpr (in_parts) {
            combine(row(table().leading), F_, room_);
            combine(row(table().rest), F_, part_);
            room_ = room_ + part_;
        } else
            combine(row(table().whole), F_, room_);
    }
    /// Contribution of the forces to the mean velocity of the step, into next_.
    HILGER_ALWAYS_INLINE void bend() {
        add_forces([](auto const& of) -> auto const& { return of.reach; });
        room_ = room_ * h_;
        separable_.solve(room_, next_);
    }
    /// q_{i+1} - q_i from the forces at the nodes, into next_.
    HILGER_ALWAYS_INLINE void reach_end() {
        bend();
        next_ = (v_ + next_) * h_;
    }
    /// Extra force for the end that the forces lead to. @returns the change of that end
    S renew_extra(Extra const& extra) {
        reach_end();
        room_ = next_ - end_;
        end_ = next_;
        for (int c = 0; c < d_; ++c) s::component(extra_force_, c) = extra.at(s::component(end_, c), c);
        return magnitude(room_);
    }

    S h_;
    int d_;
    separable_type separable_;
    using of_extra = std::conditional_t<has_step_force<Extra>, V, no_step_force>;
    using of_parts = std::conditional_t<in_parts, V, no_step_force>;
    V v_, next_, room_;                                ///< v_0; workspace
    [[no_unique_address]] of_parts part_;              ///< workspace
    S largest_{0};                                     ///< largest size of a component
    std::array<V, N> before_;                          ///< D_ of the previous round, for components of different sizes
    std::array<V, N> D_, F_, guess_;                   ///< A_k - q_0; the forces; those of the last step during the iteration
    [[no_unique_address]] of_extra end_, extra_force_; ///< q_1 - q_0 and the extra force during the iteration
};

} // namespace hilger::detail
