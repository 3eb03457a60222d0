// SPDX-License-Identifier: BSL-1.0
// The derivatives of a Lagrangian, and of a force, at one node of a step and for any number of degrees of freedom, by formulas that are
// traced where they are first needed (differentiation/trace.hpp). A callable that compares its arguments is traced again where a
// comparison comes out differently, and one that is told the time for each time. One with derivatives of its own is asked for them.
#pragma once

#include <memory>
#include <vector>

#include "hilger/differentiation/trace.hpp"
#include "hilger/variational/problem.hpp"

namespace hilger::detail {

template <class F, class Force, class S, class V>
traced_formula<S> trace_problem(problem<F, Force> const& what, S const& t, V const& q, V const& v) {
    using T = traced<S>;
    return trace<S>(q, v, on_position | on_velocity, [&](auto const& x, auto const& y, std::vector<T>& force) {
        if constexpr (not std::same_as<Force, no_force>) put_force(at_time{what.force, t}(x, y), shape<V>::dimension(q), force);
        return as_jet<T>(at_time{what.lagrangian, t}(x, y));
    });
}

/// All derivatives at one node, where the node is.
template <class Problem, class V>
class node_derivatives {
    using S = scalar_of<V>;
    using s = shape<V>;
    using F = std::remove_cvref_t<decltype(std::declval<Problem const&>().lagrangian)>;
    using given = typename s::template with<traced<S>>;
    static constexpr bool timed =
        std::invocable<F const&, S const&, given const&, given const&> or
        (has_force<Problem> and
         std::invocable<std::remove_cvref_t<decltype(std::declval<Problem const&>().force)> const&, S const&, given const&, given const&>);

public:
    static constexpr bool own = requires(F const& f, S const& t, V const& x) { at_time{f, t}.expand(x, x); };
    static constexpr int first_order = 0, with_seconds = 1, momenta_only = 2, forces_only = 3;

    /// Computes them at (t, q, v); `which`: first_order, with_seconds, or of the first order a half. @returns whether the places changed
    bool compute(Problem const& what, S const& t, V const& q, V const& v, int which) {
        if constexpr (own) {
            tally<S>::add(work::force);
            return ask(what, t, q, v);
        } else {
            bool const is_new = now_ == nullptr;
            if (is_new) learn(what, t, q, v);
            now_->put(q, v, values_);
            return compute_here(what, t, s::dimension(q), which) or is_new;
        }
    }
    /// Whether arguments can be put where they are read from, 2d numbers, and not only given.
    [[nodiscard]] bool has_arguments() const { return now_ != nullptr; }
    [[nodiscard]] S* arguments() { return values_.data(); }
    /// The same at the arguments that are there.
    bool compute_here(Problem const& what, S const& t, int d, int which) {
        if (which != momenta_only) tally<S>::add(work::force);
        bool is_new = false;
        if constexpr (timed)
            if (not(t == time_)) {
                V const q = argument(0, d), v = argument(d, d);
                known_.clear();
                learn(what, t, q, v);
                now_->put(q, v, values_);
                is_new = true;
            }
        now_->how.compute(evaluation<S>::shared, values_.data());
        if (not now_->is_branch_of(values_)) {
            take_branch(what, t, argument(0, d), argument(d, d));
            is_new = true;
        }
        now_->tell_branches();
        if (which != forces_only) now_->how.compute(evaluation<S>::momenta, values_.data());
        if (which != momenta_only) now_->how.compute(evaluation<S>::forces, values_.data());
        if (which == with_seconds) now_->how.compute(evaluation<S>::seconds, values_.data());
        return is_new;
    }
    [[nodiscard]] derivative_places const& places() const {
        if constexpr (own)
            return own_places_;
        else
            return now_->places;
    }
    /// Whether the formula holds where comparisons come out as they did.
    [[nodiscard]] bool has_branches() const { return now_ != nullptr and not now_->guards.empty(); }
    [[nodiscard]] S const& value(int place) const { return values_[static_cast<std::size_t>(place)]; }
    [[nodiscard]] S const& by_q(int k) const { return value(places().by_q[static_cast<std::size_t>(k)]); }
    [[nodiscard]] S const& by_v(int k) const { return value(places().by_v[static_cast<std::size_t>(k)]); }

    /// to = c dL/dq, force included; to += a dL/dq + b dL/dv
    template <class X>
    void put_by_q(S const& c, X& to) const {
        S const* const x = values_.data();
        int const* const place = places().by_q.data();
        for (int k = 0, d = static_cast<int>(places().by_q.size()); k < d; ++k) to(k) = c * x[place[k]];
    }
    template <class X>
    void add_both(S const& a, S const& b, X& to) const {
        S const* const x = values_.data();
        int const *const place = places().by_q.data(), *const other = places().by_v.data();
        for (int k = 0, d = static_cast<int>(places().by_q.size()); k < d; ++k) to(k) = to(k) + a * x[place[k]] + b * x[other[k]];
    }
    /// to += c dL/dq, force included; to += c dL/dv
    template <class X>
    void add_by_q(S const& c, X& to) const {
        add(places().by_q, c, to);
    }
    template <class X>
    void add_by_v(S const& c, X& to) const {
        add(places().by_v, c, to);
    }
    /// All of them, in full.
    [[nodiscard]] node_table<V> table(int d) const {
        node_table<V> all{{s::zero(d), s::zero(d), s::zero_block(d), s::zero_block(d), s::zero_block(d), {}}, s::zero_block(d)};
        for (int k = 0; k < d; ++k) {
            s::component(all.e.by_q, k) = by_q(k);
            s::component(all.e.by_v, k) = by_v(k);
        }
        block_of<V>* const to[] = {&all.e.qq, &all.e.qv, &all.vq_, &all.e.vv};
        for (int b = 0; b < blocks; ++b)
            for (auto const& x : places().entries[static_cast<std::size_t>(b)]) s::entry(*to[b], x.row, x.column) = value(x.place);
        return all;
    }

private:
    template <class X>
    void add(std::vector<int> const& from, S const& c, X& to) const {
        S const* const x = values_.data();
        int const* const place = from.data();
        for (int k = 0, d = static_cast<int>(from.size()); k < d; ++k) to(k) = to(k) + c * x[place[k]];
    }
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
        known_.push_back(std::make_shared<traced_formula<S> const>(trace_problem(what, t, q, v)));
        take(known_.back());
    }
    /// The formula that holds at (q, v): one that is known, or a new one.
    void take_branch(Problem const& what, S const& t, V const& q, V const& v) {
        for (auto const& f : known_) {
            take(f);
            f->put(q, v, values_);
            f->how.compute(evaluation<S>::shared, values_.data());
            if (f->is_branch_of(values_)) return;
        }
        if (known_.size() >= 64) known_.clear(); // of a callable with so many branches the next one will be another one
        learn(what, t, q, v);
        now_->put(q, v, values_);
        now_->how.compute(evaluation<S>::shared, values_.data());
    }
    /// Of a callable's own derivatives all are there.
    bool ask(Problem const& what, S const& t, V const& q, V const& v) {
        auto const e = expand_at(what, t, q, v);
        int const d = s::dimension(q);
        bool const is_new = own_places_.by_q.empty();
        if (is_new) {
            int place = 0;
            for (auto* list : {&own_places_.by_q, &own_places_.by_v})
                for (int k = 0; k < d; ++k) list->push_back(place++);
            for (auto& block : own_places_.entries)
                for (int j = 0; j < d; ++j)
                    for (int k = 0; k < d; ++k) block.push_back({j, k, place++});
            values_.resize(static_cast<std::size_t>(place), S(0));
        }
        auto to = values_.begin();
        for (auto const* list : {&e.e.by_q, &e.e.by_v})
            for (int k = 0; k < d; ++k) *to++ = s::component(*list, k);
        for (auto const* block : {&e.e.qq, &e.e.qv, &e.vq_, &e.e.vv})
            for (int j = 0; j < d; ++j)
                for (int k = 0; k < d; ++k) *to++ = s::entry(*block, j, k);
        return is_new;
    }
    std::vector<formula> known_;
    formula now_;
    std::vector<S> values_;
    S time_{};
    derivative_places own_places_;
};

} // namespace hilger::detail
