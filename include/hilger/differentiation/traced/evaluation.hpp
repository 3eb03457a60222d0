// SPDX-License-Identifier: BSL-1.0
// The values of a graph's nodes, computed in rounds of equal operations: nodes of one level depend on earlier levels only, and those of one
// kind are one loop, which a compiler vectorises. Unused nodes are left out. Results are computed in parts, after their common nodes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "hilger/differentiation/traced/graph.hpp"
#include "hilger/differentiation/traced/translation.hpp"

namespace hilger::detail {

template <class S>
class evaluation {
public:
    /// Parts of the results: comparisons and nodes common to `momenta` and `forces`, each of these, and nodes for second derivatives only,
    /// which may need all others.
    enum part : int { shared, momenta, forces, seconds, parts };

    evaluation() = default;
    /// `asked` has the nodes needed in each part; comparisons belong to shared.
    evaluation(formula_graph<S> const& g, int arguments, std::array<std::vector<int>, parts> const& asked);
    /// Index of a node's value; -1 if it was not asked for.
    [[nodiscard]] int place(int node) const { return place_[static_cast<std::size_t>(node)]; }
    /// Makes room for all values, and writes the constants.
    void prepare(std::vector<S>& values) const {
        values.resize(static_cast<std::size_t>(first_) + a_.size());
        std::copy(numbers_.begin(), numbers_.end(), values.begin() + arguments_);
    }
    void compute(part which, S* values) const {
        if (translation_) {
            if (auto const function = translation_->of(which)) return function(values);
            translation_->count(*this);
        }
        for (round const& r : rounds_of(which)) {
            int const *a = a_.data() + r.first, *b = b_.data() + r.first;
            if (r.in_a_row)
                r.what->run_in_a_row(values + first_ + r.first, r.count, values + *a, r.all_a, values + *b, r.all_b);
            else
                r.what->run(values, first_ + r.first, r.count, a, b);
        }
    }

    /// Operations that are computed one after the other, or at the same time: values[out + i] from values[a[i]] and values[b[i]]. In a row
    /// the operands are contiguous, or one for all.
    struct operations {
        traced_operation<S> const* what;
        int count, out;
        int const *a, *b;
        bool in_a_row;
    };
    /// Calls use(operations) in the order of one part.
    template <class Use>
    void for_each_round(part which, Use const& use) const {
        for (round const& r : rounds_of(which))
            use(operations{r.what, r.count, first_ + r.first, a_.data() + r.first, b_.data() + r.first, r.in_a_row});
    }
    /// Indices of the results, some of them repeated.
    [[nodiscard]] std::vector<int> const& results() const { return results_; }
    /// Number of values: arguments, numbers and operations.
    [[nodiscard]] int size() const { return first_ + static_cast<int>(a_.size()); }

    /// All parts, one after the other.
    void compute_all(S* values) const {
        if (translation_)
            if (auto const function = translation_->of(parts)) return function(values);
        for (int p = 0; p < parts; ++p) compute(static_cast<part>(p), values);
    }

private:
    struct round {
        traced_operation<S> const* what;
        int count, first;
        bool in_a_row = false, all_a = false, all_b = false;
    };
    [[nodiscard]] std::span<round const> rounds_of(part which) const {
        int const begin = which == 0 ? 0 : end_of_[static_cast<std::size_t>(which) - 1], end = end_of_[static_cast<std::size_t>(which)];
        return {rounds_.data() + begin, rounds_.data() + end};
    }
    /// Operations with contiguous operands, or one for all of them.
    struct row {
        std::vector<int> nodes;
        int a, b, step_a = 0, step_b = 0;
        [[nodiscard]] bool goes_on_with(int x, int y) const {
            int const n = static_cast<int>(nodes.size()), by_x = x - a, by_y = y - b;
            if (n == 1) return 0 <= by_x and by_x <= 1 and 0 <= by_y and by_y <= 1 and by_x + by_y > 0;
            return by_x == n * step_a and by_y == n * step_b;
        }
    };
    struct ordered {
        int part, level;
        traced_operation<S> const* what;
        int node;
    };
    static std::vector<ordered> order_of(formula_graph<S> const& g, std::vector<std::uint8_t> const& of);
    /// Adds the rounds for operations of one kind on one level: one for each long row, and one for all others.
    void add_rounds(formula_graph<S> const& g, traced_operation<S> const& what, std::vector<int> nodes);
    int arguments_ = 0, first_ = 0;
    std::vector<S> numbers_;
    std::vector<round> rounds_;
    std::vector<int> a_, b_, place_, results_;
    std::array<int, parts> end_of_{};
    std::shared_ptr<translation<S>> translation_; ///< if a translator is installed
};

/// Operations ordered by parts, levels and kinds. `of` has a bit for each part that needs a node.
template <class S>
auto evaluation<S>::order_of(formula_graph<S> const& g, std::vector<std::uint8_t> const& of) -> std::vector<ordered> {
    std::vector<ordered> order;
    std::vector<int> level(of.size(), 0), in(of.size(), 0);
    for (int k = 0; k < g.size(); ++k) {
        auto const at = static_cast<std::size_t>(k);
        auto const& node = g[k];
        if (node.what == nullptr or of[at] == 0) continue;
        bool const m = of[at] >> momenta & 1, f = of[at] >> forces & 1;
        in[at] = (of[at] >> shared & 1) or (m and f) ? shared : m ? momenta : f ? forces : seconds;
        for (int const x : {node.a, node.b})
            if (auto const from = static_cast<std::size_t>(x); g[x].what != nullptr and in[from] == in[at])
                level[at] = std::max(level[at], level[from] + 1);
        order.push_back({in[at], level[at], node.what, k});
    }
    std::stable_sort(order.begin(), order.end(), [](ordered const& x, ordered const& y) {
        if (x.part != y.part) return x.part < y.part;
        if (x.level != y.level) return x.level < y.level;
        return std::less<>()(x.what, y.what);
    });
    return order;
}
template <class S>
evaluation<S>::evaluation(formula_graph<S> const& g, int arguments, std::array<std::vector<int>, parts> const& asked)
    : arguments_(arguments) {
    auto const n = static_cast<std::size_t>(g.size());
    std::vector<std::uint8_t> of(n, 0); // a bit for each part
    for (int p = 0; p < parts; ++p)
        for (int const k : asked[static_cast<std::size_t>(p)]) of[static_cast<std::size_t>(k)] |= static_cast<std::uint8_t>(1 << p);
    for (int k = g.size(); k-- > 0;)
        if (auto const& node = g[k]; node.what != nullptr)
            for (int const x : {node.a, node.b}) of[static_cast<std::size_t>(x)] |= of[static_cast<std::size_t>(k)];
    auto const order = order_of(g, of);
    place_.assign(n, -1);
    for (int k = 0; k < arguments; ++k) place_[static_cast<std::size_t>(k)] = k;
    for (int k = 0; k < g.size(); ++k)
        if (g.is_number(k) and of[static_cast<std::size_t>(k)] != 0) {
            place_[static_cast<std::size_t>(k)] = arguments + static_cast<int>(numbers_.size());
            numbers_.push_back(g.number(k));
        }
    first_ = arguments + static_cast<int>(numbers_.size());
    int part_of_last = 0;
    for (std::size_t first = 0; first < order.size();) {
        auto const& o = order[first];
        for (; part_of_last < o.part; ++part_of_last) end_of_[static_cast<std::size_t>(part_of_last)] = static_cast<int>(rounds_.size());
        std::vector<int> alike;
        for (; first < order.size() and order[first].part == o.part and order[first].level == o.level and order[first].what == o.what;
             ++first)
            alike.push_back(order[first].node);
        add_rounds(g, *o.what, alike);
    }
    for (; part_of_last < parts; ++part_of_last) end_of_[static_cast<std::size_t>(part_of_last)] = static_cast<int>(rounds_.size());
    for (auto const& list : asked)
        for (int const k : list) results_.push_back(place_[static_cast<std::size_t>(k)]);
    if (translator<S>::installed().load(std::memory_order_acquire) != nullptr) translation_ = std::make_shared<translation<S>>();
}
template <class S>
void evaluation<S>::add_rounds(formula_graph<S> const& g, traced_operation<S> const& what, std::vector<int> nodes) {
    constexpr std::size_t worth_it = 4;
    auto const is_number = [&](int place) { return arguments_ <= place and place < first_; };
    // derivatives are made from the last operation to the first, and operands stand in the order of their places
    std::stable_sort(nodes.begin(), nodes.end(),
                     [&](int j, int k) { return std::pair(place(g[j].a), place(g[j].b)) < std::pair(place(g[k].a), place(g[k].b)); });
    std::vector<row> rows;
    std::map<std::pair<int, int>, std::size_t> next; // where a row would go on
    for (int const k : nodes) {
        int const a = place(g[k].a), b = place(g[k].b);
        auto const found = next.find({a, b});
        if (found != next.end() and rows[found->second].goes_on_with(a, b)) {
            std::size_t const at = found->second;
            auto& r = rows[at];
            if (r.nodes.size() == 1) {
                r.step_a = a - r.a;
                r.step_b = b - r.b;
            }
            r.nodes.push_back(k);
            next.erase(found);
            next[{a + r.step_a, b + r.step_b}] = at;
            continue;
        }
        // One value with several numbers is no row: the next value has the same ones, which are adjacent by chance.
        next[{a + 1, b + 1}] = rows.size();
        if (not is_number(a)) next[{a + 1, b}] = rows.size();
        if (not is_number(b)) next[{a, b + 1}] = rows.size();
        rows.push_back({{k}, a, b});
    }
    auto const put = [&](int k) {
        place_[static_cast<std::size_t>(k)] = first_ + static_cast<int>(a_.size());
        a_.push_back(place(g[k].a));
        b_.push_back(place(g[k].b));
    };
    int const before = static_cast<int>(a_.size());
    for (auto const& r : rows)
        if (r.nodes.size() < worth_it)
            for (int const k : r.nodes) put(k);
    if (int const others = static_cast<int>(a_.size()) - before; others > 0) rounds_.push_back({&what, others, before});
    for (auto const& r : rows) {
        if (r.nodes.size() < worth_it) continue;
        rounds_.push_back({&what, static_cast<int>(r.nodes.size()), static_cast<int>(a_.size()), true, r.step_a == 0, r.step_b == 0});
        for (int const k : r.nodes) put(k);
    }
}

} // namespace hilger::detail
