// SPDX-License-Identifier: BSL-1.0
// The derivatives of a Lagrangian, and of a force, at one node of a step: a list of values and their places, for the d components of dL/dq
// and dL/dv and the nonzero second derivatives.
//   asked_node    for small states by jets, for callables with derivatives of their own, and for models, which list them. The degrees of L
//                 tell which second derivatives are zero or constant, except for a callable that compares: another branch may be another
//                 formula. If L takes the time none is constant, and zeros may fill in: a driven L may compare the time unnoticed.
//   traced_node   by formulas that are traced on first use (differentiation/traced/trace.hpp): again when a comparison of arguments comes
//                 out differently, and at each time for callables that take it, unless they accept a traced time: is_generic_in_time.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "hilger/differentiation/branches.hpp"
#include "hilger/variational/nodes/given_problem.hpp"

namespace hilger::detail {

/// The derivatives of a node to be computed.
enum class wanted { first_order, with_seconds, momenta_only, forces_only };

template <class V>
class asked_node {
protected:
    using S = scalar_of<V>;
    using s = shape<V>;

public:
    /// Computes the derivatives at (t, q, v). @returns whether the places changed
    bool evaluate(given_problem<V> const& what, S const& t, V const& q, V const& v, wanted which) {
        int const d = s::dimension(q);
        branch_watch const watch;
        bool const is_first = values_.empty();
        if (is_first) by_q_ = by_v_ = s::zero(d);
        if (what.list(q, v, which == wanted::with_seconds, by_q_, values_, places_)) {
            bool const meets_branches = not has_branches_ and watch.saw_any();
            has_branches_ = has_branches_ or meets_branches;
            return is_first or meets_branches;
        }
        if (is_first) {
            values_.resize(static_cast<std::size_t>(2 * d + blocks * d * d), S(0));
            on_ = what.gradients(t, q, v, by_q_, by_v_);
            watch.forget(); // it is no part of the step
            says_all_ = not what.reads_time();
        }
        dependence on;
        if (is_first or which == wanted::with_seconds) {
            auto const e = what.expand(t, q, v);
            on = e.on();
            put(0, e.e.by_q, d);
            put(d, e.e.by_v, d);
            block_of<V> const* const in[] = {&e.e.qq, &e.e.qv, &e.vq_, &e.e.vv};
            for (int b = 0; b < blocks; ++b)
                for (int j = 0; j < d; ++j)
                    for (int k = 0; k < d; ++k) values_[at(place(b, j, k, d))] = s::entry(*in[b], j, k);
        } else {
            on = what.gradients(t, q, v, by_q_, by_v_);
            put(0, by_q_, d);
            put(d, by_v_, d);
        }
        bool const grows = not says_all_ and not(on_ + on == on_);
        if (grows) on_ = on_ + on;
        bool const is_new = is_first or grows or (not has_branches_ and watch.saw_any());
        if (watch.saw_any()) has_branches_ = true;
        if (is_new) arrange(d, what.has_force);
        return is_new;
    }

    /// Places of the last evaluation.
    [[nodiscard]] derivative_places const& places() const { return *places_; }
    /// Whether the formula depends on the outcome of comparisons.
    [[nodiscard]] bool has_branches() const { return has_branches_; }
    [[nodiscard]] S const& value(int place) const { return values_[static_cast<std::size_t>(place)]; }
    [[nodiscard]] std::vector<S> const& values() const { return values_; }
    [[nodiscard]] S const& by_q(int k) const { return value(places_->by_q[static_cast<std::size_t>(k)]); }
    [[nodiscard]] S const& by_v(int k) const { return value(places_->by_v[static_cast<std::size_t>(k)]); }

    /// to = c dL/dq, force included; to += a dL/dq + b dL/dv
    template <class X>
    void put_by_q(S const& c, X& to) const {
        put(places_->by_q, places_->by_q_whole, to, [&](auto const&, auto const& x) { return c * x; });
    }
    template <class X>
    void add_both(S const& a, S const& b, X& to) const {
        if (can_add_whole(to)) {
            add_by_q(a, to);
            add_by_v(b, to);
            return;
        }
        S const* const x = values_.data();
        int const *const place = places_->by_q.data(), *const other = places_->by_v.data();
        for (int k = 0, d = static_cast<int>(places_->by_q.size()); k < d; ++k) to(k) = to(k) + a * x[place[k]] + b * x[other[k]];
    }
    /// to += c dL/dq, force included; to += c dL/dv
    template <class X>
    void add_by_q(S const& c, X& to) const {
        put(places_->by_q, places_->by_q_whole, to, [&](auto const& before, auto const& x) { return before + c * x; });
    }
    template <class X>
    void add_by_v(S const& c, X& to) const {
        put(places_->by_v, places_->by_v_whole, to, [&](auto const& before, auto const& x) { return before + c * x; });
    }

protected:
    std::vector<S> values_;
    std::shared_ptr<derivative_places const> places_;
    bool has_branches_ = false;

private:
    using whole = Eigen::Map<Eigen::Matrix<S, Eigen::Dynamic, 1> const>;
    template <class X>
    static constexpr bool stands_together = std::is_base_of_v<Eigen::PlainObjectBase<X>, X>;
    template <class X>
    [[nodiscard]] bool can_add_whole(X const&) const {
        return stands_together<X> and not places_->by_q_whole.empty() and not places_->by_v_whole.empty();
    }
    /// to = use(to, x), component by component, for x at these places; contiguous stretches as vectors.
    template <class X, class Use>
    void put(std::vector<int> const& places, std::vector<derivative_places::stretch> const& stretches, X& to, Use const& use) const {
        S const* const x = values_.data();
        if constexpr (stands_together<X>)
            if (not stretches.empty()) {
                for (auto const& e : stretches) {
                    auto&& part = to.segment(e.component, e.count);
                    part = use(part, whole(x + e.place, e.count));
                }
                return;
            }
        int const* const place = places.data();
        for (int k = 0, d = static_cast<int>(places.size()); k < d; ++k) to(k) = use(to(k), x[place[k]]);
    }
    static constexpr std::size_t at(int k) { return static_cast<std::size_t>(k); }
    static constexpr int place(int b, int j, int k, int d) { return 2 * d + (b * d + j) * d + k; }
    void put(int first, V const& x, int d) {
        for (int k = 0; k < d; ++k) values_[at(first + k)] = s::component(x, k);
    }
    /// Determines the nonzero entries, and the constant ones.
    void arrange(int d, bool forced) {
        dependence const on = has_branches_ ? dependence{dependence::no_polynomial, dependence::no_polynomial, true} : on_;
        bool const is_there[] = {forced or on.q > 1, forced or on.coupled, on.coupled, on.v > 1};
        bool const is_constant[] = {not forced and not on.coupled and on.q <= 2, not forced and on.q <= 1 and on.v <= 1,
                                    on.q <= 1 and on.v <= 1, not on.coupled and on.v <= 2};
        derivative_places made;
        for (int k = 0; k < d; ++k) {
            made.by_q.push_back(k);
            made.by_v.push_back(d + k);
        }
        made.find_stretches();
        for (int b = 0; b < blocks; ++b) {
            made.constant[at(b)] = says_all_ and is_constant[b];
            if (not is_there[b]) continue;
            for (int j = 0; j < d; ++j)
                for (int k = 0; k < d; ++k) made.entries[at(b)].push_back({j, k, place(b, j, k, d)});
        }
        places_ = std::make_shared<derivative_places const>(std::move(made));
    }
    dependence on_;
    bool says_all_ = false;
    V by_q_, by_v_; ///< workspace
};

/// All derivatives at one node, of traced states. Problems with derivatives of their own use asked_node.
template <class V>
class traced_node : public asked_node<V> {
    using typename asked_node<V>::S;
    using typename asked_node<V>::s;
    using asked_node<V>::values_, asked_node<V>::places_, asked_node<V>::has_branches_;

public:
    /// Computes the derivatives at (t, q, v). @returns whether the places changed
    bool evaluate(given_problem<V> const& what, S const& t, V const& q, V const& v, wanted which) {
        if (not what.is_traced) return asked_node<V>::evaluate(what, t, q, v, which);
        bool const is_new = now_ == nullptr;
        if (is_new) learn(what, t, q, v);
        now_->put(t, q, v, values_);
        return evaluate_here(what, t, s::dimension(q), which) or is_new;
    }
    /// Whether the arguments, 2d numbers, can be written in place.
    [[nodiscard]] bool has_arguments() const { return now_ != nullptr; }
    [[nodiscard]] S* arguments() { return values_.data(); }
    /// The same at the arguments in place.
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
    /// Selects the formula that holds at (q, v): a known one, or a new one.
    void take_branch(given_problem<V> const& what, S const& t, V const& q, V const& v) {
        for (auto const& f : known_) {
            take(f);
            f->put(t, q, v, values_);
            f->how.compute(evaluation<S>::shared, values_.data());
            if (f->is_branch_of(values_)) return;
        }
        if (known_.size() >= 64) known_.clear(); // with so many branches the next one will be new
        learn(what, t, q, v);
        now_->put(t, q, v, values_);
        now_->how.compute(evaluation<S>::shared, values_.data());
    }
    std::vector<formula> known_;
    formula now_;
    S time_{};
};

} // namespace hilger::detail
