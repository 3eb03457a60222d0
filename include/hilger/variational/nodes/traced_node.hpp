// SPDX-License-Identifier: BSL-1.0
// The derivatives of a Lagrangian, and of a force, at one node of a step by formulas that are traced where they are first needed
// (differentiation/traced/trace.hpp). A callable that compares its arguments is traced again where a comparison comes out differently, and
// one that is told the time for each time, unless it says that it takes a traced time: is_generic_in_time.
#pragma once

#include <memory>
#include <vector>

#include "hilger/variational/nodes/asked_node.hpp"

namespace hilger::detail {

/// All derivatives at one node, where the node is, of states that are traced. A problem that has derivatives of its own is asked for them.
template <class V>
class traced_node : public asked_node<V> {
    using typename asked_node<V>::S;
    using typename asked_node<V>::s;
    using asked_node<V>::values_, asked_node<V>::places_, asked_node<V>::has_branches_;

public:
    /// Computes them at (t, q, v). @returns whether the places changed
    bool evaluate(given_problem<V> const& what, S const& t, V const& q, V const& v, wanted which) {
        if (not what.is_traced) return asked_node<V>::evaluate(what, t, q, v, which);
        bool const is_new = now_ == nullptr;
        if (is_new) learn(what, t, q, v);
        now_->put(t, q, v, values_);
        return evaluate_here(what, t, s::dimension(q), which) or is_new;
    }
    /// Whether arguments can be put where they are read from, 2d numbers, and not only given.
    [[nodiscard]] bool has_arguments() const { return now_ != nullptr; }
    [[nodiscard]] S* arguments() { return values_.data(); }
    /// The same at the arguments that are there.
    bool evaluate_here(given_problem<V> const& what, S const& t, int d, wanted which) {
        bool is_new = false;
        values_[static_cast<std::size_t>(2 * d)] = t;
        if (what.is_of_one_time and not(t == time_)) {
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
    [[nodiscard]] evaluation<S> const& how() const { return now_->how; }

private:
    using formula = std::shared_ptr<traced_formula<S> const>;
    void take(formula const& f) {
        now_ = f;
        places_ = std::shared_ptr<derivative_places const>(f, &f->places);
        has_branches_ = not f->guards.empty();
        now_->how.prepare(values_);
    }
    [[nodiscard]] V argument(int first, int d) const {
        V x = s::zero(d);
        for (int k = 0; k < d; ++k) s::component(x, k) = values_[static_cast<std::size_t>(first + k)];
        return x;
    }
    void learn(given_problem<V> const& what, S const& t, V const& q, V const& v) {
        time_ = t;
        known_.push_back(what.traced_at(t, q, v));
        take(known_.back());
    }
    /// The formula that holds at (q, v): one that is known, or a new one.
    void take_branch(given_problem<V> const& what, S const& t, V const& q, V const& v) {
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
