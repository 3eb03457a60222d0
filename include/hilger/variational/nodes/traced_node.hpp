// SPDX-License-Identifier: BSL-1.0
// The derivatives of a Lagrangian, and of a force, at one node of a step by formulas that are traced where they are first needed
// (differentiation/traced/trace.hpp). A callable that compares its arguments is traced again where a comparison comes out differently, and
// one that is told the time for each time, unless it says that it takes a traced time: is_generic_in_time.
#pragma once

#include <memory>
#include <vector>

#include "hilger/differentiation/traced/trace.hpp"
#include "hilger/variational/nodes/node_values.hpp"
#include "hilger/variational/problem.hpp"

namespace hilger::detail {

template <class F, class Force, class S, class V>
traced_formula<S> trace_problem(problem<F, Force> const& what, S const& t, V const& q, V const& v) {
    using T = traced<S>;
    auto const value = [&](auto const& f, T const& time, auto const& x, auto const& y) {
        if constexpr (is_generic_in_time<std::remove_cvref_t<decltype(f)>>)
            return value_from(f, time, x, y);
        else
            return at_time{f, t}(x, y);
    };
    return trace<S>(t, q, v, on_position | on_velocity, [&](T const& time, auto const& x, auto const& y, std::vector<T>& force) {
        if constexpr (not std::same_as<Force, no_force>) put_force<V>(value(what.force, time, x, y), shape<V>::dimension(q), force);
        return as_jet<T>(value(what.lagrangian, time, x, y));
    });
}

/// All derivatives at one node, where the node is, of states that are traced.
template <class Problem, class V>
class traced_node : public node_values<scalar_of<V>, traced_node<Problem, V>> {
    using S = scalar_of<V>;
    using node_values<S, traced_node>::values_;
    using s = shape<V>;
    using F = std::remove_cvref_t<decltype(std::declval<Problem const&>().lagrangian)>;
    using given = typename s::template with<traced<S>>;
    /// Whether the formula is another one at another time.
    template <class X>
    static constexpr bool told_time = std::invocable<X const&, S const&, given const&, given const&> and not is_generic_in_time<X>;
    static constexpr bool timed =
        told_time<F> or (has_force<Problem> and told_time<std::remove_cvref_t<decltype(std::declval<Problem const&>().force)>>);

public:
    static constexpr bool has_room = true; ///< for arguments

    /// Computes them at (t, q, v). @returns whether the places changed
    bool evaluate(Problem const& what, S const& t, V const& q, V const& v, wanted which) {
        bool const is_new = now_ == nullptr;
        if (is_new) learn(what, t, q, v);
        now_->put(t, q, v, values_);
        return evaluate_here(what, t, s::dimension(q), which) or is_new;
    }
    /// Whether arguments can be put where they are read from, 2d numbers, and not only given.
    [[nodiscard]] bool has_arguments() const { return now_ != nullptr; }
    [[nodiscard]] S* arguments() { return values_.data(); }
    /// The same at the arguments that are there.
    bool evaluate_here(Problem const& what, S const& t, int d, wanted which) {
        if (which != wanted::momenta_only) tally<S>::add(work::force);
        bool is_new = false;
        values_[static_cast<std::size_t>(2 * d)] = t;
        if constexpr (timed)
            if (not(t == time_)) {
                V const q = argument(0, d), v = argument(d, d);
                known_.clear();
                learn(what, t, q, v);
                now_->put(t, q, v, values_);
                is_new = true;
            }
        if (which == wanted::with_seconds and now_->guards.empty()) {
            now_->how.compute_all(values_.data());
            return is_new;
        }
        now_->how.compute(evaluation<S>::shared, values_.data());
        if (not now_->is_branch_of(values_)) {
            take_branch(what, t, argument(0, d), argument(d, d));
            is_new = true;
        }
        now_->tell_branches();
        if (which != wanted::forces_only) now_->how.compute(evaluation<S>::momenta, values_.data());
        if (which != wanted::momenta_only) now_->how.compute(evaluation<S>::forces, values_.data());
        if (which == wanted::with_seconds) now_->how.compute(evaluation<S>::seconds, values_.data());
        return is_new;
    }
    [[nodiscard]] derivative_places const& places() const { return now_->places; }
    [[nodiscard]] evaluation<S> const& how() const { return now_->how; }
    /// Whether the formula holds where comparisons come out as they did.
    [[nodiscard]] bool has_branches() const { return now_ != nullptr and not now_->guards.empty(); }

private:
    using formula = std::shared_ptr<traced_formula<S> const>;
    void take(formula const& f) {
        now_ = f;
        now_->how.prepare(values_);
    }
    [[nodiscard]] V argument(int first, int d) const {
        V x = s::zero(d);
        for (int k = 0; k < d; ++k) s::component(x, k) = values_[static_cast<std::size_t>(first + k)];
        return x;
    }
    void learn(Problem const& what, S const& t, V const& q, V const& v) {
        time_ = t;
        auto const traced_here = [&] { return trace_problem(what, t, q, v); };
        if constexpr (not has_force<Problem> and requires { what.lagrangian.kept(); })
            known_.push_back(what.lagrangian.kept().template of<S>(traced_here));
        else
            known_.push_back(std::make_shared<traced_formula<S> const>(traced_here()));
        take(known_.back());
    }
    /// The formula that holds at (q, v): one that is known, or a new one.
    void take_branch(Problem const& what, S const& t, V const& q, V const& v) {
        for (auto const& f : known_) {
            take(f);
            f->put(t, q, v, values_);
            f->how.compute(evaluation<S>::shared, values_.data());
            if (f->is_branch_of(values_)) return;
        }
        if (known_.size() >= 64) known_.clear(); // of a callable with so many branches the next one will be another one
        learn(what, t, q, v);
        now_->put(t, q, v, values_);
        now_->how.compute(evaluation<S>::shared, values_.data());
    }
    std::vector<formula> known_;
    formula now_;
    S time_{};
};

} // namespace hilger::detail
