// SPDX-License-Identifier: BSL-1.0
// The step of a Galerkin embedding: by the forces at its nodes for L = v.Mv/2 + a.v - U(q) (step/galerkin/node_forces.hpp), by the equation
// of the step (step/many_nodes.hpp) for other Lagrangians and when that iteration fails.
#pragma once

#include <optional>

#include "hilger/step/galerkin/node_forces.hpp"
#include "hilger/step/many_nodes.hpp"
#include "hilger/step/summation.hpp"
#include "hilger/variational/legendre.hpp"

namespace hilger::detail {

/// State that one trajectory keeps from step to step.
template <class Problem, class Table, bool Compensated, class S, class V, class Extra = no_step_force>
class galerkin_step {
    using s = shape<V>;
    using forces = node_forces<Problem, Table, Compensated, S, V, Extra>;
    using sums = state_sums<Compensated, S, V>;
    static constexpr bool exact = std::numeric_limits<S>::is_exact;
    enum way : int { undecided, by_forces, by_equation };

public:
    galerkin_step(Problem const& what, tableau<S> const& t, S const& h, V const& like, Extra const& extra = {})
        : h_(h), d_(s::dimension(like)), forces_(what, h, like), equation_(t, h, like, extra), sums_(d_) {}
    void prepare(tableau<S> const& t, S const& h) {
        h_ = h;
        if (way_ == by_forces) known_ = 0; // forces at another step length do not extrapolate
        way_ = undecided;
        inspected_ = false;
        forces_.prepare(h);
        equation_.prepare(t, h);
    }
    /// Sets the velocity guess of the first step.
    void start_with(V const& v) {
        if (known_ == 0) start_ = v;
    }
    /// See many_nodes.
    void do_not_search() { equation_.do_not_search(); }
    [[nodiscard]] S const& h() const { return h_; }
    [[nodiscard]] Extra& extra() { return equation_.extra(); }
    /// Everything that later steps depend on and h does not determine, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        each("known", known_);
        each("way", way_);
        if (way_ == by_forces)
            forces_.visit(each);
        else
            equation_.visit(each);
        sums_.visit(each);
    }

    /// @throws error::no_convergence, error::singular, error::not_finite; `x` is then as it was.
    void advance(Problem const& what, state<S, V>& x) {
        if (not inspected_) {
            bool const has_parts = not exact and forces_.inspect(what, x);
            if (way_ == undecided) {
                way_ = has_parts ? by_forces : by_equation;
                if (has_parts) known_ = 0;
            }
            inspected_ = true;
        }
        if (way_ == by_forces) {
            switch (forces_.iterate(what, x, equation_.extra(), known_ > 0)) {
            case progress::done:
                finish_by_forces(x);
                return;
            case progress::lost: // this step only
                equation_.restart(forces_.velocity());
                known_ = 0;
                finish_by_equation(what, x);
                return;
            case progress::going:
                way_ = by_equation;
                known_ = 0;
            }
        }
        if (known_ == 0) {
            at_time const L{what.lagrangian, x.t};
            equation_.restart(start_ ? velocity_of(L, x.q, x.p, *start_) : velocity_of(L, x.q, x.p));
        }
        finish_by_equation(what, x);
        known_ = 1;
        start_.reset();
    }

    /// U_m - q_i of the last step, 0 < m < R, to rounding.
    [[nodiscard]] V inside(int m) const {
        return led_by_forces_ ? forces_.inside(S(m) / S(static_cast<int>(Table::R))) : equation_.inside(m);
    }

private:
    void finish_by_forces(state<S, V>& x) {
        led_by_forces_ = true;
        forces_.finish();
        if constexpr (forces::in_parts)
            add_in_parts(x);
        else
            sums_.add(x, h_, forces_.moved(), forces_.gained(), equation_.name);
        known_ = 1;
    }
    /// Adds h v_0 with the rounding error of the product, which is biased if the digits of h repeat, as those of 0.1.
    void add_in_parts(state<S, V>& x) {
        sums::require_finite(x, forces_.moved(), forces_.gained(), equation_.name);
        sums_.add_in_parts(
            x, h_,
            [&](int c) {
                S straight{}, cut{}, moved{}, left{};
                two_product(h_, component_of(forces_.velocity(), c), straight, cut);
                two_sum(straight, component_of(forces_.curved(), c), moved, left);
                return std::pair<S, S>(moved, S(left + cut));
            },
            forces_.gained());
    }
    /// The equations add up to p_{i+1} = p_i + h sum_k w_k dL/dq, which rounds better than d_2 L_h.
    void finish_by_equation(Problem const& what, state<S, V>& x) {
        led_by_forces_ = false;
        equation_.solve(given<Problem, V>(what), x);
        sums_.add(x, h_, equation_.moved(), equation_.gained(), equation_.name);
    }

    S h_;
    int d_, known_ = 0, way_ = undecided;
    bool inspected_ = false, led_by_forces_ = false; ///< the last step
    forces forces_;
    many_nodes<Compensated, S, V, Extra, static_cast<int>(Table::R) + 1> equation_;
    std::optional<V> start_; ///< velocity guess of the first step, if given
    [[no_unique_address]] sums sums_;
};

} // namespace hilger::detail
