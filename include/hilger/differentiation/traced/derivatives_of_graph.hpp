// SPDX-License-Identifier: BSL-1.0
// Derivatives of a node of a graph as nodes of the same graph, by going backwards from it through what it depends on. What a derivative
// shares with the formula, or with another derivative, is one node.
#pragma once

#include <queue>
#include <utility>
#include <vector>

#include "hilger/differentiation/traced/functions.hpp"

namespace hilger::detail {

/// Makes derivatives in one graph.
template <class S>
class differentiator {
public:
    explicit differentiator(formula_graph<S>& g) : graph_(g) {}

    /// Calls found(k, derivative) for every argument number k, of those that `by` says (depends), by which the derivative of `of` is not
    /// zero.
    template <class Found>
    void derivatives(traced<S> const& of, std::uint8_t by, Found const& found) {
        if (of.is_constant() or (graph_[of.node].on & by) == 0) return;
        tracing<S> const here(graph_);
        bool const had = std::exchange(graph_.has_values, false);
        if (adjoints_.size() < static_cast<std::size_t>(of.node) + 1) adjoints_.resize(static_cast<std::size_t>(of.node) + 1);
        add(of.node, traced<S>(1));
        while (not open_.empty()) { // operands have smaller numbers: when a node's turn comes its adjoint is complete
            int const k = open_.top();
            open_.pop();
            auto const n = graph_[k];
            traced<S> const adjoint = std::exchange(adjoints_[static_cast<std::size_t>(k)], traced<S>());
            waiting_[static_cast<std::size_t>(k)] = false;
            if (adjoint.is(0)) continue;
            if (n.what == nullptr) {
                found(n.b, adjoint);
                continue;
            }
            auto const [a, b] = n.what->pull_back(operand(n.a), operand(n.b), traced<S>::at(k, S(0)), adjoint);
            if (graph_[n.a].on & by) add(n.a, a);
            if (graph_[n.b].on & by) add(n.b, b);
        }
        graph_.has_values = had;
    }

private:
    traced<S> operand(int k) const { return graph_.is_number(k) ? traced<S>(graph_.number(k)) : traced<S>::at(k, S(0)); }
    void add(int k, traced<S> const& part) {
        auto const at = static_cast<std::size_t>(k);
        if (waiting_.size() <= at) waiting_.resize(adjoints_.size());
        if (waiting_[at])
            adjoints_[at] = adjoints_[at] + part;
        else {
            adjoints_[at] = part;
            waiting_[at] = true;
            open_.push(k);
        }
    }
    formula_graph<S>& graph_;
    std::vector<traced<S>> adjoints_;
    std::vector<bool> waiting_;
    std::priority_queue<int> open_;
};

} // namespace hilger::detail
