// SPDX-License-Identifier: BSL-1.0
// The derivatives of a Lagrangian, and of a force, at one node of a step, asked for where they are needed: of small states by jets, and of
// callables that have derivatives of their own. Which second derivatives are zero, or constant, L's degrees in q and v say; nothing of the
// kind is said of a callable that compares, as another branch may be another formula. Of one that is told the time none is constant, and
// one that was zero until now may come: what a driven L compares is the time, and that is not seen. A model lists what it has.
#pragma once

#include <memory>
#include <utility>

#include "hilger/differentiation/branches.hpp"
#include "hilger/variational/nodes/given_problem.hpp"
#include "hilger/variational/nodes/node_values.hpp"

namespace hilger::detail {

template <class V>
class asked_node : public node_values<scalar_of<V>> {
protected:
    using S = scalar_of<V>;
    using s = shape<V>;
    using node_values<S>::values_, node_values<S>::places_, node_values<S>::has_branches_;

public:
    /// Computes them at (t, q, v). @returns whether the places changed
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

private:
    static constexpr std::size_t at(int k) { return static_cast<std::size_t>(k); }
    static constexpr int place(int b, int j, int k, int d) { return 2 * d + (b * d + j) * d + k; }
    void put(int first, V const& x, int d) {
        for (int k = 0; k < d; ++k) values_[at(first + k)] = s::component(x, k);
    }
    /// Which entries there are, and which of them never change.
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
    V by_q_, by_v_; ///< room
};

} // namespace hilger::detail
