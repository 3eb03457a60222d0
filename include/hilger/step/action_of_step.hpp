// SPDX-License-Identifier: BSL-1.0
// The discrete Lagrangian of one step, L_h(U_0, ..., U_n), with its derivatives by all control values, forces included:
//   r_j = sum_k w_k (a_kj dL/dq + b_kj dL/dv)(A_k, B_k),   dr_j / dU_m,   0 <= j, m <= n.
// One pass over the nodes gives all of them. The equation of a step (step/equation.hpp) has r_n in its momentum and U_0 given; between two
// ends (integrator/rows.hpp) the r_n of a step and the r_0 of the next one add up to zero.
#pragma once

#include <vector>

#include "hilger/step/controls.hpp"

namespace hilger::detail {

template <class S, class V, int Controls>
class action_of_step : public step_controls<S, V, no_step_force, Controls> {
    using s = shape<V>;
    using controls = step_controls<S, V, no_step_force, Controls>;
    using controls::at, controls::compute, controls::factor, controls::moved, controls::nodes_, controls::place_of, controls::t_,
        controls::U;
    static constexpr int size = s::size == Eigen::Dynamic ? Eigen::Dynamic : s::size * Controls;

public:
    using controls::dimension;
    explicit action_of_step(V const& like)
        : controls(like, {}), residual(Eigen::Matrix<S, size, 1>::Zero(Controls * dimension())), sizes(residual),
          slope(Eigen::Matrix<S, size, size>::Zero(residual.size(), residual.size())), start_{S(0), like, like} {}
    /// Sets steps of length h.
    void prepare(tableau<S> const& t, S const& h) {
        controls::prepare(t, h);
        factors_.clear();
        for (int k = 0; k < t.nodes; ++k)
            for (int b = 0; b < blocks; ++b)
                for (int m = 0; m <= U; ++m)
                    for (int j = 0; j <= U; ++j) factors_.push_back(factor(k, b, j, m));
    }
    /// Evaluates the gradients, and the second derivatives as `which` asks, in a step from t with the values values[0], ..., values[n].
    void evaluate(given_problem<V> const& problem, S const& t, V const* values, wanted which) {
        start_.t = t;
        start_.q = values[0];
        for (int m = 1; m <= U; ++m)
            for (int c = 0; c < dimension(); ++c) {
                S const by = s::component(values[m], c) - s::component(values[0], c);
                if constexpr (U == 1)
                    s::component(moved, c) = by;
                else
                    moved(place_of(m, c)) = by;
            }
        for (int k = 0; k < t_.nodes; ++k) (void)compute(problem, start_, k, which);
    }
    void put_residual() {
        residual.setZero();
        for_each_term([this](int to, S const& of_q, S const& of_v) { residual(to) = residual(to) + of_q + of_v; });
    }
    void put_slope() {
        slope.setZero();
        int const d = dimension();
        for (int k = 0; k < t_.nodes; ++k)
            for (int b = 0; b < blocks; ++b)
                for (auto const& e : nodes_[at(k)].places().entries[at(b)]) {
                    S const x = nodes_[at(k)].value(e.place);
                    S const* by = &factors_[at((k * blocks + b) * Controls * Controls)];
                    for (int m = 0; m <= U; ++m)
                        for (int j = 0; j <= U; ++j, ++by) {
                            S& to = slope(j * d + e.row, m * d + e.column);
                            to = to + *by * x;
                        }
                }
    }
    /// The sums of the magnitudes of the terms of the residual and of those of its derivative times the values, whose rounding they carry.
    void put_sizes(V const* values) {
        sizes.setZero();
        for_each_term([this](int to, S const& of_q, S const& of_v) { sizes(to) = sizes(to) + magnitude(of_q) + magnitude(of_v); });
        int const d = dimension();
        for (int k = 0; k < sizes.size(); ++k) {
            S const value = magnitude(s::component(values[k / d], k % d));
            for (int j = 0; j < sizes.size(); ++j) sizes(j) = sizes(j) + magnitude(slope(j, k)) * value;
        }
    }

    Eigen::Matrix<S, size, 1> residual, sizes; ///< component c of r_j at j d + c; their sizes
    Eigen::Matrix<S, size, size> slope;        ///< by component e of U_m in column m d + e

private:
    /// Calls use(j d + c, its terms in dL/dq and in dL/dv at one node) for each node.
    template <class Use>
    void for_each_term(Use const& use) const {
        for (int k = 0; k < t_.nodes; ++k)
            for (int j = 0; j <= U; ++j) {
                S const wa = t_.w(k) * t_.a(k, j), wb = t_.w(k) * t_.b(k, j);
                for (int c = 0; c < dimension(); ++c)
                    use(j * dimension() + c, S(wa * nodes_[at(k)].by_q(c)), S(wb * nodes_[at(k)].by_v(c)));
            }
    }
    state<S, V> start_;
    std::vector<S> factors_; ///< of each block of each node, in all rows and columns
};

} // namespace hilger::detail
