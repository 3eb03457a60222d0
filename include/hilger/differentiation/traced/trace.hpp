// SPDX-License-Identifier: BSL-1.0
// The gradient and the second derivatives of a Lagrangian, and of a force beside it, as formulas: the callables are traced once, and the
// nonzero derivatives of their graph are evaluated.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "hilger/differentiation/traced/derivatives_of_graph.hpp"
#include "hilger/differentiation/traced/evaluation.hpp"
#include "hilger/shape.hpp"

namespace hilger::detail {

/// The blocks of second derivatives of L by q and v, row first; the rows of q include the force with its derivatives.
enum block_number : int { block_qq, block_qv, block_vq, block_vv, blocks };

/// Indices of the derivatives in an array of values.
struct derivative_places {
    struct second {
        int row, column, place;
    };
    /// Consecutive components with contiguous places.
    struct stretch {
        int component, place, count;
    };
    std::vector<int> by_q, by_v;                 ///< with the force in by_q
    std::vector<stretch> by_q_whole, by_v_whole; ///< the same in stretches; empty if they are short
    std::array<std::vector<second>, blocks> entries;
    std::array<bool, blocks> constant{}; ///< no value of the block ever changes
    void find_stretches() {
        by_q_whole = stretches_of(by_q);
        by_v_whole = stretches_of(by_v);
    }
    /// The degree in the argument of a diagonal block.
    [[nodiscard]] int degree(block_number b) const {
        auto const k = static_cast<std::size_t>(b);
        return entries[k].empty() ? 1 : constant[k] ? 2 : dependence::no_polynomial;
    }

private:
    static std::vector<stretch> stretches_of(std::vector<int> const& places) {
        constexpr std::size_t worth_it = 8;
        std::vector<stretch> made;
        for (int c = 0; c < static_cast<int>(places.size()); ++c) {
            int const p = places[static_cast<std::size_t>(c)];
            if (made.empty() or p != made.back().place + made.back().count) made.push_back({c, p, 0});
            ++made.back().count;
        }
        if (made.size() * worth_it > places.size()) made.clear();
        return made;
    }
};

template <class S>
struct traced_formula {
    struct guard : formula_graph<S>::guard { ///< of places
        std::uint8_t on;
    };
    derivative_places places;
    evaluation<S> how;
    std::vector<guard> guards;

    /// Writes the arguments into prepared `values`.
    template <class V>
    static void put(S const& t, V const& q, V const& v, std::vector<S>& values) {
        int const d = shape<V>::dimension(q);
        values[static_cast<std::size_t>(2 * d)] = t;
        for (int k = 0; k < d; ++k) {
            values[static_cast<std::size_t>(k)] = shape<V>::component(q, k);
            values[static_cast<std::size_t>(d + k)] = shape<V>::component(v, k);
        }
    }
    /// Whether all comparisons come out as in the trace, for values with their shared part computed.
    [[nodiscard]] bool is_branch_of(std::vector<S> const& values) const {
        for (auto const& g : guards)
            if (holds(g.how, values[static_cast<std::size_t>(g.a)], values[static_cast<std::size_t>(g.b)]) != g.outcome) return false;
        return true;
    }
    /// Reports the comparisons to observers. Those of the time alone, which is known before the step, lead to no other branch.
    void tell_branches() const {
        for (auto const& g : guards)
            if (g.on & (on_position | on_velocity)) compared(g.outcome, (g.on & on_velocity) != 0);
    }
};
/// Cache of the formulas without branches of one callable, one for each scalar: for callables made at run time and stepped repeatedly.
/// Copies of the callable share it; it is thread-safe.
class kept_formulas {
public:
    /// The cached formula, or that of `make`.
    template <class S, class Make>
    std::shared_ptr<traced_formula<S> const> of(Make const& make) {
        std::lock_guard const lock(changes_);
        int const now = translator<S>::generation();
        for (auto const& one : all_)
            if (one.scalar == &kind<S> and one.generation == now) return std::static_pointer_cast<traced_formula<S> const>(one.formula);
        auto const made = std::make_shared<traced_formula<S> const>(make());
        std::erase_if(all_, [](auto const& one) { return one.scalar == &kind<S>; });
        if (made->guards.empty()) all_.push_back({&kind<S>, now, made});
        return made;
    }

private:
    template <class S>
    static constexpr char kind = 0;
    std::mutex changes_;
    struct kept {
        void const* scalar;
        int generation;
        std::shared_ptr<void const> formula;
    };
    std::vector<kept> all_;
};

/// Sets the evaluation of a formula, and replaces its nodes, listed by parts in `asked`, by their places.
template <class S>
void evaluate_nodes(formula_graph<S> const& g, int d, traced_formula<S>& of, std::array<std::vector<int>, evaluation<S>::parts> asked) {
    for (auto const& w : g.guards()) // also of those that no derivative depends on: they are what the callable would do
        for (int const node : {w.a, w.b}) asked[evaluation<S>::shared].push_back(node);
    of.how = evaluation<S>(g, g.arguments(d), asked);
    for (auto* list : {&of.places.by_q, &of.places.by_v})
        for (int& k : *list) k = of.how.place(k);
    of.places.find_stretches();
    for (auto& block : of.places.entries)
        for (auto& e : block) e.place = of.how.place(e.place);
    for (auto const& w : g.guards())
        of.guards.push_back({{w.how, of.how.place(w.a), of.how.place(w.b), w.outcome}, static_cast<std::uint8_t>(g[w.a].on | g[w.b].on)});
}

/// The derivatives of L, and of the components of a force if there is one, in their graph; second ones by the arguments in `seconds_by`.
template <class S>
traced_formula<S> derivatives_in(formula_graph<S>& g, int d, traced<S> const& L, std::vector<traced<S>> const& force,
                                 std::uint8_t seconds_by) {
    using T = traced<S>;
    differentiator<S> derive(g);
    tracing<S> const here(g);
    g.has_values = false;
    auto const n = static_cast<std::size_t>(d);
    std::vector<T> by(2 * n, T(0));
    derive.derivatives(L, on_position | on_velocity, [&](int k, T const& x) { by[static_cast<std::size_t>(k)] = x; });
    for (std::size_t k = 0; k < force.size(); ++k) by[k] = by[k] + force[k];

    traced_formula<S> made;
    std::array<std::vector<int>, evaluation<S>::parts> asked;
    auto const ask = [&](typename evaluation<S>::part p, T const& x) { return asked[static_cast<std::size_t>(p)].emplace_back(x.place()); };
    made.places.constant.fill(true);
    auto const put = [&](block_number in, int row, int column, T const& x) {
        auto const block = static_cast<std::size_t>(in);
        made.places.entries[block].push_back({row, column, ask(evaluation<S>::seconds, x)});
        if (not x.is_constant()) made.places.constant[block] = false;
    };
    auto const put_both = [&](block_number in, int j, int k, T const& x) { // of a symmetric block
        if (j < k) return;
        put(in, j, k, x);
        if (k < j) put(in, k, j, x);
    };
    for (std::size_t k = 0; k < n; ++k) made.places.by_q.push_back(ask(evaluation<S>::forces, by[k]));
    for (std::size_t k = n; k < 2 * n; ++k) made.places.by_v.push_back(ask(evaluation<S>::momenta, by[k]));
    for (int j = 0; j < d; ++j) {
        derive.derivatives(by[n + static_cast<std::size_t>(j)], seconds_by, [&](int k, T const& x) {
            if (k >= d) return put_both(block_vv, j, k - d, x);
            put(block_vq, j, k, x);
            if (force.empty()) put(block_qv, k, j, x);
        });
        if ((seconds_by & on_position) == 0) continue;
        derive.derivatives(by[static_cast<std::size_t>(j)], force.empty() ? on_position : on_position | on_velocity,
                           [&](int k, T const& x) {
                               if (k >= d) return put(block_qv, j, k - d, x);
                               if (force.empty()) return put_both(block_qq, j, k, x);
                               put(block_qq, j, k, x);
                           });
    }
    evaluate_nodes(g, d, made, std::move(asked));
    return made;
}

/// Traces evaluate(t, x, y, force), which returns L at traced t, x and y and appends the components of a force, if there is one, on the
/// branches at (t, q, v). Second derivatives are by the arguments in `seconds_by`.
template <class S, class V, class Evaluate>
traced_formula<S> trace(S const& t, V const& q, V const& v, std::uint8_t seconds_by, Evaluate const& evaluate) {
    using s = shape<V>;
    using T = traced<S>;
    int const d = s::dimension(q);
    formula_graph<S> g(d);
    T L(0);
    std::vector<T> force;
    {
        unwatched const while_tracing; // comparisons count when the formula is evaluated
        tracing<S> const here(g);
        typename s::template with<T> x, y;
        if constexpr (s::size == Eigen::Dynamic) {
            x.resize(d);
            y.resize(d);
        }
        for (int k = 0; k < d; ++k) {
            s::component(x, k) = T::at(k, s::component(q, k));
            s::component(y, k) = T::at(d + k, s::component(v, k));
        }
        L = evaluate(T::at(2 * d, t), x, y, force);
    }
    return derivatives_in(g, d, L, force, seconds_by);
}

/// A formula and its derivatives at the arguments of the trace.
template <class V>
class traced_there {
    using S = scalar_of<V>;

public:
    V by_q, by_v; ///< with a force in by_q
    traced_formula<S> formula;

    /// Arguments as for trace, without a time.
    template <class Evaluate>
    traced_there(V const& q, V const& v, std::uint8_t seconds_by, Evaluate const& evaluate)
        : by_q(zero_like(q)), by_v(zero_like(q)),
          formula(trace<S>(S(0), q, v, seconds_by,
                           [&](traced<S> const&, auto const& x, auto const& y, auto& f) { return evaluate(x, y, f); })) {
        formula.how.prepare(values_);
        formula.put(S(0), q, v, values_);
        formula.tell_branches();
        for (int p = 0; p < evaluation<S>::parts; ++p) formula.how.compute(static_cast<typename evaluation<S>::part>(p), values_.data());
        for (int k = 0; k < shape<V>::dimension(q); ++k) {
            shape<V>::component(by_q, k) = value(formula.places.by_q[static_cast<std::size_t>(k)]);
            shape<V>::component(by_v, k) = value(formula.places.by_v[static_cast<std::size_t>(k)]);
        }
    }
    /// Calls put(row, column, derivative) for the nonzero entries of a block.
    template <class Put>
    void for_each_in(block_number block, Put const& put) const {
        for (auto const& e : formula.places.entries[static_cast<std::size_t>(block)]) put(e.row, e.column, value(e.place));
    }

private:
    [[nodiscard]] S const& value(int place) const { return values_[static_cast<std::size_t>(place)]; }
    std::vector<S> values_;
};

} // namespace hilger::detail
