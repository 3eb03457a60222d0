// SPDX-License-Identifier: BSL-1.0
// Fractional damping -rho D^beta q at the nodes of a Galerkin embedding whose nodes are Radau's, on any T: D^beta is the power of the
// difference quotient of Radau IIA with these stages (history/stages.hpp), and its force is added to dL/dq at each node, as Lagrange and
// d'Alembert's principle has it. With s stages the undamped part is of order 2s - 1. On a T that is graded at its start positions have the
// order min(2s - 1, s + 3 - beta) and momenta min(2s - 1, s + 2 - beta) (tests/runtime/fractional/stage_orders.cpp); on equal steps the
// start of the solution, like t^{3 - beta}, limits it: see grading().
//   embed(with_fractional_damping(L, rho, fraction<1, 2>{}, exponentials{1e-12}), galerkin<4, radau>)
// The same stands with other stiffly accurate methods whose stages are the nodes: at_stages<Damping, s, lobatto> has those of Lobatto IIIC,
// for galerkin<s, lobatto>, of order min(2s - 2, s + 2 - beta) (papers/hariz_jimenez_ober_blobaum_2026).
// D^beta is Caputo's. Only increments are differentiated: for beta > 1 it is D^{beta-1} of D[q] - v_0. The work of the damping, the sum of
// w_k v_k . F_k with the quadrature's weights and the velocities at the nodes, is not positive up to any point of T for beta <= 1, and for
// beta > 1 if v_0 = 0, since Radau IIA is algebraically stable (tests/runtime/history/stage_dissipation.cpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "hilger/embedding/collocation.hpp"
#include "hilger/fractional/damping.hpp"
#include "hilger/history/exponentials.hpp"
#include "hilger/history/stages.hpp"
#include "hilger/step/force.hpp"

namespace hilger {

namespace detail {

/// The forces of one damping at the stages, along one trajectory.
template <class Damping, class S, class V>
class stage_damping {
    using places = damped_places<Damping, S, V>;
    using kept = typename places::kept;
    using matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;
    static constexpr int least = std::is_floating_point_v<memory::modes_scalar<S>> ? 64 : 1024; // as in history/exponentials.hpp

public:
    template <class W>
    stage_damping(Damping const& d, runge_kutta<W> const& method, S const& longest, S const& shortest, V const& like)
        : on_(d, like), rho_(zero_like(like)), beta_(d.order.template as<S>()), since_(on_.of(rho_)), v0_(since_), now_(since_),
          before_(since_), values_(method.stages(), since_), is_velocity_(not(beta_ < S(1))),
          inverse_(memory::rounded<S>(memory::stage_resolvent<S, W>(method.A).inverse())) {
        require_order(beta_);
        for (int j = 0; j < shape<V>::dimension(like); ++j) shape<V>::component(rho_, j) = places::coefficient(d, j);
        S const tolerance = d.policy.tolerance == 0 ? S(least) * epsilon<S>() : S(d.policy.tolerance);
        if (S const rest = is_velocity_ ? S(beta_ - S(1)) : beta_; not(rest == S(0)) and on_.count() > 0)
            history_.emplace(method, rest, tolerance, longest, shortest, since_);
    }
    [[nodiscard]] bool needs_velocity() const { return on_.count() > 0 and S(1) < beta_; }
    void begin(V const& v0) {
        if (needs_velocity()) v0_ = on_.of(v0);
    }
    /// Adds the force of a step of length h that does not move to its constants, and sets its slope.
    void begin_step(S const& h, std::vector<V>& constant, typename node_force<V>::term& term) {
        nu_ = h;
        term.factor = rho_;
        term.slope = is_velocity_ ? matrix(inverse_ / h) : matrix(matrix::Identity(inverse_.rows(), inverse_.cols()));
        if (history_) {
            history_->begin(h);
            term.slope = history_->leading() * term.slope;
        }
        kept const rest = is_velocity_ ? kept(-v0_) : since_;
        for (index_type k = 0; k < inverse_.rows(); ++k) {
            kept force = zero_like(rest);
            if (history_) force = history_->past(k) + rest * S(history_->leading().row(k).sum());
            for (int c = 0; c < on_.count(); ++c) {
                int const j = on_.at(c);
                S& to = shape<V>::component(constant[static_cast<std::size_t>(k)], j);
                to = to - shape<V>::component(rho_, j) * shape<kept>::component(force, c);
            }
        }
    }
    /// The displacements A_k - q_i of the step that has begun, which ends it.
    void arrive(std::vector<V> const& moved) {
        before_ = now_;
        std::vector<kept> step;
        for (V const& x : moved) step.push_back(on_.of(x));
        auto const add_row = [](kept& to, auto const& row, std::vector<kept> const& x) {
            for (std::size_t m = 0; m < x.size(); ++m) to = to + x[m] * S(row(static_cast<index_type>(m)));
        };
        for (std::size_t k = 0; k < step.size(); ++k) {
            values_[k] = is_velocity_ ? kept(-v0_) : kept(since_ + step[k]);
            if (is_velocity_) add_row(values_[k], inverse_.row(static_cast<index_type>(k)) / nu_, step);
        }
        now_ = values_.back();
        if (history_) {
            now_ = history_->past(inverse_.rows() - 1);
            add_row(now_, history_->leading().row(inverse_.rows() - 1), values_);
            history_->push(values_);
        }
        since_ = since_ + step.back();
    }
    /// Everything that later forces depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        for (kept* x : {&since_, &v0_, &now_, &before_}) memory::visit_components("damped", *x, each);
        if (history_) history_->visit(each);
    }
    /// -rho D^beta q at the point reached last, or with `back` at the one before.
    void add_force(V& f, bool back) const {
        for (int c = 0; c < on_.count(); ++c) {
            int const j = on_.at(c);
            S& to = shape<V>::component(f, j);
            to = to - shape<V>::component(rho_, j) * shape<kept>::component(back ? before_ : now_, c);
        }
    }

private:
    places on_;
    V rho_;
    S beta_, nu_{0};
    kept since_, v0_, now_, before_; ///< q - q_0; the velocity at t_0, where the order asks for it; D^beta q at the last points
    std::vector<kept> values_;       ///< the argument of the history: q - q_0, or D[q] - v_0
    bool is_velocity_;
    matrix inverse_;                             ///< A^-1
    std::optional<stage_history<kept>> history_; ///< of an order that is not whole
};

} // namespace detail

/// The sum of the dampings at the s stages of each step, which are the nodes of a Galerkin embedding.
template <class Damping, int Stages, class Quadrature = radau>
struct at_stages {
    std::vector<Damping> dampings;
    double longest = 0, shortest = 0; ///< the length of T and its shortest step, which the histories are made for
    static constexpr bool needs_compensation = detail::may_exceed_one<Damping>, any_steps = true;

    /// Along one trajectory of states V.
    template <class S, class V>
    class history : public detail::sum_of_dampings<detail::stage_damping<Damping, S, V>> {
        using detail::sum_of_dampings<detail::stage_damping<Damping, S, V>>::terms_;

    public:
        using extra = detail::node_force<V>;
        history(at_stages const& of, S const& h, V const& like) : zero_(zero_like(like)) {
            auto const method = detail::stage_method<S, Quadrature>(Stages);
            S const least = of.longest > 0 ? S(of.shortest) : h, most = of.longest > 0 ? S(of.longest) : S(h * S(1'000'000));
            for (Damping const& d : of.dampings) terms_.emplace_back(d, method, most, least, like);
        }
        [[nodiscard]] extra extra_force(V const& like) const {
            typename extra::term const none{zero_like(like), decltype(extra::term::slope)::Zero(Stages, Stages)};
            return {std::vector<V>(Stages, zero_like(like)), std::vector(terms_.size(), none), {}};
        }
        void begin(state<S, V> const&, V const& v0) {
            for (auto& d : terms_) d.begin(v0);
        }
        void before_step(state<S, V>&, extra& force, S const& h) {
            force.constant.assign(Stages, zero_);
            for (std::size_t k = 0; k < terms_.size(); ++k) terms_[k].begin_step(h, force.constant, force.terms[k]);
        }
        void after_step(state<S, V>&, extra const& force) {
            for (auto& d : terms_) d.arrive(force.moved);
        }

    private:
        V zero_;
    };
    /// The gamma of graded(a, b, N, gamma): the solution has a part like t^{3 - beta}, for beta > 1 like t^{4 - beta}, which costs the
    /// first step, (b - a) N^-gamma, that power of its length, and no more than the others with gamma (3 - beta) = 2s - 1.
    template <class S>
    [[nodiscard]] S grading() const {
        using std::floor;
        S gamma(1);
        for (Damping const& d : dampings) {
            S const beta = d.order.template as<S>();
            gamma = std::max(gamma, S(S(2 * Stages - 1) / (S(3) - beta + floor(beta))));
        }
        return gamma;
    }
    /// @throws error::mismatch
    template <class V>
    void require_dimension(V const& q) const {
        for (Damping const& d : dampings) detail::damped_places<Damping, scalar_of<V>, V>::require_dimension(d, q);
    }
    /// The same for the steps of T.
    template <class Scale>
    [[nodiscard]] at_stages on(Scale const& T) const {
        at_stages bound = *this;
        bound.longest = static_cast<double>(T.max() - T.min());
        bound.shortest = bound.longest;
        for (index_type i = T.first(); i < T.last(); i = Scale::root_type::is_uniform ? T.last() : i + 1)
            bound.shortest = std::min(bound.shortest, static_cast<double>(T.domain().base.step(T.root(), i)));
        return bound;
    }
};

} // namespace hilger
