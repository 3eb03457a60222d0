// SPDX-License-Identifier: BSL-1.0
// The discrete Lagrangian of one step, L_h(U_0, ..., U_n), with its derivatives by all control values, forces included:
//   r_j = sum_k w_k (a_kj dL/dq + b_kj dL/dv)(A_k, B_k),   dr_j / dU_m,   0 <= j, m <= n.
// One pass over the nodes gives all of them. The equation of a step (step/equation.hpp) has r_n in its momentum and U_0 given; between two
// ends (integrator/rows.hpp) the r_n of a step and the r_0 of the next one add up to zero.
#pragma once

#include "hilger/step/controls.hpp"

namespace hilger::detail {

template <class S, class V, int Controls>
class action_of_step : public step_controls<S, V, no_step_force, Controls> {
    using s = shape<V>;
    using controls = step_controls<S, V, no_step_force, Controls>;
    using controls::at, controls::compute, controls::factor, controls::moved, controls::nodes_, controls::place_of, controls::t_,
        controls::U;

public:
    using controls::dimension;
    explicit action_of_step(V const& like) : controls(like, {}), start_{S(0), like, like} {}

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
    /// Calls add(j, c, r, size) for component c of r_j, with the sum of the magnitudes of its terms.
    template <class Add>
    void for_each_row(Add const& add) const {
        for (int j = 0; j <= U; ++j)
            for (int c = 0; c < dimension(); ++c) {
                S sum(0), size(0);
                for (int k = 0; k < t_.nodes; ++k) {
                    S const of_q = t_.w(k) * t_.a(k, j) * nodes_[at(k)].by_q(c), of_v = t_.w(k) * t_.b(k, j) * nodes_[at(k)].by_v(c);
                    sum = sum + of_q + of_v;
                    size = size + magnitude(of_q) + magnitude(of_v);
                }
                add(j, c, sum, size);
            }
    }
    /// Calls add(j, c, m, e, x) for the terms x of the derivative of component c of r_j by component e of U_m.
    template <class Add>
    void for_each_slope(Add const& add) const {
        for (int k = 0; k < t_.nodes; ++k)
            for (int b = 0; b < blocks; ++b)
                if (auto const& entries = nodes_[at(k)].places().entries[at(b)]; not entries.empty())
                    for (int j = 0; j <= U; ++j)
                        for (int m = 0; m <= U; ++m)
                            if (S const by = factor(k, b, j, m); not(by == S(0)))
                                for (auto const& e : entries) add(j, e.row, m, e.column, S(by * nodes_[at(k)].value(e.place)));
    }

private:
    state<S, V> start_;
};

} // namespace hilger::detail
