// SPDX-License-Identifier: BSL-1.0
// One step of an embedding in numbers: its tableau, the control values U_0 = q_i, U_1, ..., U_n = q_{i+1}, and at each node the position
// A_k = sum_m a_km U_m, the velocity B_k = sum_m b_km U_m and the derivatives of L there. The unknowns are U_1, ..., U_n, ordered by
// components: couplings of neighbours form a band. Also the magnitudes of the terms of the equation (step/equation.hpp).
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "hilger/step/force.hpp"
#include "hilger/step/state.hpp"
#include "hilger/step/tableau.hpp"
#include "hilger/variational/nodes/node_derivatives.hpp"

namespace hilger::detail {

template <class S, class V, class Extra, int Controls>
class step_controls {
    using s = shape<V>;

protected:
    static constexpr int U = Controls - 1; ///< unknown control values
    static constexpr int last = Controls - 1;
    static constexpr int rows = s::size == Eigen::Dynamic ? Eigen::Dynamic : s::size * U;

public:
    using vector = Eigen::Matrix<S, rows, 1>;
    using unknown = std::conditional_t<U == 1, V, vector>;
    using derivatives = node_derivatives<V>;

    step_controls(V const& like, Extra extra_force)
        : extra(std::move(extra_force)), moved(shape<unknown>::zero(s::dimension(like) * U)), d_(s::dimension(like)), A_(zero_like(like)),
          B_(A_) {}
    /// Sets steps of length h. @returns whether the number of nodes changed
    bool prepare(tableau<S> const& t, S const& h) {
        bool const others = nodes_.size() != static_cast<std::size_t>(t.nodes);
        if (others) {
            nodes_.clear();
            nodes_.resize(static_cast<std::size_t>(t.nodes));
        }
        t_ = t;
        h_ = h;
        adds_up = t_.reproduces_constants();
        return others;
    }
    [[nodiscard]] S const& h() const { return h_; }
    [[nodiscard]] tableau<S> const& table() const { return t_; }
    [[nodiscard]] int dimension() const {
        if constexpr (s::size == Eigen::Dynamic)
            return d_;
        else
            return s::size;
    }
    [[nodiscard]] int unknowns() const { return dimension() * U; }
    /// U_n - q_i, component c and whole.
    [[nodiscard]] S const& end(int c) const { return component_of_moved(last, c); }
    [[nodiscard]] decltype(auto) end() const {
        if constexpr (U == 1)
            return (moved);
        else
            return moved_to(last);
    }
    /// The same as a vector, without a copy; of a number as that.
    [[nodiscard]] decltype(auto) displacement() const {
        if constexpr (U == 1)
            return (moved);
        else
            return Eigen::Map<Eigen::Matrix<S, s::size, 1> const, 0, Eigen::InnerStride<U>>(moved.data() + last - 1, dimension());
    }
    /// U_m - q_i
    [[nodiscard]] V moved_to(int m) const {
        V x = s::zero(dimension());
        for (int c = 0; c < dimension(); ++c) s::component(x, c) = moved(place_of(m, c));
        return x;
    }
    /// Displacements of uniform motion with velocity v.
    void move_with(V const& v) {
        if constexpr (U == 1)
            moved = v * h_;
        else
            for (int c = 0; c < dimension(); ++c)
                for (int m = 1; m <= U; ++m) moved(place_of(m, c)) = s::component(v, c) * h_ * S(m) / S(U);
    }

    /// Magnitude of the impulse of the forces over the step.
    [[nodiscard]] S impulses() const {
        S sum(0);
        for (int k = 0; k < t_.nodes; ++k) {
            S f(0);
            for (int c = 0; c < dimension(); ++c) f = std::max(f, S(magnitude(nodes_[at(k)].by_q(c))));
            sum = sum + magnitude(t_.w(k)) * f;
        }
        if constexpr (has_step_force<Extra>) {
            S f(0);
            for (int c = 0; c < dimension(); ++c) f = std::max(f, size_of_extra(c));
            sum = sum + f;
        }
        return sum;
    }
    /// Magnitude of the terms of the residual.
    [[nodiscard]] S forces() const {
        S sum = impulses();
        for (int k = 0; k < t_.nodes; ++k) {
            S m(0);
            for (int c = 0; c < dimension(); ++c) m = std::max(m, S(magnitude(nodes_[at(k)].by_v(c))));
            sum = sum + m;
        }
        return sum;
    }
    /// Sum of the magnitudes of the terms in each component of the residual. In row 0, |p_i| stands for the terms in dL/dv.
    void put_sizes(state<S, V> const& x, vector& sizes) const {
        for (int j = 0; j < U; ++j) {
            auto&& size = row_of(sizes, j);
            for (int c = 0; c < dimension(); ++c) size(c) = j == 0 ? magnitude(s::component(x.p, c)) : S(0);
            for (int k = 0; k < t_.nodes; ++k) {
                S const wa = magnitude(S(t_.w(k) * t_.a(k, j))), wb = magnitude(S(t_.w(k) * t_.b(k, j)));
                if (not(wa == S(0)))
                    for (int c = 0; c < dimension(); ++c) size(c) = size(c) + wa * magnitude(nodes_[at(k)].by_q(c));
                if (j > 0)
                    for (int c = 0; c < dimension(); ++c) size(c) = size(c) + wb * magnitude(nodes_[at(k)].by_v(c));
            }
            if constexpr (has_step_force<Extra>)
                for (int c = 0; c < dimension(); ++c) size(c) = size(c) + size_of_extra(c);
        }
    }
    /// Largest weight of dL/dq in the equation over that in the momentum after the step, at most 1: the momentum changes by its inverse
    /// more.
    [[nodiscard]] S share_of_force() const {
        S in_equation(0), in_momentum(0);
        for (int k = 0; k < t_.nodes; ++k) {
            in_momentum = std::max(in_momentum, S(magnitude(t_.w(k)) * magnitude(t_.a(k, last))));
            for (int j = 0; j < U; ++j) in_equation = std::max(in_equation, S(magnitude(t_.w(k)) * magnitude(t_.a(k, j))));
        }
        return in_equation < in_momentum ? S(in_equation / in_momentum) : S(1);
    }
    /// Largest weighted entry of the second derivative by q: bounds the change of the residual by the rounding of a position.
    [[nodiscard]] S bends() const {
        S most(0);
        for (int k = 0; k < t_.nodes; ++k)
            for (auto const& e : nodes_[at(k)].places().entries[block_qq])
                if (S const size = magnitude(S(t_.w(k) * nodes_[at(k)].value(e.place))); is_finite(size) and most < size) most = size;
        return most;
    }

    [[no_unique_address]] Extra extra;
    unknown moved;       ///< U_m - q_i
    bool adds_up = true; ///< the embedding reproduces constants: position 1, velocity 0

protected:
    static constexpr std::size_t at(int j) { return static_cast<std::size_t>(j); }
    static constexpr int place_of(int m, int c) { return c * U + m - 1; }
    /// Component c of A_k and of B_k.
    [[nodiscard]] S position(state<S, V> const& x, int k, int c) const {
        S sum = adds_up ? s::component(x.q, c) : S(s::component(x.q, c) * t_.of_constant(k, &tableau<S>::a));
        for (int m = 1; m <= U; ++m) sum = sum + t_.a(k, m) * component_of_moved(m, c);
        return sum;
    }
    [[nodiscard]] S velocity(state<S, V> const& x, int k, int c) const {
        if constexpr (U > 1)
            if (t_.integrates_slopes) {
                // b acts on the deviation from uniform motion only: otherwise its rounding would be a clock error.
                S const& all = component_of_moved(last, c);
                S sum = all / h_;
                for (int m = 1; m < U; ++m) sum = sum + t_.b(k, m) * (component_of_moved(m, c) - all * S(m) / S(U));
                return sum;
            }
        S sum = t_.b(k, 1) * component_of_moved(1, c);
        for (int m = 2; m <= U; ++m) sum = sum + t_.b(k, m) * component_of_moved(m, c);
        return adds_up ? sum : S(sum + s::component(x.q, c) * t_.of_constant(k, &tableau<S>::b));
    }
    [[nodiscard]] S const& component_of_moved(int m, int c) const {
        if constexpr (U == 1)
            return s::component(moved, c);
        else
            return moved(place_of(m, c));
    }
    /// A_k and B_k, into A_ and B_.
    void place(state<S, V> const& x, int k) {
        for (int c = 0; c < dimension(); ++c) {
            s::component(A_, c) = position(x, k, c);
            s::component(B_, c) = velocity(x, k, c);
        }
    }
    /// Evaluates the derivatives at node k. @returns whether their places changed
    bool compute(given_problem<V> const& problem, state<S, V> const& x, int k, wanted which) {
        given_problem<V> const& what = t_.part.empty() ? problem : problem.part(t_.part_of(k));
        if constexpr (is_traced_state<V>)
            if (auto& e = nodes_[at(k)]; e.has_arguments() and adds_up) {
                S* const to = e.arguments();
                int const d = dimension();
                if constexpr (U == 1) {
                    S const a = t_.a(k, 1), b = t_.b(k, 1);
                    for (int c = 0; c < d; ++c) to[c] = s::component(x.q, c) + a * s::component(moved, c);
                    for (int c = 0; c < d; ++c) to[d + c] = b * s::component(moved, c);
                } else {
                    for (int c = 0; c < d; ++c) to[c] = position(x, k, c);
                    for (int c = 0; c < d; ++c) to[d + c] = velocity(x, k, c);
                }
                return e.evaluate_here(what, t_.time(k, x.t, h_), d, which);
            }
        place(x, k);
        return nodes_[at(k)].evaluate(what, t_.time(k, x.t, h_), A_, B_, which);
    }

    /// Row j of all components.
    struct strided {
        vector& x;
        int j;
        S& operator()(int c) const { return x(c * U + j); }
    };
    static decltype(auto) row_of(vector& x, int j) {
        if constexpr (U == 1)
            return (x);
        else
            return strided{x, j};
    }
    /// Factor of block `b` of node k in row j of the matrix, in the column of U_m.
    [[nodiscard]] S factor(int k, int b, int j, int m) const {
        S const w = t_.w(k) * (b == block_qq or b == block_qv ? t_.a(k, j) : t_.b(k, j));
        return w * (b == block_qq or b == block_vq ? t_.a(k, m) : t_.b(k, m));
    }
    /// Share of the impulse of the extra force in row j.
    [[nodiscard]] S share(int j) const {
        if (U == 1) return h_ / S(2);
        S sum(0);
        for (int k = 0; k < t_.nodes; ++k) sum = sum + t_.w(k) * t_.a(k, j);
        return sum;
    }
    /// Component c of the extra force at node k.
    [[nodiscard]] S extra_at(int k, int c) const {
        S force = s::component(extra.constant[at(k)], c);
        for (auto const& term : extra.terms)
            for (int m = 0; m < t_.nodes; ++m) force = force - s::component(term.factor, c) * term.slope(k, m) * moved_at(m, c);
        return force;
    }
    /// A_k - q_i, component c, for embeddings that reproduce constants.
    [[nodiscard]] S moved_at(int k, int c) const {
        S by(0);
        for (int m = 1; m <= U; ++m) by = by + t_.a(k, m) * component_of_moved(m, c);
        return by;
    }
    /// Magnitude of the terms of the whole impulse, without the small one of `slope`.
    [[nodiscard]] S size_of_extra(int c) const {
        if constexpr (is_node_force<Extra>) {
            S sum(0);
            for (int k = 0; k < t_.nodes; ++k) {
                S size = magnitude(s::component(extra.constant[at(k)], c));
                for (auto const& term : extra.terms)
                    for (int m = 0; m < t_.nodes; ++m)
                        size = size + magnitude(S(s::component(term.factor, c) * term.slope(k, m) * moved_at(m, c)));
                sum = sum + magnitude(t_.w(k)) * size;
            }
            return sum;
        } else
            return magnitude(S(h_ * s::component(extra.constant, c)));
    }
    int d_;
    tableau<S> t_;
    S h_{0};
    std::vector<derivatives> nodes_;

private:
    V A_, B_;
};

} // namespace hilger::detail
