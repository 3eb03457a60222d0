// SPDX-License-Identifier: BSL-1.0
// Derivatives of a node of a graph as nodes of the same graph, in reverse mode. Parts shared with the formula or each other are one node.
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

    /// Calls found(k, derivative) for every argument number k, of those in `by` (depends), with a nonzero derivative of `of`.
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
            if (power const p = power_of(k); p.exponent > 1) {
                if (graph_[p.base].on & by) add(p.base, traced<S>(S(p.exponent)) * adjoint * lowered(k, p.base));
                continue;
            }
            bool const is_choice = for_each_choice(n.what, operand(n.a), operand(n.b), [&](auto const& x, bool of_negative, auto const& y) {
                for (auto const& [argument, d] : differentiator(graph_).all(y, by))
                    add(argument, of_negative ? choice_traced<true>::of(x, adjoint * d) : choice_traced<false>::of(x, adjoint * d));
            });
            if (is_choice) continue;
            auto const [a, b] = n.what->pull_back(operand(n.a), operand(n.b), traced<S>::at(k, S(0)), adjoint);
            if (graph_[n.a].on & by) add(n.a, a);
            if (graph_[n.b].on & by) add(n.b, b);
        }
        graph_.has_values = had;
    }

private:
    std::vector<std::pair<int, traced<S>>> all(traced<S> const& of, std::uint8_t by) {
        std::vector<std::pair<int, traced<S>>> list;
        derivatives(of, by, [&](int argument, traced<S> const& d) { list.emplace_back(argument, d); });
        return list;
    }
    traced<S> operand(int k) const { return graph_.is_number(k) ? traced<S>(graph_.number(k)) : traced<S>::at(k, S(0)); }
    /// Node k is base^exponent.
    struct power {
        int base, exponent;
    };
    /// For products of one node with itself, as x x x: their derivative 3 x x needs no sum, and its factor is a node already.
    power power_of(int k) {
        for (int j = static_cast<int>(powers_.size()); j <= k; ++j) {
            power now{j, 1};
            if (auto const& n = graph_[j]; n.what == &operation_object<times_traced, S>) {
                power const a = powers_[static_cast<std::size_t>(n.a)], b = powers_[static_cast<std::size_t>(n.b)];
                if (a.base == b.base and a.exponent + b.exponent < largest_exponent) now = {a.base, a.exponent + b.exponent};
            }
            powers_.push_back(now);
        }
        return powers_[static_cast<std::size_t>(k)];
    }
    /// base^(n - 1) for the node k = base^n, n > 1.
    traced<S> lowered(int k, int base) const {
        auto const n = graph_[k];
        if (n.a == base) return operand(n.b);
        if (n.b == base) return operand(n.a);
        return lowered(n.a, base) * operand(n.b);
    }
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
    static constexpr int largest_exponent = 1 << 20; ///< exact in any scalar
    formula_graph<S>& graph_;
    std::vector<power> powers_;
    std::vector<traced<S>> adjoints_;
    std::vector<bool> waiting_;
    std::priority_queue<int> open_;
};

} // namespace hilger::detail
